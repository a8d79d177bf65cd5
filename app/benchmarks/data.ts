import { frontier, points, type Results } from '@/bench/report'
import data from '@/bench/results/results.json'
import { engineOrder, settingTitle } from './engines'
import type { FigureRow } from './plot-table'

/** What `npm run bench` has measured. Large: not for the browser. */
export const results = data as unknown as Results

type Scene = Results['scenes'][number]

export const plotName = (scene: Scene, measure: number) => `${scene.name} ${measure}`

export const plotTitle = (scene: Scene, measure: number) =>
  scene.measures.filter((other) => other.ranked).length > 1
    ? `${scene.title}: ${scene.measures[measure].name}`
    : scene.title

/** What each engine costs at each number of chips, as it comes. */
export const defaultCosts = results.pourCosts.filter(
  (row) =>
    row === results.pourCosts.find((first) => first.engine === row.engine && first.chips === row.chips),
)
export const sizes = [...new Set(results.pourCosts.map((row) => row.chips))]

/** The figures of all plots by `plotName`, best first. */
export function allFigures(): Record<string, FigureRow[]> {
  const plots = results.scenes.flatMap((scene) =>
    scene.measures.flatMap((measure, i) => (measure.ranked ? [{ scene, i }] : [])),
  )
  return Object.fromEntries(
    plots.map(({ scene, i }) => {
      const all = points(results, scene.name, i)
      const best = frontier(all)
      const rows = [...all]
        .sort((a, b) => a.error - b.error)
        .map(
          (point): FigureRow => [
            engineOrder.indexOf(point.engine),
            settingTitle(point.setting),
            Number.isFinite(point.error) ? Number(point.error.toPrecision(3)) : null,
            Number(point.cost.toPrecision(3)),
            best.includes(point) ? 1 : 0,
          ],
        )
      return [plotName(scene, i), rows]
    }),
  )
}

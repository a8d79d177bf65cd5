import { frontier, ours, points, type Results, verdicts } from '@/bench/publish/report'
import data from '@/bench/results/results.json'
import { engineOrder, settingTitle } from './engines'

const measured = data as unknown as Results

/** What `npm run bench` has measured, numbers in titles with their comma. Large: not for the browser. */
export const results: Results = {
  ...measured,
  scenes: measured.scenes.map((scene) => ({
    ...scene,
    title: scene.title.replace(/\b\d{4,}\b/g, (count) => Number(count).toLocaleString('en')),
  })),
}

type Scene = Results['scenes'][number]

export const plotName = (scene: Scene, measure: number) => `${scene.name} ${measure}`

export const plotTitle = (scene: Scene, measure: number) =>
  scene.measures.filter((other) => other.ranked).length > 1
    ? `${scene.title}: ${scene.measures[measure].name}`
    : scene.title

/** The claim, row by row, and what of it does not hold. */
export const claim = verdicts(results)
export const lost = claim.filter((verdict) => verdict.beaten.length > 0)
/** Held by rounding alone: a cheaper engine's error is the smaller one, but neither counts. */
export const ties = claim.filter(({ beaten, tied }) => beaten.length === 0 && tied.length > 0)

/** Settings of peers without a mark: those that might be exceptions, and those that cost too much to be. */
export const open = [...new Set(claim.flatMap((verdict) => verdict.open))]
export const dearer = results.missing.filter((row) => row.engine !== ours && !open.includes(row))

/** What each engine costs at each number of chips, as it comes. */
export const defaultCosts = results.pourCosts.filter(
  (row) =>
    row === results.pourCosts.find((first) => first.engine === row.engine && first.chips === row.chips),
)
export const costRow = (engine: string, chips: number) =>
  defaultCosts.find((row) => row.engine === engine && row.chips === chips)

export const sizes = [...new Set(results.pourCosts.map((row) => row.chips))]

/** Engine's place in `engineOrder`, setting, error (null: without bound), µs a frame, 1 on the frontier. */
export type FigureRow = [engine: number, setting: string, error: number | null, cost: number, best: 0 | 1]

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

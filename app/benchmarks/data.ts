import { frontier, points, type Results, type Verdict } from '@/bench/report'
import data from '@/bench/results/results.json'
import { figure } from '@/lib/figure'
import { engineOrder, looks, settingTitle } from './engines'
import type { FigureRow } from './plot-table'

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

/** What each engine costs at each number of chips, as it comes. */
export const defaultCosts = results.pourCosts.filter(
  (row) =>
    row === results.pourCosts.find((first) => first.engine === row.engine && first.chips === row.chips),
)
export const costRow = (engine: string, chips: number) =>
  defaultCosts.find((row) => row.engine === engine && row.chips === chips)

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

/** The columns of the claim's table. */
export const verdictHead = [
  'Scene',
  'Error',
  'µs a frame',
  'Most accurate at the same cost',
  'Cheapest at the same accuracy',
  'Frontier',
]

/** What the claim says of a scene, in words. */
export function verdictWords(verdict: Verdict) {
  const { scene, measure, cost, error, floor, asCheap, asExact, beaten, tied } = verdict
  const rival = (engine: string) => looks[engine].title
  const { unit } = scene.measures[measure]
  const timesOurs = (cheap: NonNullable<Verdict['asCheap']>) =>
    Math.max(error, cheap.error) <= floor
      ? `both below ${figure(floor)} ${unit}`
      : `${figure(cheap.factor)} × the error`
  return {
    error: `${figure(error)} ${unit}`,
    cost: figure(cost),
    asCheap: asCheap ? `${rival(asCheap.engine)}: ${timesOurs(asCheap)}` : 'none as cheap',
    asExact: asExact
      ? `${rival(asExact.engine)}: ${figure(asExact.factor)} × the cost`
      : 'none, at any setting',
    frontier:
      beaten.length > 0
        ? `not ours: ${[...new Set(beaten.map(({ engine }) => rival(engine)))].join(', ')}`
        : tied.length > 0
          ? `tie: ${rival(tied[0].engine)}`
          : 'ours',
  }
}

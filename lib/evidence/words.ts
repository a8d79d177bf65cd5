import type { Results, Verdict } from '@/bench/publish/report'
import { figure } from '../figure'
import { engineOrder, looks, settingTitle } from './engines'
import { results } from './results'

/** On what kind of machine, and in what kind of run. */
export const circumstances = [
  results.resumed ? 'in several sittings' : `in one run of ${Math.round(results.minutes)} minutes`,
  ...(results.kept > 0
    ? [
        `${Math.round(100 * results.kept)} % of the simulated runs, which come out the same each time, kept from before`,
      ]
    : []),
  ...(results.others > 0.02
    ? [`other work taking ${Math.round(100 * results.others)} % of the machine meanwhile`]
    : []),
].join(', ')

const named = ({ engine, setting }: { engine: string; setting: Record<string, number> }) =>
  `${looks[engine].title} at ${settingTitle(setting)}`

/** Who lies below and to the left of us, and how far: each engine with the cheapest setting that does. */
export function exception({ scene, measure, cost, error, beaten }: Verdict) {
  const title = scene.measures.length > 1 ? `${scene.title}, ${scene.measures[measure].name}` : scene.title
  const shares = beaten
    .toSorted((a, b) => a.cost - b.cost)
    .filter((point, i, all) => all.findIndex(({ engine }) => engine === point.engine) === i)
    .map((point) => {
      const share = `${figure(point.cost / cost)} × the cost`
      return `${named(point)}: ${share}, ${figure(point.error / error)} × the error`
    })
  return `${title}. ${shares.join('; ')}.`
}

/** A row of the claim, in a sentence. */
export const rowTitle = ({ scene, measure }: Verdict) =>
  `${scene.measures[measure].name} in “${scene.title.split(',')[0]}”`

export const floorTitle = ({ scene, measure, floor }: Verdict) => {
  const { unit } = scene.measures[measure]
  return `${figure(floor)} ${unit === 'weights' ? 'of the pile’s weight' : unit}`
}

export const listed = (parts: string[]) => new Intl.ListFormat('en').format(parts)

/** How far the rounds of a cost lie apart, in words; nothing where no cost has a second round. */
export const spreads = (() => {
  // Where a scene has seeds its rounds differ by more than noise.
  const seeded = results.scenes.filter(({ seeds }) => seeds > 1).map(({ name }) => name)
  const all = [...results.sceneCosts.filter(({ scene }) => !seeded.includes(scene)), ...results.pourCosts]
    .flatMap(({ spread, rounds }) => (spread && rounds > 1 ? [spread - 1] : []))
    .toSorted((a, b) => a - b)
  if (all.length === 0) return ''
  const [half, most] = [0.5, 0.95].map((share) => (100 * all[Math.floor(share * all.length)]).toFixed(0))
  return `: the slowest round took at most ${half}\u00a0% longer than the fastest in half of the cases, at most ${most}\u00a0% in 95 of 100`
})()

export const capital = (words: string) => words[0].toUpperCase() + words.slice(1)

export const inWords = (count: number) => numbers[count] ?? String(count)
const numbers = [
  'no',
  'one',
  'two',
  'three',
  'four',
  'five',
  'six',
  'seven',
  'eight',
  'nine',
  'ten',
  'eleven',
  'twelve',
]

/** How many settings of whom, scene by scene. */
export const settingsByEngine = (rows: Results['missing']) =>
  results.scenes.flatMap(({ name, title }) => {
    const here = rows.filter((row) => row.scene === name)
    const engines = engineOrder.flatMap((engine) => {
      const count = here.filter((row) => row.engine === engine).length
      return count > 0 ? [`${inWords(count)} of ${looks[engine].title}`] : []
    })
    return engines.length > 0 ? [[title, listed(engines)]] : []
  })

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

import fuzz from '@/bench/fuzz/accepted.json'
import { ours } from '@/bench/publish/report'
import measured from '@/bench/results/stability.json'
import { scenes } from '@/scenes'
import { checks } from '@/scenes/fuzzed'
import { type HardFigures, hardScenes, named } from '@/scenes/hard'
import { shortFigure } from '../figure'
import { results } from './results'

export type Row = { measure: string; value: number; unit: string; bound?: number; late?: number }
export type SceneRows = { title: string; rows: Row[] }

/**
 * Scenes with a known answer, as the benchmark measured them. Of a pour's seeds the target asks for the worst
 * or the median.
 */
export const knownRows = (): SceneRows[] =>
  scenes
    .filter((scene) => scene.build(1).length <= 60)
    .map(({ name, title, seconds, measures }) => {
      const { errors } = results.errors.find(
        (row) => row.engine === ours && row.scene === name && Object.keys(row.setting).length === 0,
      )!
      const rows = measures.map(({ name, unit, target }, i) => {
        // The simulation ends before what does not come to rest.
        const late = unit === 's' && errors[i]! > seconds - 0.1 ? seconds : undefined
        const value = late ? Number.POSITIVE_INFINITY : (errors[i] ?? Number.POSITIVE_INFINITY)
        return { measure: name, value, unit, bound: target, late }
      })
      return { title, rows }
    })

/** The scenes that break solvers: the worst of all seeds, as measured and held to by the tests. */
export const hardRows = (): SceneRows[] =>
  hardScenes.map(({ name, title }) => {
    const rows = measured
      .filter(({ scene }) => scene === name)
      .map(({ figure, value, bound }) => ({
        ...named(figure as keyof HardFigures),
        value: value ?? Number.POSITIVE_INFINITY,
        bound,
      }))
    return { title, rows }
  })

/** What a cell says, for the page and its Markdown alike. */
export function cellsOf({ value, unit, bound, late }: Row) {
  const missed = bound !== undefined && !(value <= bound)
  return {
    figure: late ? `not in ${late} s` : shortFigure(value, unit),
    bound: bound === undefined ? '–' : shortFigure(bound, unit),
    missed,
  }
}

/** Misses in 100,000 scenes, from a run that takes too long to repeat with each change. */
const longRun: Partial<Record<string, number>> = { asleep: 6, recovery: 2, hanging: 1 }

/**
 * Rows of the checks of random scenes: what has to hold, misses of the first 2,000 scenes, and of 100,000.
 */
export function fuzzRows() {
  const asked: Partial<Record<string, number>> = fuzz.asked
  const misses: Partial<Record<string, number>> = fuzz.misses
  return Object.entries(checks).map(
    ([check, says]) =>
      [
        says,
        `${misses[check] ?? 0} of ${asked[check]?.toLocaleString('en-US')}`,
        `${longRun[check] ?? 0}`,
      ] as const,
  )
}

export const fuzzHead = ['What has to hold', 'Misses in 2,000', 'Misses in 100,000']

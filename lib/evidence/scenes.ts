import fuzz from '@/bench/fuzz/accepted.json'
import { ours } from '@/bench/publish/report'
import longRun from '@/bench/results/fuzz.json'
import slides from '@/bench/results/slides.json'
import measured from '@/bench/results/stability.json'
import { scenes } from '@/scenes'
import { checks } from '@/scenes/fuzzed'
import { type HardFigures, hardScenes, named } from '@/scenes/hard'
import { shortFigure } from '../figure'
import { looks } from './engines'
import { results } from './results'
import { capital, inWords, listed } from './words'

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

const comma = (count: number) => count.toLocaleString('en-US')

/**
 * Rows of the checks of random scenes: what has to hold, misses of the first 2,000 scenes, which each change
 * plays, and of the long run, which takes too long to repeat with each change.
 */
export function fuzzRows() {
  const asked: Partial<Record<string, number>> = fuzz.asked
  const misses: Partial<Record<string, number>> = fuzz.misses
  const missesInLongRun: Partial<Record<string, number>> = longRun.misses
  return Object.entries(checks).map(
    ([check, says]) =>
      [
        says,
        `${misses[check] ?? 0} of ${comma(asked[check] ?? 0)}`,
        `${missesInLongRun[check] ?? 0}`,
      ] as const,
  )
}

export const fuzzHead = ['What has to hold', 'Misses in 2,000', `Misses in ${comma(longRun.scenes)}`]

/** Engine by engine how many slides over a level row with joints were slowed, as a sentence. */
export function slideWords() {
  const sum = (rows: typeof slides, key: 'slides' | 'slowed') => rows.reduce((all, row) => all + row[key], 0)
  const engines = [...new Set(slides.map(({ engine }) => engine))]
  const scenes = new Set(slides.map(({ scene }) => scene)).size
  const counts = engines.map((engine) => {
    const own = slides.filter((row) => row.engine === engine)
    const slowed = sum(own, 'slowed')
    return { engine, slowed, slides: sum(own, 'slides') }
  })
  const [{ slides: each, slowed: own }, ...others] = counts
  const peers = listed(
    others.map(({ engine, slowed }) => `${slowed} with ${looks[engine].title.split(',')[0]}`),
  )
  return `${capital(inWords(scenes))} scenes have such joints, with ${each} slides in all. Slowed by more than ${slides[0].bound} px/s are ${peers}. With this solver ${own === 1 ? 'one is' : `${inWords(own)} are`}.`
}

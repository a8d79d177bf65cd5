import { readFileSync } from 'node:fs'
import { describe, expect, it } from 'vitest'
import type { Setting } from '../engines/engine'
import { frontier, type Point, type Results, verdicts } from './report'

const point = (engine: string, cost: number, error: number): Point => ({ engine, setting: {}, cost, error })

function resultsOf(
  rows: [engine: string, knob: number | null, cost: number, error: number | null][],
): Results {
  const setting = (knob: number | null): Setting => (knob === null ? {} : { substeps: knob })
  const scene = 'slide'
  return {
    date: '',
    machine: { cpu: '', cores: 1, memoryGB: 1, system: '', node: '' },
    versions: {},
    quick: false,
    minutes: 1,
    resumed: false,
    kept: 0,
    others: 0,
    rounds: 1,
    commit: '',
    scenes: [
      {
        name: scene,
        title: 'A box slides',
        seeds: 1,
        measures: [{ name: 'error', unit: 'px', target: null, ranked: true }],
      },
    ],
    errors: rows.map(([engine, knob, , error]) => ({
      engine,
      scene,
      setting: setting(knob),
      seeds: 1,
      errors: [error],
    })),
    sceneCosts: rows.map(([engine, knob, cost]) => ({
      engine,
      scene,
      setting: setting(knob),
      cost,
      spread: 1,
      rounds: 3,
    })),
    pourCosts: [],
    missing: [],
    asleep: {},
    allocation: {},
    bytes: [],
  }
}

describe('the frontier', () => {
  it('keeps what nobody beats, from cheap to dear', () => {
    const all = [point('e', 9, 1), point('b', 2, 9), point('d', 4, 5), point('a', 1, 9), point('c', 3, 4)]
    expect(frontier(all).map(({ engine }) => engine)).toEqual(['a', 'c', 'e'])
  })

  it('has no place for an engine that lost its chips', () => {
    expect(frontier([point('a', 1, Number.POSITIVE_INFINITY)])).toEqual([])
  })
})

describe('the claim', () => {
  it('has no exception in the published benchmark, ties apart', () => {
    const published: Results = JSON.parse(
      readFileSync(new URL('../results/results.json', import.meta.url), 'utf8'),
    )
    const exceptions = verdicts(published)
      .filter(({ beaten }) => beaten.length > 0)
      .map(({ scene, measure }) => `${scene.name}, ${scene.measures[measure].name}`)
    expect(exceptions).toEqual([])
  })

  it('holds where peers are dearer or further off', () => {
    const [verdict] = verdicts(
      resultsOf([
        ['gravity-stack', 2, 4, 0.9],
        ['gravity-stack', null, 10, 0.01],
        ['planck', 4, 5, 2],
        // Five per cent more than ours is as cheap.
        ['planck', 8, 10.4, 1],
        ['planck', 16, 30, 0.5],
        ['rapier', 16, 70, 0.001],
        ['rapier', 8, 40, 0.005],
      ]),
    )
    expect(verdict).toMatchObject({ cost: 10, error: 0.01, beaten: [], tied: [] })
    expect(verdict.asCheap).toMatchObject({ engine: 'planck', error: 1, factor: 100 })
    expect(verdict.asExact).toMatchObject({ engine: 'rapier', cost: 40, factor: 4 })
  })

  it('names whoever is cheaper and more exact', () => {
    const [verdict] = verdicts(
      resultsOf([
        ['gravity-stack', null, 10, 0.01],
        ['rapier', 8, 6, 0.005],
      ]),
    )
    expect(verdict.beaten.map(({ engine }) => engine)).toEqual(['rapier'])
  })

  it('makes nothing of rounding, nor of five per cent of time', () => {
    const [exact] = verdicts(
      resultsOf([
        ['gravity-stack', null, 10, 3e-13],
        ['planck', 1, 5, 1e-14],
        ['rapier', 1, 3, 2e-14],
      ]),
    )
    expect(exact.beaten).toEqual([])
    expect(exact.tied.map(({ engine }) => engine)).toEqual(['rapier', 'planck'])
    const [close] = verdicts(
      resultsOf([
        ['gravity-stack', null, 10, 0.01],
        ['planck', 1, 9.8, 0.005],
      ]),
    )
    expect(close.beaten).toEqual([])
    expect(close.tied).toEqual([])
  })

  it('tells forces apart down to a ten-thousandth of a pile’s weight', () => {
    const results = resultsOf([
      ['gravity-stack', null, 10, 6e-4],
      ['rapier', 4, 6, 2e-5],
    ])
    results.scenes[0].measures[0].unit = 'weights'
    expect(verdicts(results)[0].beaten.map(({ engine }) => engine)).toEqual(['rapier'])
    expect(verdicts(results)[0].tied).toEqual([])
    results.errors[0].errors = [9e-5]
    expect(verdicts(results)[0]).toMatchObject({ beaten: [], tied: [{ engine: 'rapier' }], floor: 1e-4 })
    results.errors[0].errors = [1e-5]
    expect(verdicts(results)[0]).toMatchObject({ beaten: [], tied: [] })
  })

  it('leaves open what was not played, unless it is known to cost more', () => {
    const results = resultsOf([['gravity-stack', null, 10, 0.01]])
    const left = { scene: 'slide', reason: 'no time was left' }
    results.missing = [
      { ...left, engine: 'planck', setting: { steps: 1 } },
      { ...left, engine: 'planck', setting: { steps: 2 }, atLeast: 9 },
      { ...left, engine: 'planck', setting: { steps: 4 }, atLeast: 9.6 },
      { ...left, engine: 'planck', setting: { steps: 1 }, scene: 'roll' },
      { ...left, engine: 'gravity-stack', setting: { substeps: 2 } },
    ]
    expect(verdicts(results)[0].open.map(({ setting }) => setting.steps)).toEqual([1, 2])
  })

  it('is made of each scene by what was measured on it', () => {
    const results = resultsOf([
      ['gravity-stack', null, 10, 0.01],
      ['planck', 1, 20, 0.005],
    ])
    results.errors.push({ ...results.errors[1], scene: 'roll', errors: [1e-4] })
    results.sceneCosts.push({ ...results.sceneCosts[1], scene: 'roll', cost: 1 })
    // One that was simulated and never timed has no place.
    results.errors.push({ ...results.errors[1], engine: 'rapier', errors: [1e-4] })
    expect(verdicts(results)[0]).toMatchObject({ beaten: [], asCheap: null, asExact: { factor: 2 } })
  })

  it('counts an engine that lost its chips as neither cheap nor exact', () => {
    const [verdict] = verdicts(
      resultsOf([
        ['gravity-stack', null, 10, 0.01],
        ['planck', 1, 1, null],
      ]),
    )
    expect(verdict.asCheap).toBeNull()
    expect(verdict.asExact).toBeNull()
  })
})

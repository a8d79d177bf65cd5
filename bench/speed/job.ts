import type { Kind } from '../../scenes/piles'
import { median } from '../accuracy/trajectory'
import type { Setting } from '../engines/engine'

export type Job =
  | { kind: 'errors'; engine: string; scene: string; settings: Setting[]; seeds: number }
  | {
      kind: 'scene cost'
      engine: string
      scene: string
      settings: Setting[]
      seed: number
      /** ms after which each setting is given up, null where it is waited for */
      patience: (number | null)[]
    }
  | {
      kind: 'pour cost'
      engine: string
      setting: Setting
      chips: number
      shape: Kind
      seeds: number
      /** ms of processor before anything is timed */
      warmUp: number
      /** ms after which it is given up */
      patience: number
    }
  | { kind: 'asleep'; engine: string; setting: Setting; chips: number }
  | { kind: 'allocation'; engine: string; setting: Setting; chips: number }

/** Microseconds per frame. */
export type Cost = {
  mean: number
  /** the first 1.5 s, in which everything falls and lands */
  pour: number
  /** the fourth second, all awake */
  settled: number
  p50: number
  p95: number
  worst: number
}

/** Microseconds per frame that a run costs at least: it was given up. */
export type AtLeast = { atLeast: number }

/** The median of each figure. */
export function medianCost(costs: Cost[]): Cost {
  const of = (key: keyof Cost) => median(costs.map((cost) => cost[key]))
  return {
    mean: of('mean'),
    pour: of('pour'),
    settled: of('settled'),
    p50: of('p50'),
    p95: of('p95'),
    worst: of('worst'),
  }
}

/** How many pours of so many chips are timed: a few chips are poured quickly, and each time otherwise. */
export const pourSeeds = (chips: number) => (chips < 60 ? 6 : chips < 250 ? 3 : 1)

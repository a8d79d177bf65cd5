// The shape of bench/results/results.json, and what can be read off it.

import type { Setting } from '../engines/engine'
import type { Cost } from '../speed/job'
import type { Bytes } from './bytes'

/** null stands for an error without bound: chips flew off, or a number was not finite. */
export type ErrorRow = {
  engine: string
  setting: Setting
  scene: string
  errors: (number | null)[]
  seeds: number
}
/** How many rounds a cost is the median of, and the largest over the smallest of them, null for one round. */
type Rounds = { rounds: number; spread: number | null }
/** Microseconds per frame of the scene. */
export type SceneCostRow = { engine: string; setting: Setting; scene: string; cost: number } & Rounds
/**
 * `cost` is null where a run was given up. Then `atLeast` is a lower bound in µs per frame, or `reason` says
 * why.
 */
export type PourCostRow = {
  engine: string
  setting: Setting
  chips: number
  cost: Cost | null
  atLeast?: number
  reason?: string
} & Rounds
/**
 * A setting without a place on a scene's plot, the reason, and its least cost in µs per frame where known.
 */
export type MissingRow = {
  engine: string
  setting: Setting
  scene: string
  reason: string
  atLeast?: number
}

type SceneHead = {
  name: string
  title: string
  seeds: number
  measures: { name: string; unit: string; target: number | null; ranked: boolean }[]
}

export type Results = {
  date: string
  machine: { cpu: string; cores: number; memoryGB: number; system: string; node: string }
  versions: Record<string, string>
  quick: boolean
  /**
   * Minutes of the last sitting, whether others came before it, and the share of the processors others had.
   */
  minutes: number
  resumed: boolean
  /** share of the simulations, from which errors are read, that were done in earlier runs */
  kept: number
  others: number
  /** times that costs were measured at most: peers that took long, and what had no time left, less often */
  rounds: number
  /** the state of this repository */
  commit: string
  scenes: SceneHead[]
  errors: ErrorRow[]
  sceneCosts: SceneCostRow[]
  pourCosts: PourCostRow[]
  missing: MissingRow[]
  /** µs per frame of 60 chips once the engine sleeps */
  asleep: Record<string, number | null>
  /** bytes of JavaScript heap per frame, 60 chips awake */
  allocation: Record<string, number | null>
  bytes: Bytes[]
}

export const ours = 'gravity-stack'

/** One setting of one engine on one scene: its place on the plot. */
export type Point = { engine: string; setting: Setting; cost: number; error: number }

const key = (row: { engine: string; scene: string; setting: Setting }) =>
  `${row.engine} ${row.scene} ${JSON.stringify(row.setting)}`

/** Every setting of every engine that has both a cost and an error on this measure of this scene. */
export function points(results: Results, scene: string, measure: number): Point[] {
  const costs = new Map(results.sceneCosts.map((row) => [key(row), row.cost]))
  return results.errors
    .filter((row) => row.scene === scene && costs.has(key(row)))
    .map((row) => ({
      engine: row.engine,
      setting: row.setting,
      cost: costs.get(key(row)) as number,
      error: row.errors[measure] ?? Number.POSITIVE_INFINITY,
    }))
}

/** The points that no other point beats in both cost and error, from cheap to dear. */
export function frontier(all: Point[]): Point[] {
  const sorted = all
    .filter((point) => Number.isFinite(point.error))
    .sort((a, b) => a.cost - b.cost || a.error - b.error)
  const best: Point[] = []
  for (const point of sorted) {
    if (best.length === 0 || point.error < best[best.length - 1].error) best.push(point)
  }
  return best
}

/** Costs closer than this are a tie: the machine's own noise. */
export const noise = 1.05
/** Errors below this are rounding: who is nearer to zero there says nothing. */
export const rounding: Record<string, number> = {
  px: 1e-9,
  'px/s': 1e-9,
  rad: 1e-9,
  relative: 1e-9,
  weights: 1e-4,
}

export type Verdict = {
  scene: SceneHead
  measure: number
  /** our default setting */
  cost: number
  error: number
  /** errors below it count as none */
  floor: number
  /** the most exact peer that costs no more, and how many times our error it makes */
  asCheap: (Point & { factor: number }) | null
  /** the cheapest peer that is as exact, at any setting, and how many times our cost it takes */
  asExact: (Point & { factor: number }) | null
  /** peers that are cheaper and more exact than our default: the exceptions to the claim */
  beaten: Point[]
  /** peers that would be exceptions too, if errors below the floor counted: from cheap to dear */
  tied: Point[]
  /** peers' settings without a place here that may cost less than our default: the claim leaves them open */
  open: MissingRow[]
}

/** Scene by scene, whether any engine at any setting lies below and to the left of ours. */
export function verdicts(results: Results): Verdict[] {
  return results.scenes.flatMap((scene) =>
    scene.measures.flatMap(({ unit, ranked }, measure) => {
      if (!ranked) return []
      const all = points(results, scene.name, measure)
      const own = all.find((point) => point.engine === ours && Object.keys(point.setting).length === 0)
      if (!own) return []
      const peers = all.filter((point) => point.engine !== ours && Number.isFinite(point.error))
      const floor = rounding[unit] ?? 0
      const ownError = Math.max(own.error, floor)
      const cheap = peers
        .filter((point) => point.cost <= own.cost * noise)
        .sort((a, b) => a.error - b.error)[0]
      const cheaper = peers.filter((point) => point.cost * noise < own.cost && point.error < own.error)
      const exact = peers.filter((point) => point.error <= ownError).sort((a, b) => a.cost - b.cost)[0]
      return [
        {
          scene,
          measure,
          cost: own.cost,
          error: own.error,
          floor,
          asCheap: cheap ? { ...cheap, factor: Math.max(cheap.error, floor) / ownError } : null,
          asExact: exact ? { ...exact, factor: exact.cost / own.cost } : null,
          beaten: cheaper.filter((point) => Math.max(point.error, floor) < ownError),
          tied: own.error <= floor ? cheaper.toSorted((a, b) => a.cost - b.cost) : [],
          open: results.missing.filter(
            (row) =>
              row.scene === scene.name && row.engine !== ours && !((row.atLeast ?? 0) * noise >= own.cost),
          ),
        },
      ]
    }),
  )
}

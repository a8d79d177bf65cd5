// What is known so far of what things cost.

import { median } from '../accuracy/trajectory'
import type { Setting } from '../engines/engine'
import { ours } from '../publish/report'
import { type AtLeast, type Cost, type Job, medianCost, pourSeeds } from './job'
import { largeSize, type Plan, pourFrames, sameSetting, type Variant } from './plan'

export type SceneCostJob = Extract<Job, { kind: 'scene cost' }>
export type Timings = ReturnType<typeof openTimings>

export function openTimings({ quick, rounds, sizes, isDefault, tasks }: Plan) {
  const { outcomeOf, wasTried, failureOf } = tasks
  const allRounds = Array.from({ length: rounds }, (_, round) => round)

  // Pours

  /**
   * ms after which a pour is given up. At other settings than the default a peer gets a fifth more than ours.
   */
  function pourPatience(variant: Variant, chips: number): number {
    const own = isDefault(variant) || variant.engine === ours ? undefined : ownMean(chips)
    return own ? Math.max(1000, 100 * Math.ceil((1.2 * own * pourFrames) / 1e5)) : 24_000
  }
  const pourJob = (variant: Variant, chips: number) => ({
    kind: 'pour cost' as const,
    ...variant,
    chips,
    shape: 'pills' as const,
    seeds: quick ? 1 : pourSeeds(chips),
    warmUp: quick ? 150 : 600,
    patience: pourPatience(variant, chips),
  })
  const pourOf = (variant: Variant, chips: number, round = 0) => outcomeOf(pourJob(variant, chips), round)

  /** The cost of the largest pour with fewer chips that was tried, if any was; null when it broke down. */
  function withFewer(variant: Variant, chips: number): Cost | AtLeast | null | undefined {
    const fewer = sizes[sizes.indexOf(chips) - 1]
    if (!fewer) return undefined
    return wasTried(pourJob(variant, fewer)) ? pourOf(variant, fewer) : withFewer(variant, fewer)
  }

  /** What the rounds gave in which a pour was played to its end. */
  function roundsOf(variant: Variant, chips: number): Cost[] {
    return allRounds
      .map((round) => pourOf(variant, chips, round))
      .filter((run) => run !== null && 'mean' in run)
  }
  /** µs a frame of a pour, in the median of its rounds. */
  function meanOf(variant: Variant, chips: number) {
    const costs = roundsOf(variant, chips)
    return costs.length > 0 ? medianCost(costs).mean : undefined
  }
  function ownMean(chips: number) {
    return meanOf({ engine: ours, setting: {} }, chips)
  }

  /** µs that a frame takes with fewer chips: a lower bound with more. 0 where nothing is known. */
  function leastOf(variant: Variant, chips: number): number {
    const fewer = withFewer(variant, chips)
    if (fewer) return 'mean' in fewer ? fewer.mean : fewer.atLeast
    // Settings that few chips are not poured at are swept in a scene of their own.
    return chips > 60 ? costOf(variant.engine, 'pour-pills-60', variant.setting) || 0 : 0
  }

  /** What is known of a pour that nobody could wait for. */
  function unmeasured(variant: Variant, chips: number): { atLeast?: number; reason: string } {
    const seconds = (micros: number) => `${((micros * pourFrames) / 1e6).toFixed(1)} s`
    const own = pourOf(variant, chips)
    if (own && 'atLeast' in own) {
      return { atLeast: own.atLeast, reason: `given up after ${seconds(own.atLeast)}` }
    }
    const taken = leastOf(variant, chips)
    if (!taken || wasTried(pourJob(variant, chips))) {
      return { reason: failureOf(pourJob(variant, chips)) ?? 'failed with fewer chips' }
    }
    return { atLeast: taken, reason: `not tried: fewer chips took ${seconds(taken)}` }
  }

  // Scenes

  const sceneJobs: SceneCostJob[][] = allRounds.map(() => [])
  function sceneOutcomeOf(engine: string, scene: string, setting: Setting, round: number) {
    const job = sceneJobs[round].find((job) => job.engine === engine && job.scene === scene)
    const i = job?.settings.findIndex((other) => sameSetting(other, setting)) ?? -1
    return i < 0 ? null : (outcomeOf(job!, round)?.[i] ?? null)
  }
  function sceneCostOf(engine: string, scene: string, setting: Setting, round: number) {
    const cost = sceneOutcomeOf(engine, scene, setting, round)
    return typeof cost === 'number' ? cost : null
  }
  /** µs that a frame of a scene takes at least at a setting that was given up there. */
  function sceneLeastOf(engine: string, scene: string, setting: Setting) {
    const cost = sceneOutcomeOf(engine, scene, setting, 0)
    return cost !== null && typeof cost !== 'number' ? cost.atLeast : undefined
  }
  function roundsOfScene(engine: string, scene: string, setting: Setting) {
    return allRounds
      .map((round) => sceneCostOf(engine, scene, setting, round))
      .filter((cost) => cost !== null)
  }

  /** µs of a frame, in the median of its rounds, or at least so many; NaN where nothing is known. */
  function costOf(engine: string, scene: string, setting: Setting): number {
    const chips = largeSize({ name: scene })
    if (chips) return meanOf({ engine, setting }, chips) ?? Number.NaN
    const costs = roundsOfScene(engine, scene, setting)
    return costs.length > 0 ? median(costs) : (sceneLeastOf(engine, scene, setting) ?? Number.NaN)
  }

  return {
    pourJob,
    pourOf,
    withFewer,
    roundsOf,
    meanOf,
    ownMean,
    leastOf,
    unmeasured,
    /** Scenes are timed by these jobs; their outcome is asked for by scene and setting. */
    noteSceneJob: (job: SceneCostJob, round: number) => void sceneJobs[round].push(job),
    sceneCostOf,
    sceneLeastOf,
    roundsOfScene,
    costOf,
  }
}

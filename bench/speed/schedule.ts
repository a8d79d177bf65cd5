// What a run times, and in which order.
import type { Scene } from '../../scenes/scene'
import type { ErrorRuns } from '../accuracy/error-runs'
import type { Engine } from '../engines/engine'
import { ours } from '../publish/report'
import { enough, largeSize, type Plan, pourFrames, timedOnce, type Variant } from './plan'
import type { Player } from './tasks'
import type { SceneCostJob, Timings } from './timings'

/** ms into a run after which pours are timed once. */
const enoughPours = 1.5 * 60_000
/** µs of a pour after which more chips are tried last, with the time that is left. */
const hopeless = 35e5

export function openTimes(plan: Plan, timings: Timings, { isSimulated }: ErrorRuns) {
  const { quick, rounds, engines, scenes, sizes, isDefault, swept } = plan
  const { task, wasTried, runAll, takeTurns } = plan.tasks
  const { pourJob, pourOf, withFewer, ownMean, leastOf, noteSceneJob, sceneCostOf } = timings

  /** Fewer chips are swept as scenes of their own, more are poured only as an engine comes. */
  const isSwept = (chips: number) => !quick && (chips === 250 || chips === 1000)
  const variants = (chips: number): Variant[] =>
    engines.flatMap((engine) => {
      const settings = isSwept(chips) ? engine.settings : [engine.settings[0]]
      return settings.map((setting) => ({ engine: engine.name, setting }))
    })

  /** Whether fewer chips took so long that so many are tried last, if at all, or broke it. */
  function isHopeless(variant: Variant, chips: number) {
    const fewer = withFewer(variant, chips)
    if (fewer === undefined) return false
    return (
      fewer === null || 'atLeast' in fewer || fewer.mean * pourFrames > (quick ? hopeless / 35 : hopeless)
    )
  }

  /** A pour again and again, unless that would tell nothing. */
  const pourPlayer =
    (variant: Variant, chips: number): Player =>
    (round) => {
      if (round > 0) {
        const first = pourOf(variant, chips)
        if (!first || 'atLeast' in first) return null
        if (timedOnce(variant.engine, first.mean, pourFrames, ownMean(chips))) return null
      }
      return task(pourJob(variant, chips), round)
    }

  function sceneCostJob(engine: Engine, scene: Scene, round: number): SceneCostJob | null {
    const own = sceneCostOf(ours, scene.name, {}, 0) ?? undefined
    const frames = 60 * Math.min(6, scene.seconds)
    const settings = swept(engine).filter((setting) => {
      if (round === 0) return true
      const cost = sceneCostOf(engine.name, scene.name, setting, 0)
      return cost !== null && !timedOnce(engine.name, cost, frames, own)
    })
    if (settings.length === 0) return null
    // What is not simulated for its errors has no place on the plot: that it is dearer than we are is enough.
    const limit = own === undefined ? null : Math.ceil((3 * own * frames) / 1000)
    return {
      kind: 'scene cost',
      engine: engine.name,
      scene: scene.name,
      settings,
      seed: 1 + (round % scene.seeds),
      patience: settings.map((setting) => (isSimulated(engine, scene, setting) ? null : limit)),
    }
  }

  return {
    variants,

    /** Pours by all that are able, the slow ones once. */
    async pours(sizes: number[]) {
      for (const chips of sizes) {
        const able = variants(chips).filter((variant) => isDefault(variant) && !isHopeless(variant, chips))
        const players = able.map((variant) => pourPlayer(variant, chips))
        await takeTurns(`cost of ${chips} chips`, players, rounds, enoughPours)
      }
    },

    /** Scene by scene, the best known first, as there may be no time for all rounds of all. */
    async scenes(rounds: number[]) {
      const small = scenes.filter((scene) => !largeSize(scene))
      for (const scene of small.toSorted((a, b) => b.seeds - a.seeds)) {
        const players = engines.map(
          (engine): Player =>
            (turn) => {
              const job = sceneCostJob(engine, scene, rounds[turn])
              if (job) noteSceneJob(job, rounds[turn])
              return job && task(job, rounds[turn])
            },
        )
        await takeTurns(`cost of ${scene.name}`, players, rounds.length, enough)
      }
    },

    /** Large pours at every other setting, once, except where fewer chips already take longer than ours. */
    async otherSettings() {
      for (const chips of sizes.filter(isSwept)) {
        const own = ownMean(chips) ?? Number.POSITIVE_INFINITY
        const others = variants(chips).filter(
          (variant) => !isDefault(variant) && (variant.engine === ours || leastOf(variant, chips) <= own),
        )
        const players = engines.map(({ name }): Player => {
          const jobs = others
            .filter(({ engine }) => engine === name)
            .map((variant) => pourJob(variant, chips))
          return (turn) => (jobs[turn] ? task(jobs[turn]) : null)
        })
        const most = Math.max(...engines.map(({ settings }) => settings.length))
        await takeTurns(`cost of ${chips} chips, other settings`, players, most, enough)
      }
    },

    /** With the time that is left: how much a pour is at least where fewer chips were slow already. */
    async slowest() {
      for (const chips of sizes) {
        const untried = variants(chips)
          .filter(isDefault)
          .map((variant) => ({ fewer: withFewer(variant, chips), job: pourJob(variant, chips) }))
          .filter(({ fewer, job }) => fewer && 'mean' in fewer && !wasTried(job))
        const jobs = untried.map(({ job }) => job)
        await runAll(`cost of ${chips} chips, the slowest`, jobs, 1, enough)
      }
    },
  }
}

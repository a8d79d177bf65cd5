// What a run has found, as it is written down.
import type { Scene } from '../../scenes/scene'
import type { ErrorRuns } from '../accuracy/error-runs'
import { median } from '../accuracy/trajectory'
import type { Engine, Setting } from '../engines/engine'
import { medianCost } from '../speed/job'
import { largeSize, type Plan, sameSetting, type Variant } from '../speed/plan'
import { packageVersion } from '../speed/tasks'
import type { Timings } from '../speed/timings'
import { engineBytes } from './bytes'
import { commit, machine } from './machine'
import type { ErrorRow, MissingRow, PourCostRow, Results, SceneCostRow } from './report'

/** The median of so many costs, and how far they lie apart when there are several. */
const spreadOf = (costs: number[]) => ({
  spread: costs.length > 1 ? Math.max(...costs) / Math.min(...costs) : null,
  rounds: costs.length,
})

const isOf = (row: Variant, engine: Engine, setting: Setting) =>
  row.engine === engine.name && sameSetting(row.setting, setting)

/** `single` gives what was measured once for each engine. */
export async function collect(
  { quick, engines, scenes, sizes, swept, tasks }: Plan,
  { roundsOf, unmeasured, roundsOfScene, sceneLeastOf }: Timings,
  errorRuns: ErrorRuns,
  variants: (chips: number) => Variant[],
  single: (kind: 'asleep' | 'allocation') => Record<string, number | null>,
): Promise<Results> {
  const { outcomeOf, failureOf, kept, othersShare } = tasks

  // More seeds count more.
  const errors: ErrorRow[] = engines.flatMap((engine) =>
    scenes.flatMap((scene) =>
      engine.settings.flatMap((setting) => {
        const job = errorRuns.of(engine, scene, setting).find((job) => outcomeOf(job))
        if (!job) return []
        const row = outcomeOf(job)![job.settings.findIndex((other) => sameSetting(other, setting))]
        const values = row.map((value) => (Number.isFinite(value) ? value : null))
        return [{ engine: engine.name, setting, scene: scene.name, errors: values, seeds: job.seeds }]
      }),
    ),
  )

  const pourCosts: PourCostRow[] = sizes.flatMap((chips) =>
    variants(chips).map((variant) => {
      const costs = roundsOf(variant, chips)
      const row = { ...variant, chips, ...spreadOf(costs.map((cost) => cost.mean)) }
      return costs.length > 0
        ? { ...row, cost: medianCost(costs) }
        : { ...row, cost: null, ...unmeasured(variant, chips) }
    }),
  )
  /** The pour that a scene is, if it is one of those that are large. */
  const pourOf = (engine: Engine, scene: Scene, setting: Setting) =>
    pourCosts.find((row) => row.chips === largeSize(scene) && isOf(row, engine, setting))

  const sceneCosts: SceneCostRow[] = scenes.flatMap((scene) =>
    engines.flatMap((engine) =>
      engine.settings.flatMap((setting) => {
        const row = { engine: engine.name, setting, scene: scene.name }
        const pour = pourOf(engine, scene, setting)
        if (pour?.cost) {
          return [{ ...row, cost: pour.cost.mean, spread: pour.spread, rounds: pour.rounds }]
        }
        const costs = roundsOfScene(engine.name, scene.name, setting)
        return costs.length > 0 ? [{ ...row, cost: median(costs), ...spreadOf(costs) }] : []
      }),
    ),
  )

  /** Every setting without a place on a scene's plot, the reason, and its least cost where that is known. */
  const missing: MissingRow[] = engines.flatMap((engine) =>
    scenes.flatMap((scene) =>
      swept(engine).flatMap((setting) => {
        const isHere = (row: Variant & { scene: string }) =>
          row.scene === scene.name && isOf(row, engine, setting)
        const cost = sceneCosts.find(isHere)
        if (errors.some(isHere) && cost) return []
        const pour = pourOf(engine, scene, setting)
        const broken = errorRuns.of(engine, scene, setting).findLast((job) => failureOf(job))
        const least = sceneLeastOf(engine.name, scene.name, setting)
        const early = least && 'given up once it had taken three times as long as ours'
        const reason = (broken && failureOf(broken)) || pour?.reason || early || 'no time was left'
        const atLeast = cost?.cost ?? pour?.atLeast ?? least
        return [{ engine: engine.name, setting, scene: scene.name, reason, atLeast }]
      }),
    ),
  )

  return {
    date: new Date().toISOString(),
    machine,
    versions: Object.fromEntries(
      engines.map((engine) => [
        engine.name,
        engine.packages.map(packageVersion).join(', ') || 'this repository',
      ]),
    ),
    quick,
    minutes: Number((performance.now() / 60_000).toFixed(1)),
    resumed: kept.costs > 0,
    kept: Number((kept.errors / Math.max(1, errorRuns.taken)).toFixed(3)),
    others: Number(othersShare().toFixed(3)),
    rounds: Math.max(1, ...[...sceneCosts, ...pourCosts].map((row) => row.rounds)),
    commit: commit(),
    scenes: scenes.map(({ name, title, seeds, measures }) => ({
      name,
      title,
      seeds,
      measures: measures.map((measure) => ({
        name: measure.name,
        unit: measure.unit,
        target: measure.target ?? null,
        ranked: measure.ranked ?? true,
      })),
    })),
    errors,
    sceneCosts,
    pourCosts,
    missing,
    asleep: single('asleep'),
    allocation: single('allocation'),
    bytes: quick ? [] : await engineBytes(),
  }
}

// Which simulations, from which errors are read, the benchmark runs.
import type { Scene } from '../../scenes/scene'
import type { Engine, Setting } from '../engines/engine'
import { noise, ours } from '../publish/report'
import type { Job } from '../speed/job'
import { largeSize, type Plan, sameSetting } from '../speed/plan'
import type { Timings } from '../speed/timings'

/** Seeds from which a chaotic scene is simulated at other settings than the default. */
const fewSeeds = 3

type ErrorJob = Extract<Job, { kind: 'errors' }>
export type ErrorRuns = ReturnType<typeof openErrorRuns>

export function openErrorRuns(
  { quick, errors, engines, scenes, isDefault, tasks }: Plan,
  { meanOf, costOf }: Timings,
) {
  const { task, isKnown, failureOf, outcomeOf, runAll } = tasks

  /** The engine whose errors stand for those of this one. */
  const simulatedAs = (engine: Engine) => engines.find(({ name }) => name === engine.sameBitsAs) ?? engine

  const errorJob = (engine: Engine, scene: Scene, settings: Setting[], seeds: number): ErrorJob => ({
    kind: 'errors',
    engine: engine.name,
    scene: scene.name,
    settings,
    seeds,
  })

  /** What every run of the benchmark simulates: one seed tells all where nothing is left to chance. */
  function jobsOf(engine: Engine, scene: Scene): ErrorJob[] {
    const [first, ...others] = engine.settings
    if (quick) return [errorJob(engine, scene, [first], 1)]
    const chips = largeSize(scene)
    if (chips) {
      return engine.settings
        .filter((setting) =>
          // Without costs there is no end to what takes so long that it is brief.
          errors ? !engine.brief : meanOf({ engine: engine.name, setting }, chips) !== undefined,
        )
        .map((setting) => errorJob(engine, scene, [setting], engine.brief ? 1 : scene.seeds))
    }
    if (scene.seeds === 1) return [errorJob(engine, scene, engine.settings, 1)]
    if (!engine.brief) {
      return [errorJob(engine, scene, [first], scene.seeds), errorJob(engine, scene, others, fewSeeds)]
    }
    // Pills say how exact a slow engine can be; of other shapes two settings do, until there is time.
    const few = scene.name.startsWith('pour-pills') ? others : [engine.accurate]
    return [errorJob(engine, scene, [first], 1), errorJob(engine, scene, few, 1)]
  }

  /**
   * In the time that is left, slow engines get as many seeds and settings as others, one setting at a time.
   */
  function furtherJobsOf(engine: Engine, scene: Scene): ErrorJob[] {
    if (quick || !engine.brief || scene.seeds === 1 || largeSize(scene)) return []
    return engine.settings.map((setting, i) =>
      errorJob(engine, scene, [setting], i === 0 ? scene.seeds : fewSeeds),
    )
  }

  /** Whether a simulation may show that we are beaten: by what costs no more, here or as another build. */
  function mayBeat(job: ErrorJob) {
    const alike = engines.filter((engine) => simulatedAs(engine).name === job.engine)
    const own = noise * costOf(ours, job.scene, {})
    return job.settings.some((setting) => alike.some(({ name }) => !(costOf(name, job.scene, setting) > own)))
  }

  // Piles have every engine's mark as it comes, besides what the claim hangs on.
  const isPile = ({ scene }: ErrorJob) => scenes.some(({ name, seeds }) => name === scene && seeds > 1)
  const isMark = (job: ErrorJob) =>
    isPile(job) && !largeSize({ name: job.scene }) && isDefault({ ...job, setting: job.settings[0] })

  const takesLong = (job: ErrorJob) => Number(/^pour|pyramid|stack/.test(job.scene))

  const usual = () =>
    engines
      .filter((engine) => simulatedAs(engine) === engine)
      .flatMap((engine) => scenes.flatMap((scene) => jobsOf(engine, scene)))

  // Every engine gets its first setting more before any gets its second.
  const further = engines
    .flatMap((engine) =>
      scenes.flatMap((scene) => furtherJobsOf(engine, scene).map((job, turn) => ({ job, turn }))),
    )
    .toSorted((a, b) => a.turn - b.turn)
    .map(({ job }) => job)

  /** What has been looked for so far, by its task's key. */
  const simulated = new Map<string, ErrorJob>()

  return {
    /** What the claim hangs on. Long ones first, or the last of them has one core to itself. */
    claimed: () =>
      [...usual().filter((job) => mayBeat(job) || isMark(job)), ...further.filter(mayBeat)].toSorted(
        (a, b) => takesLong(b) - takesLong(a),
      ),
    all: () => usual().toSorted((a, b) => takesLong(a) - takesLong(b)),
    further,

    /** Whether a setting is simulated by every run, or was by an earlier one. */
    isSimulated(engine: Engine, scene: Scene, setting: Setting) {
      const has = ({ settings }: ErrorJob) => settings.some((other) => sameSetting(other, setting))
      return (
        jobsOf(simulatedAs(engine), scene).some(has) ||
        furtherJobsOf(simulatedAs(engine), scene).some((job) => has(job) && isKnown(task(job)))
      )
    },

    /**
     * Runs them with other jobs, two at a time: their outcome does not depend on the machine's other work.
     */
    async play(title: string, jobs: ErrorJob[], others: Job[], until: number) {
      await runAll(title, [...jobs, ...others], 2, until)
      // Where all settings together took too long, or one broke down, each has a process of its own.
      const alone = jobs
        .filter((job) => failureOf(job) && job.settings.length > 1)
        .flatMap((job) => job.settings.map((setting) => ({ ...job, settings: [setting] })))
      await runAll(`${title}, setting by setting`, alone, 2, until)
      for (const job of [...jobs, ...alone]) simulated.set(task(job).key, job)
    },

    /** How many simulations there are to read errors from. */
    get taken() {
      return [...simulated.values()].filter((job) => outcomeOf(job)).length
    },

    /** The simulations that were looked for of a setting in a scene, those of more seeds first. */
    of: (engine: Engine, scene: Scene, setting: Setting) =>
      [...simulated.values()]
        .filter(
          (job) =>
            job.engine === simulatedAs(engine).name &&
            job.scene === scene.name &&
            job.settings.some((other) => sameSetting(other, setting)),
        )
        .toSorted((a, b) => b.seeds - a.seeds),
  }
}

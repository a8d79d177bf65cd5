// Which films, from which errors are read, a run takes.
import type { Scene } from '../../scenes/scene'
import type { Engine, Setting } from '../engines/engine'
import { noise, ours } from '../publish/report'
import type { Job } from '../speed/job'
import { type Contest, largeSize, sameSetting } from '../speed/plan'
import type { Ledger } from '../speed/timings'

/** Seeds from which a chaotic scene is filmed at other settings than the default. */
const fewSeeds = 3

type ErrorJob = Extract<Job, { kind: 'errors' }>
export type Films = ReturnType<typeof openFilms>

export function openFilms(
  { quick, errors, engines, scenes, isDefault, tasks }: Contest,
  { meanOf, costOf }: Ledger,
) {
  const { task, isKnown, failureOf, outcomeOf, runAll } = tasks

  /** The engine whose films stand for those of this one. */
  const filmedAs = (engine: Engine) => engines.find(({ name }) => name === engine.sameBitsAs) ?? engine

  const filmJob = (engine: Engine, scene: Scene, settings: Setting[], seeds: number): ErrorJob => ({
    kind: 'errors',
    engine: engine.name,
    scene: scene.name,
    settings,
    seeds,
  })

  /** What every run films: one seed tells all where nothing is left to chance. */
  function filmsOf(engine: Engine, scene: Scene): ErrorJob[] {
    const [first, ...others] = engine.settings
    if (quick) return [filmJob(engine, scene, [first], 1)]
    const chips = largeSize(scene)
    if (chips) {
      return engine.settings
        .filter((setting) =>
          // Without costs there is no end to what takes so long that it is brief.
          errors ? !engine.brief : meanOf({ engine: engine.name, setting }, chips) !== undefined,
        )
        .map((setting) => filmJob(engine, scene, [setting], engine.brief ? 1 : scene.seeds))
    }
    if (scene.seeds === 1) return [filmJob(engine, scene, engine.settings, 1)]
    if (!engine.brief) {
      return [filmJob(engine, scene, [first], scene.seeds), filmJob(engine, scene, others, fewSeeds)]
    }
    // Pills say how exact a slow engine can be; of other shapes two settings do, until there is time.
    const few = scene.name.startsWith('pour-pills') ? others : [engine.accurate]
    return [filmJob(engine, scene, [first], 1), filmJob(engine, scene, few, 1)]
  }

  /** With the time that is left: a brief engine from as many seeds, and at as many settings, as the others; one setting at a time. */
  function furtherFilmsOf(engine: Engine, scene: Scene): ErrorJob[] {
    if (quick || !engine.brief || scene.seeds === 1 || largeSize(scene)) return []
    return engine.settings.map((setting, i) =>
      filmJob(engine, scene, [setting], i === 0 ? scene.seeds : fewSeeds),
    )
  }

  /** Whether a film may show that we are beaten: by what costs no more, here or as another build. */
  function mayBeat(job: ErrorJob) {
    const alike = engines.filter((engine) => filmedAs(engine).name === job.engine)
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
      .filter((engine) => filmedAs(engine) === engine)
      .flatMap((engine) => scenes.flatMap((scene) => filmsOf(engine, scene)))

  // Every engine gets its first setting more before any gets its second.
  const further = engines
    .flatMap((engine) =>
      scenes.flatMap((scene) => furtherFilmsOf(engine, scene).map((job, turn) => ({ job, turn }))),
    )
    .toSorted((a, b) => a.turn - b.turn)
    .map(({ job }) => job)

  /** What has been looked for so far, by its task's key. */
  const filmed = new Map<string, ErrorJob>()

  return {
    /** What the claim hangs on. Long ones first, or the last of them has one core to itself. */
    claimed: () =>
      [...usual().filter((job) => mayBeat(job) || isMark(job)), ...further.filter(mayBeat)].toSorted(
        (a, b) => takesLong(b) - takesLong(a),
      ),
    all: () => usual().toSorted((a, b) => takesLong(a) - takesLong(b)),
    further,

    /** Whether a setting is filmed by every run, or was by an earlier one. */
    isFilmed(engine: Engine, scene: Scene, setting: Setting) {
      const has = ({ settings }: ErrorJob) => settings.some((other) => sameSetting(other, setting))
      return (
        filmsOf(filmedAs(engine), scene).some(has) ||
        furtherFilmsOf(filmedAs(engine), scene).some((job) => has(job) && isKnown(task(job)))
      )
    },

    /** Films with others, two at a time: what comes of them does not depend on what else the machine does. */
    async film(title: string, jobs: ErrorJob[], others: Job[], until: number) {
      await runAll(title, [...jobs, ...others], 2, until)
      // Where all settings together took too long, or one broke down, each has a process of its own.
      const alone = jobs
        .filter((job) => failureOf(job) && job.settings.length > 1)
        .flatMap((job) => job.settings.map((setting) => ({ ...job, settings: [setting] })))
      await runAll(`${title}, setting by setting`, alone, 2, until)
      for (const job of [...jobs, ...alone]) filmed.set(task(job).key, job)
    },

    /** How many films there are to read errors from. */
    get taken() {
      return [...filmed.values()].filter((job) => outcomeOf(job)).length
    },

    /** The films that were looked for of a setting in a scene, those of more seeds first. */
    of: (engine: Engine, scene: Scene, setting: Setting) =>
      [...filmed.values()]
        .filter(
          (job) =>
            job.engine === filmedAs(engine).name &&
            job.scene === scene.name &&
            job.settings.some((other) => sameSetting(other, setting)),
        )
        .toSorted((a, b) => b.seeds - a.seeds),
  }
}

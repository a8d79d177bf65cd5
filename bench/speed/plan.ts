// Who competes in this run, on what, and how often.
import { scenes } from '../../scenes'
import { describeEngine, engineNames } from '../engines'
import { type Engine, type Setting, settingName } from '../engines/engine'
import { ours } from '../publish/report'
import type { Job } from './job'
import { openTasks } from './tasks'

/**
 * ms after which only what the claim needs is begun. So a run takes less than twenty minutes; the next goes
 * on.
 */
export const enough = 18.5 * 60_000
/** frames of a pour that is timed */
export const pourFrames = 240
/**
 * µs of a run, and multiple of our cost, beyond which a peer is timed once: noise can't hide the difference.
 */
const long = 2e5
const far = 2

export type Variant = { engine: string; setting: Setting }

export const sameSetting = (a: Setting, b: Setting) => settingName(a) === settingName(b)

/** How many chips a large pile has; it costs what a pour of as many costs. */
export const largeSize = (scene: { name: string }) =>
  Number(/^pour-pills-(250|1000)$/.exec(scene.name)?.[1] ?? 0)

export const timedOnce = (engine: string, cost: number, frames: number, own: number | undefined) =>
  engine !== ours && cost * frames > long && cost > far * (own ?? 0)

/** Seconds of processor after which a job is given up, by whether it holds several simulations or one. */
const patience = (job: Job) =>
  'settings' in job && job.settings.length * ('seeds' in job ? job.seeds : 1) > 1 ? 200 : 90

type Options = {
  /** parts of scenes' names, and names of engines, with commas between; all of them where left out */
  scene?: string
  engine?: string
  quick: boolean
  /** errors alone, no costs */
  errors: boolean
  fresh: boolean
  rounds: number
  /** ms of this process's clock after which the run stops, to be taken up by another */
  deadline: number
}

export type Plan = Awaited<ReturnType<typeof openPlan>>

/** Throws where no scene or no engine is called as the options say. */
export async function openPlan(options: Options) {
  const { quick, errors, fresh, deadline } = options
  const wantedScenes = options.scene?.split(',') ?? (quick ? ['slide', 'pour-pills-60'] : undefined)
  const chosenScenes = scenes.filter(
    (scene) => !wantedScenes || wantedScenes.some((name) => scene.name.includes(name)),
  )
  const wantedEngines = options.engine?.split(',').map((name) => (name === 'ours' ? ours : name))
  const chosenEngines = engineNames.filter((name) => !wantedEngines || wantedEngines.includes(name))
  if (chosenEngines.length === 0) throw new Error(`No engine is called ${options.engine}`)
  if (chosenScenes.length === 0) throw new Error(`No scene is named like ${options.scene}`)
  const engines: Engine[] = []
  for (const name of chosenEngines) engines.push(await describeEngine(name))
  const allSizes = quick ? [12, 60] : [12, 60, 250, 1000, 4000]
  return {
    quick,
    /** errors alone */
    errors,
    rounds: quick ? 1 : options.rounds,
    deadline,
    engines,
    scenes: chosenScenes,
    /** numbers of chips that are poured */
    sizes: options.scene ? chosenScenes.map(largeSize).filter(Boolean) : allSizes,
    /** Whether all scenes are played, so that sleep and allocation are measured too. */
    allScenes: !options.scene,
    isDefault: ({ engine, setting }: Variant) =>
      engines.some(({ name, settings }) => name === engine && sameSetting(settings[0], setting)),
    /** The settings at which scenes are timed. */
    swept: ({ settings }: Engine) => (quick ? [settings[0]] : settings),
    tasks: await openTasks({ engines, fresh, forgetful: quick, deadline, patience }),
  }
}

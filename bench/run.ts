// Run time against error, for every engine, setting and scene.
//   npm run bench                     everything; takes up where an interrupted run stopped
//   npm run bench -- --quick          two scenes, each engine as it comes, under a minute, writes nothing
//   npm run bench -- --scene pour,stack --engine ours,planck
//   npm run bench -- --errors         errors alone, which are kept for the next run: they never change by themselves
//   npm run bench -- --out folder     writes there, parts too (the whole goes to bench/results)
//   npm run bench -- --minutes 5      stops after five; the next call goes on from there
//   npm run bench -- --fresh          forgets what was measured before
import { join } from 'node:path'
import { parseArgs } from 'node:util'
import { scenes } from '../scenes'
import type { Scene } from '../scenes/scene'
import { engineBytes } from './bytes'
import { type Engine, type Setting, settingName } from './engine'
import { describeEngine, engineNames } from './engines'
import { median } from './film'
import { type AtLeast, type Cost, type Job, medianCost, pourSeeds } from './job'
import { commit, machine } from './machine'
import {
  type ErrorRow,
  type MissingRow,
  noise,
  ours,
  type PourCostRow,
  type Results,
  type SceneCostRow,
} from './report'
import { root } from './run-job'
import { openTasks, type Player, packageVersion } from './tasks'
import { printResults, writeResults } from './write'

const { values: options } = parseArgs({
  options: {
    scene: { type: 'string' },
    engine: { type: 'string' },
    quick: { type: 'boolean', default: false },
    errors: { type: 'boolean', default: false },
    out: { type: 'string' },
    minutes: { type: 'string', default: 'Infinity' },
    fresh: { type: 'boolean', default: false },
    rounds: { type: 'string', default: '3' },
  },
})

const quick = options.quick
const part = Boolean(options.scene ?? options.engine)
const mostRounds = quick ? 1 : Number(options.rounds)
const wantedScenes = options.scene?.split(',') ?? (quick ? ['slide', 'pour-pills-60'] : undefined)
const chosenScenes = scenes.filter(
  (scene) => !wantedScenes || wantedScenes.some((name) => scene.name.includes(name)),
)
const wantedEngines = options.engine?.split(',').map((name) => (name === 'ours' ? ours : name))
const chosenEngines = engineNames.filter((name) => !wantedEngines || wantedEngines.includes(name))
/** How many chips a large pile has; it costs what a pour of as many costs. */
const largeSize = (scene: { name: string }) => Number(/^pour-pills-(250|1000)$/.exec(scene.name)?.[1] ?? 0)
const deadline = performance.now() + 60_000 * Number(options.minutes)
/** ms into a run after which pours are timed once. */
const enoughPours = 1.5 * 60_000
/** ms into a run after which only what the claim needs is begun: the whole stays below twenty minutes, and the next run goes on. */
const enough = 18.5 * 60_000
/** Seeds from which a chaotic scene is filmed at other settings than the default. */
const fewSeeds = 3
/** Seconds of processor after which a job is given up: of several films, which then may get a job each, or of one. */
const patience = (job: Job) =>
  'settings' in job && job.settings.length * ('seeds' in job ? job.seeds : 1) > 1 ? 200 : 90
/** µs of a run, and times our own cost, beyond which a peer is timed once: noise is not what sets it apart. */
const long = 2e5
const far = 2
const timedOnce = (engine: string, cost: number, frames: number, own: number | undefined) =>
  engine !== ours && cost * frames > long && cost > far * (own ?? 0)
/** µs of a pour after which more chips are tried last, with the time that is left. */
const hopeless = 35e5

if (chosenEngines.length === 0) throw new Error(`No engine is called ${options.engine}`)
if (chosenScenes.length === 0) throw new Error(`No scene is named like ${options.scene}`)
const engines: Engine[] = []
for (const name of chosenEngines) engines.push(await describeEngine(name))

const {
  task,
  isKnown,
  outcomeOf,
  wasTried,
  failureOf,
  runAll,
  takeTurns,
  timing,
  othersShare,
  kept,
  complete,
} = await openTasks({ engines, fresh: options.fresh, forgetful: quick, deadline, patience })

process.on('SIGINT', () => {
  console.error('\nstopped; the same command goes on from here')
  process.exit(130)
})

/** frames of a pour that is timed */
const pourFrames = 240

type Contestant = { engine: string; setting: Setting }
const allSizes = quick ? [12, 60] : [12, 60, 250, 1000, 4000]
const sizes = options.scene ? chosenScenes.map(largeSize).filter(Boolean) : allSizes
/** Fewer chips are swept as scenes of their own, more are poured only as an engine comes. */
const isSwept = (chips: number) => !quick && (chips === 250 || chips === 1000)
const contestants = (chips: number): Contestant[] =>
  engines.flatMap((engine) => {
    const settings = isSwept(chips) ? engine.settings : [engine.settings[0]]
    return settings.map((setting) => ({ engine: engine.name, setting }))
  })
/** The settings at which scenes are timed. */
const swept = ({ settings }: Engine) => (quick ? [settings[0]] : settings)
const isDefault = ({ engine, setting }: Contestant) =>
  engines.some(({ name, settings }) => name === engine && settingName(settings[0]) === settingName(setting))
/** ms after which a pour is given up: a peer's at another setting than the default once it has taken a fifth longer than ours. */
function pourPatience(contestant: Contestant, chips: number): number {
  const own = isDefault(contestant) || contestant.engine === ours ? undefined : ownMean(chips)
  return own ? Math.max(1000, 100 * Math.ceil((1.2 * own * pourFrames) / 1e5)) : 24_000
}
const pourJob = (contestant: Contestant, chips: number) => ({
  kind: 'pour cost' as const,
  ...contestant,
  chips,
  shape: 'pills' as const,
  seeds: quick ? 1 : pourSeeds(chips),
  warmUp: quick ? 150 : 600,
  patience: pourPatience(contestant, chips),
})
const pourOf = (contestant: Contestant, chips: number, round = 0) =>
  outcomeOf(pourJob(contestant, chips), round)
/** The cost of the largest pour with fewer chips that was tried, if any was; null when it broke down. */
function withFewer(contestant: Contestant, chips: number): Cost | AtLeast | null | undefined {
  const fewer = sizes[sizes.indexOf(chips) - 1]
  if (!fewer) return undefined
  return wasTried(pourJob(contestant, fewer)) ? pourOf(contestant, fewer) : withFewer(contestant, fewer)
}
/** Whether fewer chips took so long that so many are tried last, if at all, or broke it. */
function isHopeless(contestant: Contestant, chips: number) {
  const fewer = withFewer(contestant, chips)
  if (fewer === undefined) return false
  return fewer === null || 'atLeast' in fewer || fewer.mean * pourFrames > (quick ? hopeless / 35 : hopeless)
}

/** Pours by all that are able, the slow ones once. */
async function timePours(sizes: number[]) {
  for (const chips of sizes) {
    const able = contestants(chips).filter(
      (contestant) => isDefault(contestant) && !isHopeless(contestant, chips),
    )
    const players = able.map((contestant) => pourPlayer(contestant, chips))
    await takeTurns(`cost of ${chips} chips`, players, mostRounds, enoughPours)
  }
}

/** What the rounds gave in which a pour was played to its end. */
function roundsOf(contestant: Contestant, chips: number): Cost[] {
  const runs = Array.from({ length: mostRounds }, (_, round) => pourOf(contestant, chips, round))
  return runs.filter((run) => run !== null && 'mean' in run)
}
/** µs a frame of a pour, in the median of its rounds. */
function meanOf(contestant: Contestant, chips: number) {
  const costs = roundsOf(contestant, chips)
  return costs.length > 0 ? medianCost(costs).mean : undefined
}
function ownMean(chips: number) {
  return meanOf({ engine: ours, setting: {} }, chips)
}

/** A pour again and again, unless that would tell nothing. */
const pourPlayer =
  (contestant: Contestant, chips: number): Player =>
  (round) => {
    if (round > 0) {
      const first = pourOf(contestant, chips)
      if (!first || 'atLeast' in first) return null
      if (timedOnce(contestant.engine, first.mean, pourFrames, ownMean(chips))) return null
    }
    return task(pourJob(contestant, chips), round)
  }

type SceneCostJob = Extract<Job, { kind: 'scene cost' }>
const sceneJobs: SceneCostJob[][] = Array.from({ length: mostRounds }, () => [])
function sceneOutcomeOf(engine: string, scene: string, setting: Setting, round: number) {
  const job = sceneJobs[round].find((job) => job.engine === engine && job.scene === scene)
  const i = job?.settings.findIndex((other) => settingName(other) === settingName(setting)) ?? -1
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
/** µs of a frame, in the median of its rounds, or at least so many; NaN where nothing is known. */
function costOf(engine: string, scene: string, setting: Setting): number {
  const chips = largeSize({ name: scene })
  if (chips) return meanOf({ engine, setting }, chips) ?? Number.NaN
  const costs = roundsOfScene(engine, scene, setting)
  return costs.length > 0 ? median(costs) : (sceneLeastOf(engine, scene, setting) ?? Number.NaN)
}
function roundsOfScene(engine: string, scene: string, setting: Setting) {
  const rounds = Array.from({ length: mostRounds }, (_, round) => sceneCostOf(engine, scene, setting, round))
  return rounds.filter((cost) => cost !== null)
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
  // What is not filmed has no place on the plot: that it is dearer than we are is enough.
  const limit = own === undefined ? null : Math.ceil((3 * own * frames) / 1000)
  return {
    kind: 'scene cost',
    engine: engine.name,
    scene: scene.name,
    settings,
    seed: 1 + (round % scene.seeds),
    patience: settings.map((setting) => (isFilmed(engine, scene, setting) ? null : limit)),
  }
}

/** Scene by scene: those that everyone looks at come first, should there be no time for all rounds of all. */
async function timeScenes(rounds: number[]) {
  const small = chosenScenes.filter((scene) => !largeSize(scene))
  for (const scene of small.toSorted((a, b) => b.seeds - a.seeds)) {
    const players = engines.map(
      (engine): Player =>
        (turn) => {
          const job = sceneCostJob(engine, scene, rounds[turn])
          if (job) sceneJobs[rounds[turn]].push(job)
          return job && task(job, rounds[turn])
        },
    )
    await takeTurns(`cost of ${scene.name}`, players, rounds.length, enough)
  }
}

/** µs that a frame takes with fewer chips at a setting, and so at least with more; 0 where nothing is known. */
function leastOf(contestant: Contestant, chips: number): number {
  const fewer = withFewer(contestant, chips)
  if (fewer) return 'mean' in fewer ? fewer.mean : fewer.atLeast
  // Settings that few chips are not poured at are swept in a scene of their own.
  return chips > 60 ? costOf(contestant.engine, 'pour-pills-60', contestant.setting) || 0 : 0
}

/** Large pours at every other setting, once, but for those that take longer than ours with fewer chips already. */
async function timeSettings() {
  for (const chips of sizes.filter(isSwept)) {
    const own = ownMean(chips) ?? Number.POSITIVE_INFINITY
    const others = contestants(chips).filter(
      (contestant) =>
        !isDefault(contestant) && (contestant.engine === ours || leastOf(contestant, chips) <= own),
    )
    const players = engines.map(({ name }): Player => {
      const jobs = others
        .filter(({ engine }) => engine === name)
        .map((contestant) => pourJob(contestant, chips))
      return (turn) => (jobs[turn] ? task(jobs[turn]) : null)
    })
    const most = Math.max(...engines.map(({ settings }) => settings.length))
    await takeTurns(`cost of ${chips} chips, other settings`, players, most, enough)
  }
}

/** With the time that is left: how much a pour is at least where fewer chips were slow already. */
async function timeHopeless() {
  for (const chips of sizes) {
    const untried = contestants(chips)
      .filter(isDefault)
      .map((contestant) => ({ fewer: withFewer(contestant, chips), job: pourJob(contestant, chips) }))
      .filter(({ fewer, job }) => fewer && 'mean' in fewer && !wasTried(job))
    const jobs = untried.map(({ job }) => job)
    await runAll(`cost of ${chips} chips, the slowest`, jobs, 1, enough)
  }
}

type ErrorJob = Extract<Job, { kind: 'errors' }>
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
        options.errors ? !engine.brief : meanOf({ engine: engine.name, setting }, chips) !== undefined,
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

/** Whether a setting is filmed by every run, or was by an earlier one. */
function isFilmed(engine: Engine, scene: Scene, setting: Setting) {
  const has = ({ settings }: ErrorJob) =>
    settings.some((other) => settingName(other) === settingName(setting))
  return (
    filmsOf(filmedAs(engine), scene).some(has) ||
    furtherFilmsOf(filmedAs(engine), scene).some((job) => has(job) && isKnown(task(job)))
  )
}

/** Whether a film may show that we are beaten: by what costs no more, here or as another build. */
function mayBeat(job: ErrorJob) {
  const alike = engines.filter((engine) => filmedAs(engine).name === job.engine)
  const own = noise * costOf(ours, job.scene, {})
  return job.settings.some((setting) => alike.some(({ name }) => !(costOf(name, job.scene, setting) > own)))
}

/** What has been looked for so far, by its task's key. */
const filmed = new Map<string, ErrorJob>()

/** Films with others, two at a time: what comes of them does not depend on what else the machine does. */
async function film(title: string, jobs: ErrorJob[], others: Job[], until: number) {
  await runAll(title, [...jobs, ...others], 2, until)
  // Where all settings together took too long, or one broke down, each has a process of its own.
  const alone = jobs
    .filter((job) => failureOf(job) && job.settings.length > 1)
    .flatMap((job) => job.settings.map((setting) => ({ ...job, settings: [setting] })))
  await runAll(`${title}, setting by setting`, alone, 2, until)
  for (const job of [...jobs, ...alone]) filmed.set(task(job).key, job)
}

const singles = (kind: 'asleep' | 'allocation') =>
  quick || options.scene || options.errors
    ? []
    : engines.map(({ name, settings }) => ({ kind, engine: name, setting: settings[0], chips: 60 }))

if (!options.errors) {
  await timing(async () => {
    await timePours(sizes.filter((chips) => chips <= 1000))
    await timeScenes([0])
    await timeSettings()
  })
}

const films = () =>
  engines
    .filter((engine) => filmedAs(engine) === engine)
    .flatMap((engine) => chosenScenes.flatMap((scene) => filmsOf(engine, scene)))
// Long ones first, or the last of them has one core to itself.
const takesLong = (job: ErrorJob) => Number(/^pour|pyramid|stack/.test(job.scene))
// Piles have every engine's mark as it comes, besides what the claim hangs on.
const isPile = ({ scene }: ErrorJob) => scenes.some(({ name, seeds }) => name === scene && seeds > 1)
const isMark = (job: ErrorJob) =>
  isPile(job) && !largeSize({ name: job.scene }) && isDefault({ ...job, setting: job.settings[0] })
// Every engine gets its first setting more before any gets its second.
const further = engines
  .flatMap((engine) =>
    chosenScenes.flatMap((scene) => furtherFilmsOf(engine, scene).map((job, turn) => ({ job, turn }))),
  )
  .toSorted((a, b) => a.turn - b.turn)
  .map(({ job }) => job)
const claimed = () =>
  [...films().filter((job) => mayBeat(job) || isMark(job)), ...further.filter(mayBeat)].toSorted(
    (a, b) => takesLong(b) - takesLong(a),
  )
await film('errors', claimed(), singles('allocation'), deadline)

if (!options.errors) {
  await timing(async () => {
    await timePours(sizes.filter((chips) => chips > 1000))
    await runAll('asleep', singles('asleep'), 1)
  })
  const all = films().toSorted((a, b) => takesLong(a) - takesLong(b))
  await film('errors of what costs more', all, [], enough)
  await timing(async () => {
    if (mostRounds > 1) await timeScenes(Array.from({ length: mostRounds - 1 }, (_, i) => i + 1))
    if (!quick) await timeHopeless()
  })
}

await film('errors, further', further, [], options.errors ? deadline : enough)
if (options.errors) process.exit(0)
// What later rounds have found to be no dearer after all.
await film('errors', claimed(), [], deadline)

// More seeds count more.
const errorJobs = [...filmed.values()].sort((a, b) => b.seeds - a.seeds)
const errors: ErrorRow[] = engines.flatMap((engine) =>
  chosenScenes.flatMap((scene) =>
    engine.settings.flatMap((setting) => {
      for (const job of errorJobs) {
        const rows = job.engine === filmedAs(engine).name && job.scene === scene.name && outcomeOf(job)
        const i = job.settings.findIndex((other) => settingName(other) === settingName(setting))
        if (!rows || i < 0) continue
        const values = rows[i].map((value) => (Number.isFinite(value) ? value : null))
        return [{ engine: engine.name, setting, scene: scene.name, errors: values, seeds: job.seeds }]
      }
      return []
    }),
  ),
)

/** The median of so many costs, and how far they lie apart when there are several. */
const spreadOf = (costs: number[]) => ({
  spread: costs.length > 1 ? Math.max(...costs) / Math.min(...costs) : null,
  rounds: costs.length,
})

/** What is known of a pour that nobody could wait for. */
function unmeasured(contestant: Contestant, chips: number): { atLeast?: number; reason: string } {
  const own = pourOf(contestant, chips)
  if (own && 'atLeast' in own) {
    return {
      atLeast: own.atLeast,
      reason: `given up after ${((own.atLeast * pourFrames) / 1e6).toFixed(1)} s`,
    }
  }
  const taken = leastOf(contestant, chips)
  if (!taken || wasTried(pourJob(contestant, chips))) {
    return { reason: failureOf(pourJob(contestant, chips)) ?? 'failed with fewer chips' }
  }
  return {
    atLeast: taken,
    reason: `not tried: fewer chips took ${((taken * pourFrames) / 1e6).toFixed(1)} s`,
  }
}

const pourCosts: PourCostRow[] = sizes.flatMap((chips) =>
  contestants(chips).map((contestant) => {
    const costs = roundsOf(contestant, chips)
    const row = { ...contestant, chips, ...spreadOf(costs.map((cost) => cost.mean)) }
    return costs.length > 0
      ? { ...row, cost: medianCost(costs) }
      : { ...row, cost: null, ...unmeasured(contestant, chips) }
  }),
)

const sceneCosts: SceneCostRow[] = chosenScenes.flatMap((scene) =>
  engines.flatMap((engine) =>
    engine.settings.flatMap((setting) => {
      const row = { engine: engine.name, setting, scene: scene.name }
      const pour = pourCosts.find(
        (pour) =>
          pour.chips === largeSize(scene) &&
          pour.engine === engine.name &&
          settingName(pour.setting) === settingName(setting),
      )
      if (pour?.cost) {
        return [{ ...row, cost: pour.cost.mean, spread: pour.spread, rounds: pour.rounds }]
      }
      const costs = roundsOfScene(engine.name, scene.name, setting)
      return costs.length > 0 ? [{ ...row, cost: median(costs), ...spreadOf(costs) }] : []
    }),
  ),
)

/** Every setting without a place on a scene's plot, why, and what it costs at least, where that is known. */
const missing: MissingRow[] = engines.flatMap((engine) =>
  chosenScenes.flatMap((scene) =>
    swept(engine).flatMap((setting) => {
      const isThis = (row: { engine: string; setting: Setting }) =>
        row.engine === engine.name && settingName(row.setting) === settingName(setting)
      const isHere = (row: { engine: string; scene: string; setting: Setting }) =>
        row.scene === scene.name && isThis(row)
      const filmedHere = errors.some(isHere)
      const cost = sceneCosts.find(isHere)
      if (filmedHere && cost) return []
      const pour = pourCosts.find((row) => isThis(row) && row.chips === largeSize(scene))
      const broken = errorJobs.findLast(
        (job) =>
          job.engine === filmedAs(engine).name &&
          job.scene === scene.name &&
          job.settings.some((other) => settingName(other) === settingName(setting)) &&
          failureOf(job),
      )
      const least = sceneLeastOf(engine.name, scene.name, setting)
      const early = least && 'given up once it had taken three times as long as ours'
      const reason = (broken && failureOf(broken)) || pour?.reason || early || 'no time was left'
      const atLeast = cost?.cost ?? pour?.atLeast ?? least
      return [{ engine: engine.name, setting, scene: scene.name, reason, atLeast }]
    }),
  ),
)

const single = (kind: 'asleep' | 'allocation') =>
  Object.fromEntries(singles(kind).map((job) => [job.engine, outcomeOf(job)]))

const results: Results = {
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
  kept: Number((kept.films / Math.max(1, errorJobs.filter((job) => outcomeOf(job)).length)).toFixed(3)),
  others: Number(othersShare().toFixed(3)),
  rounds: Math.max(1, ...[...sceneCosts, ...pourCosts].map((row) => row.rounds)),
  commit: commit(),
  scenes: chosenScenes.map(({ name, title, seeds, measures }) => ({
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

printResults(results, engines)
if (options.out || (!quick && !part)) {
  const folder = options.out ?? join(root, 'bench/results')
  writeResults(results, folder)
  if (!options.out) complete()
  console.log(
    `\nwritten after ${results.minutes} minutes: results.json, errors.csv and costs.csv in ${folder}`,
  )
}
process.exit(0)

// Run time against error, for every engine, setting and scene.
//   npm run bench                     everything; takes up where an interrupted run stopped
//   npm run bench -- --quick          two scenes, each engine as it comes, under a minute, writes nothing
//   npm run bench -- --scene pour,stack --engine ours,planck
//   npm run bench -- --errors         errors alone, which are kept for the next run: they never change by themselves
//   npm run bench -- --out folder     writes there, parts too (the whole goes to bench/results)
//   npm run bench -- --minutes 5      stops after five; the next call goes on from there
//   npm run bench -- --fresh          forgets what was measured before
import { createHash } from 'node:crypto'
import {
  appendFileSync,
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from 'node:fs'
import { cpus } from 'node:os'
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
  ours,
  type PourCostRow,
  type Results,
  type SceneCostRow,
  verdicts,
} from './report'
import { bundle, type Outcome, openTurns, root, runJob, spent, type Turns } from './run-job'

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
/**
 * ms into a run after which pours are not timed again, brief engines are filmed no further, and nothing else is timed again
 * or filmed: the whole stays below twenty minutes, and the next run films what is missing.
 */
const enoughPours = 1.5 * 60_000
const enoughFilms = 7 * 60_000
const enough = 17 * 60_000
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

const child = await bundle('child')
const engines: Engine[] = []
for (const name of chosenEngines) {
  try {
    engines.push(await describeEngine(name))
  } catch (error) {
    console.error(`${name} is left out: ${error instanceof Error ? error.message : error}`)
  }
}

// What an interrupted run has measured is kept until a run is complete. Errors are the same whenever they are
// computed, so they are kept for as long as nothing they depend on changes. Failures are tried again.
const cacheFolder = join(root, 'node_modules/.cache/gravity-stack-bench')
const partial = join(cacheFolder, 'partial.jsonl')
const errorCache = join(cacheFolder, 'errors.jsonl')
mkdirSync(cacheFolder, { recursive: true })
if (options.fresh) for (const file of [partial, errorCache]) rmSync(file, { force: true })

function readCache(file: string) {
  const lines = existsSync(file) ? readFileSync(file, 'utf8').split('\n') : []
  return lines.flatMap((line) => {
    try {
      return [JSON.parse(line, (_, value) => value ?? Number.POSITIVE_INFINITY) as [string, unknown]]
    } catch {
      // Nothing, or a line that was cut off when the run was.
      return []
    }
  })
}

const done = new Map([...readCache(errorCache), ...readCache(partial)])

// What an engine's figures depend on.
const judges = ['exact-distance', 'scene', 'seeded', 'references', 'residual', 'exact', 'piles']

function sourceHash(name: string) {
  const hash = createHash('sha1')
  const read = (folder: string, keep: (file: string) => boolean) => {
    for (const file of readdirSync(join(root, folder)).sort().filter(keep)) {
      hash.update(readFileSync(join(root, folder, file)))
    }
  }
  read('scenes', (file) => judges.includes(file.replace(/\.ts$/, '')))
  read('bench', (file) => file === 'film.ts')
  if (name === ours) read('registry/gravity-stack', (file) => /^[a-z]+\.ts$/.test(file))
  else read('bench/engines', (file) => file !== 'ours.ts' && file !== 'index.ts')
  return hash.digest('hex').slice(0, 12)
}

function packageVersion(name: string): string {
  return JSON.parse(readFileSync(join(root, 'node_modules', name, 'package.json'), 'utf8')).version
}

type Task = { job: Job; round: number; key: string }
const hashes = new Map(
  engines.map((engine) => [engine.name, `${sourceHash(engine.name)} ${engine.packages.map(packageVersion)}`]),
)
const stopwatch = createHash('sha1')
  .update(readFileSync(join(root, 'bench/child.ts')))
  .digest('hex')
const task = (job: Job, round = 0): Task => ({
  job,
  round,
  key: `${hashes.get(job.engine)} ${job.kind === 'errors' ? '' : stopwatch} ${round} ${JSON.stringify(job)}`,
})

const outcomes = new Map<string, unknown>()
const failures = new Map<string, string>()
let resumed = false
/** Jobs of films that an earlier run had done. */
let keptFilms = 0

process.on('SIGINT', () => {
  console.error('\nstopped; the same command goes on from here')
  process.exit(130)
})

/** Whether a task is done already, in this run or in one before. */
function isKnown({ key, job }: Task) {
  if (!outcomes.has(key) && done.has(key)) {
    outcomes.set(key, done.get(key))
    if (job.kind !== 'errors') resumed = true
    else keptFilms++
  }
  return outcomes.has(key)
}

/** Keeps what comes of a task, or that nothing does; says whether it came. */
async function keep({ key, job }: Task, work: Promise<unknown>) {
  let outcome: unknown = null
  try {
    outcome = await work
    if (outcome === null) failures.set(key, `given up after ${patience(job)} s of processor`)
  } catch (error) {
    failures.set(key, 'crashed')
    console.error(`\n${error instanceof Error ? error.message : error}`)
  }
  outcomes.set(key, outcome)
  const file = job.kind === 'errors' ? errorCache : partial
  if (!quick && outcome !== null) appendFileSync(file, `${JSON.stringify([key, outcome])}\n`)
  return outcome !== null
}

/** Says how far so many tasks are, and in the end what they took. */
function progressOf(title: string, expected: number) {
  let total = expected
  const start = performance.now()
  const before = spent.seconds
  const elapsed = () => (performance.now() - start) / 1000
  let finished = 0
  return {
    tick(job: Job) {
      finished++
      const remaining = (elapsed() / finished) * (total - finished)
      const scene = 'scene' in job ? job.scene : `${'chips' in job ? job.chips : 0} chips`
      const line = `${title} ${finished}/${total}, ${elapsed().toFixed(0)} s, ${remaining.toFixed(0)} s to go: ${job.engine}, ${scene}`
      if (process.stderr.isTTY) process.stderr.write(`\r\x1b[K${line.slice(0, 100)}`)
      else if (finished % 25 === 0) console.error(line)
    },
    skip(tasks: number) {
      total -= tasks
    },
    end() {
      if (process.stderr.isTTY) process.stderr.write('\r\x1b[K')
      const seconds = `${elapsed().toFixed(0)} s, ${(spent.seconds - before).toFixed(0)} s of processor`
      console.error(`${title}: ${finished} of ${total} in ${seconds}`)
    },
  }
}

function stopIfLate() {
  if (performance.now() < deadline) return
  console.error('call again to go on')
  process.exit(75)
}

/** Runs tasks in order, each in a process of its own, at most `workers` at once. */
async function runAll(title: string, tasks: Task[], workers: number, until = deadline) {
  const queue = tasks.filter((task) => !isKnown(task))
  if (queue.length === 0) return
  const progress = progressOf(title, queue.length)
  const worker = async () => {
    for (let next = queue.shift(); next; next = queue.shift()) {
      if (performance.now() >= until) return
      await keep(next, runJob(child, next.job, patience(next.job)))
      progress.tick(next.job)
    }
  }
  await Promise.all(Array.from({ length: workers }, worker))
  progress.end()
  if (queue.length > 0) stopIfLate()
}

/** What an engine is timed at in its turns, one after the other, or nothing when it needs no more. */
type Player = (turn: number) => Task | null

/**
 * Lets engines take turns, one at a time, each in a process that it keeps. First rounds are for all, what comes after
 * them for as long as there is time.
 */
async function takeTurns(title: string, players: Player[], until: number, turns = mostRounds) {
  const progress = progressOf(title, players.length * turns)
  const table = players.map((taskOf) => ({ taskOf, seat: undefined as Turns | undefined, out: false }))
  for (let turn = 0; turn < turns; turn++) {
    for (const player of table) {
      stopIfLate()
      if (player.out) continue
      const next = player.taskOf(turn)
      if (next && next.round > 0 && performance.now() >= until) continue
      if (!next) {
        // Who is out makes room: some hold a hundred megabytes.
        player.out = true
        player.seat?.close()
        progress.skip(turns - turn)
        continue
      }
      if (!isKnown(next)) {
        player.seat ??= openTurns(child)
        await keep(next, player.seat.take(next.job, patience(next.job)))
      }
      progress.tick(next.job)
      // What broke down may have taken its process along.
      if (outcomes.get(next.key) === null) {
        player.seat?.close()
        player.seat = undefined
      }
    }
  }
  for (const { seat } of table) seat?.close()
  progress.end()
}

const outcomeOf = <J extends Job>(job: J, round = 0) =>
  (outcomes.get(task(job, round).key) ?? null) as Outcome<J> | null

const asTasks = (jobs: Job[]) => jobs.map((job) => task(job))

// What others took of the machine is what all but the jobs took.
const busySeconds = () => {
  const times = cpus().map(({ times: { idle, ...busy } }) => ({ idle, busy: Object.values(busy) }))
  const sum = (values: number[]) => values.reduce((a, b) => a + b, 0)
  const { user, system } = process.cpuUsage()
  return {
    busy: sum(times.flatMap(({ busy }) => busy)) / 1000,
    idle: sum(times.map(({ idle }) => idle)) / 1000,
    own: spent.seconds + (user + system) / 1e6,
  }
}
const machineTime = { busy: 0, idle: 0, own: 0 }
async function timing(work: () => Promise<void>) {
  const before = busySeconds()
  await work()
  const after = busySeconds()
  for (const key of ['busy', 'idle', 'own'] as const) machineTime[key] += after[key] - before[key]
}

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
const isDefault = ({ engine, setting }: Contestant) =>
  engines.some(({ name, settings }) => name === engine && settingName(settings[0]) === settingName(setting))
/** ms after which a pour is given up: at another setting than the default once it has taken half as long again as ours. */
function pourPatience(contestant: Contestant, chips: number): number {
  const own = isDefault(contestant) ? undefined : ownMean(chips)
  return own ? Math.max(1000, 100 * Math.ceil((1.5 * own * pourFrames) / 1e5)) : 24_000
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
  return outcomes.has(task(pourJob(contestant, fewer)).key)
    ? pourOf(contestant, fewer)
    : withFewer(contestant, fewer)
}
/** Whether fewer chips took so long that so many are tried last, if at all, or broke it. */
function isHopeless(contestant: Contestant, chips: number) {
  const fewer = withFewer(contestant, chips)
  if (fewer === undefined) return false
  return fewer === null || 'atLeast' in fewer || fewer.mean * pourFrames > (quick ? hopeless / 35 : hopeless)
}

/** Pours of all sizes by all that are able, the slow ones once. */
async function timePours() {
  for (const chips of sizes) {
    const able = contestants(chips).filter(
      (contestant) => isDefault(contestant) && !isHopeless(contestant, chips),
    )
    const players = able.map((contestant) => pourPlayer(contestant, chips))
    await takeTurns(`cost of ${chips} chips`, players, enoughPours)
  }
}

/** µs a frame of a pour, if it was played to its end. */
function meanOf(contestant: Contestant, chips: number) {
  const pour = pourOf(contestant, chips)
  return pour && 'mean' in pour ? pour.mean : undefined
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

// Pours come first: whoever is given up there needs no film of as many.
if (!options.errors) await timing(timePours)

type Films = { settings: Setting[]; seeds: number }

/** Settings to film together, and from how many seeds: all as it comes, a few else. */
function filmed(engine: Engine, scene: Scene): Films[] {
  const [first, ...others] = engine.settings
  if (quick) return [{ settings: [first], seeds: 1 }]
  const large = largeSize(scene)
  if (large) {
    if (!engine.brief) return [{ settings: [first], seeds: scene.seeds }]
    return large < 1000 ? [{ settings: [first], seeds: 1 }] : []
  }
  if (scene.seeds === 1) return [{ settings: engine.settings, seeds: 1 }]
  // Pills say how exact a slow engine can be; of other shapes two settings do.
  const swept = !engine.brief || scene.name.startsWith('pour-pills') ? others : [engine.accurate]
  return [
    { settings: [first], seeds: engine.brief ? fewSeeds : scene.seeds },
    { settings: swept, seeds: engine.brief ? 1 : fewSeeds },
  ]
}

/** With the time that is left: a brief engine from as many seeds, and at as many settings, as the others; one setting at a time. */
function filmedFurther(engine: Engine, scene: Scene): Films[] {
  if (quick || !engine.brief || scene.seeds === 1 || largeSize(scene)) return []
  return engine.settings
    .map((setting, i) => ({ settings: [setting], seeds: i === 0 ? scene.seeds : fewSeeds }))
    .filter(({ seeds }) => seeds > 1)
}

const singles = (kind: 'asleep' | 'allocation') =>
  engines.map(({ name, settings }) => ({ kind, engine: name, setting: settings[0], chips: 60 }))

// Neither errors nor bytes depend on what else the machine does: two at a time, those that take longest first.
type ErrorJob = Extract<Job, { kind: 'errors' }>
const takesLong = (engine: Engine, scene: Scene) =>
  largeSize(scene) > 0 || (engine.brief && /^pour/.test(scene.name)) ? 0 : 1
/** The engine whose films stand for those of this one. */
const filmedAs = (engine: Engine) => engines.find(({ name }) => name === engine.sameBitsAs) ?? engine
const errorJob = (engine: Engine, scene: Scene, films: Films): ErrorJob => ({
  kind: 'errors',
  engine: engine.name,
  scene: scene.name,
  ...films,
})
let errorJobs: ErrorJob[] = engines
  .filter((engine) => filmedAs(engine) === engine)
  .flatMap((engine) => chosenScenes.map((scene) => ({ engine, scene })))
  .filter(({ engine, scene }) => {
    const chips = largeSize(scene)
    const contestant = { engine: engine.name, setting: engine.settings[0] }
    const pour = pourOf(contestant, chips)
    return !chips || options.errors || !(isHopeless(contestant, chips) || (pour && 'atLeast' in pour))
  })
  .sort((a, b) => takesLong(a.engine, a.scene) - takesLong(b.engine, b.scene))
  .flatMap(({ engine, scene }) => filmed(engine, scene).map((films) => errorJob(engine, scene, films)))
const measured = quick || options.scene || options.errors ? [] : singles('allocation')
await runAll('errors', asTasks([...errorJobs, ...measured]), 2)

// Where all settings together took too long, or one broke down, each has a process of its own.
const alone = errorJobs.flatMap((job) =>
  outcomeOf(job) === null && job.settings.length > 1
    ? job.settings.map((setting) => ({ ...job, settings: [setting] }))
    : [],
)
await runAll('errors, setting by setting', asTasks(alone), 2)
errorJobs = [...errorJobs, ...alone]

// Every engine gets its first setting more before any gets its second.
const further = Array.from({ length: Math.max(...engines.map(({ settings }) => settings.length)) }, (_, i) =>
  chosenScenes.flatMap((scene) =>
    engines.flatMap((engine) => {
      const films = filmedFurther(engine, scene).find(({ settings }) => settings[0] === engine.settings[i])
      return films ? [errorJob(engine, scene, films)] : []
    }),
  ),
).flat()
await runAll(
  'errors, further',
  asTasks(further),
  2,
  options.errors ? deadline : Math.min(deadline, enoughFilms),
)
// More seeds count more: they are looked up first.
errorJobs = [...further, ...errorJobs]

/** Films large piles at the settings they are poured at, the cheap first, in the time that is left. */
async function filmLarge(contestantsOf: (chips: number) => Contestant[]) {
  for (const scene of chosenScenes.filter(largeSize)) {
    const jobs = contestantsOf(largeSize(scene)).map(({ engine: name, setting }) => {
      const engine = engines.find((candidate) => candidate.name === name)!
      return errorJob(engine, scene, { settings: [setting], seeds: engine.brief ? 1 : scene.seeds })
    })
    await runAll(
      `errors of ${largeSize(scene)} chips, all settings`,
      asTasks(jobs),
      2,
      Math.min(deadline, options.errors ? deadline : enough),
    )
    errorJobs = [...errorJobs, ...jobs]
  }
}

if (options.errors) {
  // What takes so long that it is brief is filmed when it is known to cost no more than we do.
  await filmLarge((chips) =>
    contestants(chips).filter(({ engine: name }) => {
      const engine = engines.find((candidate) => candidate.name === name)!
      return !engine.brief && filmedAs(engine) === engine
    }),
  )
  process.exit(0)
}

const errorRows = (): ErrorRow[] =>
  engines.flatMap((engine) =>
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
let errors = errorRows()

type SceneCostJob = Extract<Job, { kind: 'scene cost' }>
const sceneJobs: SceneCostJob[][] = Array.from({ length: mostRounds }, () => [])
function sceneCostOf(engine: string, scene: { name: string }, setting: Setting, round: number) {
  const job = sceneJobs[round].find((job) => job.engine === engine && job.scene === scene.name)
  const i = job?.settings.findIndex((other) => settingName(other) === settingName(setting)) ?? -1
  return i < 0 ? null : (outcomeOf(job!, round)?.[i] ?? null)
}

function sceneCostJob(engine: Engine, scene: Scene, round: number): SceneCostJob | null {
  // Whoever lost its way has no place on the plot, whatever it cost.
  let settings = errors
    .filter((row) => row.engine === engine.name && row.scene === scene.name)
    .map((row) => row.setting)
  if (round > 0) {
    const own = sceneCostOf(ours, scene, {}, 0) ?? undefined
    settings = settings.filter((setting) => {
      const cost = sceneCostOf(engine.name, scene, setting, 0)
      return cost !== null && !timedOnce(engine.name, cost, 60 * Math.min(6, scene.seconds), own)
    })
  }
  if (settings.length === 0) return null
  const seed = 1 + (round % scene.seeds)
  return { kind: 'scene cost', engine: engine.name, scene: scene.name, settings, seed }
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
    await takeTurns(`cost of ${scene.name}`, players, enough, rounds.length)
  }
}

/** µs that a frame takes with fewer chips at a setting, and so at least with more; 0 where nothing is known. */
function leastOf(contestant: Contestant, chips: number): number {
  const fewer = sizes.findLast((size) => size < chips && isSwept(size))
  if (!fewer) return sceneCostOf(contestant.engine, { name: 'pour-pills-60' }, contestant.setting, 0) ?? 0
  const pour = pourOf(contestant, fewer)
  if (!pour) return leastOf(contestant, fewer)
  return 'mean' in pour ? pour.mean : pour.atLeast
}

/** Large pours at every other setting, once, but for those that take longer than ours with fewer chips already. */
async function timeSettings() {
  for (const chips of sizes.filter(isSwept)) {
    const own = ownMean(chips) ?? Number.POSITIVE_INFINITY
    const others = contestants(chips).filter(
      (contestant) => !isDefault(contestant) && leastOf(contestant, chips) <= own,
    )
    const players = engines.map(({ name }): Player => {
      const jobs = others
        .filter(({ engine }) => engine === name)
        .map((contestant) => pourJob(contestant, chips))
      return (turn) => (jobs[turn] ? task(jobs[turn]) : null)
    })
    const most = Math.max(...engines.map(({ settings }) => settings.length))
    await takeTurns(`cost of ${chips} chips, other settings`, players, enough, most)
  }
}

/** With the time that is left: how much a pour is at least where fewer chips were slow already. */
async function timeHopeless() {
  for (const chips of sizes) {
    const untried = contestants(chips)
      .filter(isDefault)
      .filter((contestant) => {
        const fewer = withFewer(contestant, chips)
        return fewer && 'mean' in fewer && !outcomes.has(task(pourJob(contestant, chips)).key)
      })
    const jobs = untried.map((contestant) => pourJob(contestant, chips))
    await runAll(`cost of ${chips} chips, the slowest`, asTasks(jobs), 1, Math.min(deadline, enough))
  }
}

await timing(async () => {
  await timeScenes([0])
  await timeSettings()
})
await filmLarge((chips) =>
  contestants(chips)
    .filter((contestant) => {
      const engine = engines.find(({ name }) => name === contestant.engine)!
      return filmedAs(engine) === engine && meanOf(contestant, chips)
    })
    .toSorted((a, b) => meanOf(a, chips)! - meanOf(b, chips)!),
)
errors = errorRows()
await timing(async () => {
  if (mostRounds > 1) await timeScenes(Array.from({ length: mostRounds - 1 }, (_, i) => i + 1))
  if (!quick && !options.scene) await runAll('asleep', asTasks(singles('asleep')), 1)
  if (!quick) await timeHopeless()
})

const others = Math.max(0, machineTime.busy - machineTime.own) / (machineTime.busy + machineTime.idle)

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
  const fewer = withFewer(contestant, chips)
  const least = isSwept(chips) && !isDefault(contestant) ? leastOf(contestant, chips) : 0
  const taken = least || (fewer && 'mean' in fewer ? fewer.mean : fewer?.atLeast)
  if (!taken || outcomes.has(task(pourJob(contestant, chips)).key)) {
    return { reason: failures.get(task(pourJob(contestant, chips)).key) ?? 'failed with fewer chips' }
  }
  return {
    atLeast: taken,
    reason: `not tried: fewer chips took ${((taken * pourFrames) / 1e6).toFixed(1)} s`,
  }
}

const pourCosts: PourCostRow[] = sizes.flatMap((chips) =>
  contestants(chips).map((contestant) => {
    const runs = Array.from({ length: mostRounds }, (_, round) => pourOf(contestant, chips, round))
    const costs = runs.filter((run): run is Cost => run !== null && 'mean' in run)
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
      const costs = Array.from({ length: mostRounds }, (_, round) =>
        sceneCostOf(engine.name, scene, setting, round),
      ).filter((cost) => cost !== null)
      return costs.length > 0 ? [{ ...row, cost: median(costs), ...spreadOf(costs) }] : []
    }),
  ),
)

/** Every setting without a place on a scene's plot, why, and what it costs at least, where that is known. */
const missing: MissingRow[] = engines.flatMap((engine) =>
  chosenScenes.flatMap((scene) =>
    (quick ? [engine.settings[0]] : engine.settings).flatMap((setting) => {
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
          failures.has(task(job).key),
      )
      const reason = (broken && failures.get(task(broken).key)) ?? pour?.reason ?? 'no time was left'
      return [
        { engine: engine.name, setting, scene: scene.name, reason, atLeast: cost?.cost ?? pour?.atLeast },
      ]
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
  resumed,
  kept: Number((keptFilms / Math.max(1, errorJobs.filter((job) => outcomeOf(job)).length)).toFixed(3)),
  others: Number(others.toFixed(3)),
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

const number = (value: number | null | undefined) => {
  if (value === null || value === undefined) return '–'
  if (value === 0) return '0'
  if (!Number.isFinite(value)) return '∞'
  return value < 1e-3 || value >= 1e5 ? value.toExponential(1) : value.toPrecision(3)
}

console.log(
  `\n${results.machine.cpu}, ${results.machine.cores} cores, Node ${results.machine.node}, ${results.date}`,
)
if (pourCosts.length > 0) {
  console.log('\nµs per frame, all awake, mean of 4 s (p95)')
  console.log(`${''.padEnd(50)}${sizes.map((size) => `${size} chips`.padStart(18)).join('')}`)
  for (const engine of engines) {
    for (const setting of quick ? [engine.settings[0]] : [engine.settings[0], engine.accurate]) {
      const cells = sizes.map((size) => {
        const row = pourCosts.find(
          (r) =>
            r.engine === engine.name && r.chips === size && settingName(r.setting) === settingName(setting),
        )
        const bound = row?.atLeast ? `> ${number(row.atLeast)}` : '–'
        return (row?.cost ? `${number(row.cost.mean)} (${number(row.cost.p95)})` : bound).padStart(18)
      })
      console.log(`${`${engine.name}, ${settingName(setting)}`.padEnd(50)}${cells.join('')}`)
    }
  }
}

if (engines.some((engine) => engine.name === ours)) {
  console.log('\nOur default against every peer at every setting')
  console.log(
    `${'scene'.padEnd(17)}${'measure'.padEnd(17)}${'error'.padStart(9)}${'µs'.padStart(9)}   ${'best peer as cheap'.padEnd(34)}${'cheapest peer as exact'.padEnd(34)}frontier`,
  )
  for (const verdict of verdicts(results)) {
    const { scene, measure, asCheap, asExact, beaten } = verdict
    const cheap = asCheap ? `${asCheap.engine} ${number(asCheap.factor)}× the error` : 'none'
    const exact = asExact ? `${asExact.engine} ${number(asExact.factor)}× the cost` : 'none at any setting'
    const owner =
      beaten.length === 0 ? 'ours' : `beaten by ${[...new Set(beaten.map((p) => p.engine))].join(', ')}`
    console.log(
      `${scene.name.padEnd(17)}${scene.measures[measure].name.padEnd(17)}${number(verdict.error).padStart(9)}${number(verdict.cost).padStart(9)}   ${cheap.padEnd(34)}${exact.padEnd(34)}${owner}`,
    )
  }
}

if (options.out || (!quick && !part)) {
  const folder = options.out ?? join(root, 'bench/results')
  mkdirSync(folder, { recursive: true })
  writeFileSync(join(folder, 'results.json'), `${JSON.stringify(results, null, 1)}\n`)
  const quote = (text: string) => `"${text}"`
  // Each file stands for itself: what was measured, when and where is in every line.
  const originHead = 'version,date,commit,machine'
  const { cpu, cores, memoryGB, system, node } = machine
  const where = quote(`${cpu}, ${cores} cores, ${memoryGB} GB, ${system}, Node ${node}`)
  const origin = (engine: string) => [quote(results.versions[engine]), results.date, results.commit, where]
  const errorLines = errors.flatMap((row) => {
    const scene = chosenScenes.find((candidate) => candidate.name === row.scene)!
    const cost = sceneCosts.find(
      (c) =>
        c.engine === row.engine &&
        c.scene === row.scene &&
        JSON.stringify(c.setting) === JSON.stringify(row.setting),
    )
    return scene.measures.map((measure, i) =>
      [
        row.scene,
        quote(measure.name),
        measure.unit,
        measure.target ?? '',
        row.engine,
        quote(settingName(row.setting)),
        row.seeds,
        row.errors[i] ?? 'inf',
        cost?.cost.toFixed(3) ?? '',
        cost?.spread?.toFixed(3) ?? '',
        cost?.rounds ?? '',
        ...origin(row.engine),
      ].join(','),
    )
  })
  writeFileSync(
    join(folder, 'errors.csv'),
    `${[`scene,measure,unit,target,engine,setting,seeds,error,us_per_frame,spread,rounds,${originHead}`, ...errorLines].join('\n')}\n`,
  )
  const costLines = pourCosts.map((row) =>
    [
      row.engine,
      quote(settingName(row.setting)),
      row.chips,
      ...(['mean', 'pour', 'settled', 'p50', 'p95', 'worst'] as const).map(
        (key) => row.cost?.[key].toFixed(2) ?? '',
      ),
      row.spread?.toFixed(3) ?? '',
      row.rounds,
      row.atLeast?.toFixed(0) ?? '',
      quote(row.reason ?? ''),
      ...origin(row.engine),
    ].join(','),
  )
  writeFileSync(
    join(folder, 'costs.csv'),
    `${[`engine,setting,chips,mean_us,pour_us,settled_us,p50_us,p95_us,worst_us,spread,rounds,at_least_us,reason,${originHead}`, ...costLines].join('\n')}\n`,
  )
  if (!options.out) rmSync(partial, { force: true })
  console.log(
    `\nwritten after ${results.minutes} minutes: results.json, errors.csv and costs.csv in ${folder}`,
  )
}
process.exit(0)

// What the benchmark has to do, job by job: what is known already, how far it is, what it took.
import { appendFileSync, existsSync, mkdirSync, readFileSync, rmSync } from 'node:fs'
import { cpus } from 'node:os'
import { join } from 'node:path'
import { bundleWorker } from '../build/bundle'
import { root } from '../build/root'
import { sourceDigest } from '../build/sources'
import { moduleOf } from '../engines'
import type { Engine } from '../engines/engine'
import type { Job } from './job'
import { type Outcome, openTurns, runJob, spent, type Turns } from './run-job'

type Task = { job: Job; round: number; key: string }
/** What an engine is timed at in its turns, one after the other, or nothing when it needs no more. */
export type Player = (turn: number) => Task | null

type Options = {
  engines: Engine[]
  /** forgets what earlier runs have done */
  fresh: boolean
  /** leaves nothing for later ones */
  forgetful: boolean
  /** ms of this process's clock after which the run stops, to be taken up by another */
  deadline: number
  /** seconds of processor after which a job is given up */
  patience: (job: Job) => number
}

/** What the errors of an engine depend on in this project. */
const errorSources = (engine: string) =>
  sourceDigest(['scenes/index', 'bench/accuracy/trajectory', `bench/engines/${moduleOf(engine)}`])

export function packageVersion(name: string): string {
  return JSON.parse(readFileSync(join(root, 'node_modules', name, 'package.json'), 'utf8')).version
}

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

/** ms of the machine's processors since it was started, and seconds that are ours. */
function busySeconds() {
  const times = cpus().map(({ times: { idle, ...busy } }) => ({ idle, busy: Object.values(busy) }))
  const sum = (values: number[]) => values.reduce((a, b) => a + b, 0)
  const { user, system } = process.cpuUsage()
  return {
    busy: sum(times.flatMap(({ busy }) => busy)) / 1000,
    idle: sum(times.map(({ idle }) => idle)) / 1000,
    own: spent.seconds + (user + system) / 1e6,
  }
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
      const scene = 'scene' in job ? job.scene : `${job.chips} chips`
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

/**
 * Does tasks and keeps what comes of them. What an interrupted run has measured is kept until a run is
 * complete. Errors are the same whenever they are computed: they are kept for as long as nothing they depend
 * on changes. Failures are tried again.
 */
export async function openTasks({ engines, fresh, forgetful, deadline, patience }: Options) {
  const worker = await bundleWorker('speed/measure', 'measure')
  const cacheFolder = join(root, 'node_modules/.cache/gravity-stack-bench')
  const partial = join(cacheFolder, 'partial.jsonl')
  const errorCache = join(cacheFolder, 'errors.jsonl')
  mkdirSync(cacheFolder, { recursive: true })
  if (fresh) for (const file of [partial, errorCache]) rmSync(file, { force: true })
  const done = new Map([...readCache(errorCache), ...readCache(partial)])

  const digests = new Map<string, string>()
  for (const { name, packages } of engines)
    digests.set(name, `${await errorSources(name)} ${packages.map(packageVersion)}`)
  const stopwatch = await sourceDigest(['bench/speed/measure'])
  const task = (job: Job, round = 0): Task => ({
    job,
    round,
    key: `${digests.get(job.engine)} ${job.kind === 'errors' ? '' : stopwatch} ${round} ${JSON.stringify(job)}`,
  })

  const outcomes = new Map<string, unknown>()
  const failures = new Map<string, string>()
  const kept = { costs: 0, errors: 0 }

  /** Whether a task is done already, in this run or in one before. */
  function isKnown({ key, job }: Task) {
    if (!outcomes.has(key) && done.has(key)) {
      outcomes.set(key, done.get(key))
      kept[job.kind === 'errors' ? 'errors' : 'costs']++
    }
    return outcomes.has(key)
  }

  /** Keeps what comes of a task, or that nothing does. */
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
    if (!forgetful && outcome !== null) appendFileSync(file, `${JSON.stringify([key, outcome])}\n`)
  }

  function stopIfLate() {
    if (performance.now() < deadline) return
    console.error('call again to go on')
    process.exit(75)
  }

  const machineTime = { busy: 0, idle: 0, own: 0 }

  return {
    task,
    isKnown,

    outcomeOf: <J extends Job>(job: J, round = 0) =>
      (outcomes.get(task(job, round).key) ?? null) as Outcome<J> | null,

    /** Whether a job was done or tried. */
    wasTried: (job: Job) => outcomes.has(task(job).key),

    /** Why nothing came of a job, if it was tried. */
    failureOf: (job: Job) => failures.get(task(job).key),

    /** Does jobs in order until a time, each in a process of its own, at most `workers` at once. */
    async runAll(title: string, jobs: Job[], workers: number, until = deadline) {
      const queue = jobs.map((job) => task(job)).filter((task) => !isKnown(task))
      if (queue.length === 0) return
      const progress = progressOf(title, queue.length)
      const work = async () => {
        while (queue.length > 0 && performance.now() < Math.min(until, deadline)) {
          const next = queue.shift() as Task
          await keep(next, runJob(worker, next.job, patience(next.job)))
          progress.tick(next.job)
        }
      }
      await Promise.all(Array.from({ length: workers }, work))
      progress.end()
      if (queue.length > 0) stopIfLate()
    },

    /**
     * Lets engines take so many turns, one at a time, each in a process that it keeps. First rounds are for
     * all, what comes after them until a time of this process's clock.
     */
    async takeTurns(title: string, players: Player[], turns: number, until: number) {
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
            player.seat ??= openTurns(worker)
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
    },

    /** Does what is timed, and notes what others take of the machine meanwhile. */
    async timing(work: () => Promise<void>) {
      const before = busySeconds()
      await work()
      const after = busySeconds()
      for (const key of ['busy', 'idle', 'own'] as const) machineTime[key] += after[key] - before[key]
    },

    /** The share of the processors that others had while something was timed. */
    othersShare: () =>
      Math.max(0, machineTime.busy - machineTime.own) / (machineTime.busy + machineTime.idle),

    /** Tasks that earlier runs had done. */
    kept,

    /** Forgets what was timed, as it stands in the results now. */
    complete: () => rmSync(partial, { force: true }),
  }
}

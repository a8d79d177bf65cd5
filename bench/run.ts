// Run time against error, for every engine, setting and scene.
//   npm run bench                     everything; takes up where an interrupted run stopped
//   npm run bench -- --quick          a few scenes and settings, under a minute, writes nothing
//   npm run bench -- --scene pour,stack --engine ours,planck
//   npm run bench -- --errors         errors alone, which are kept for the next run: they never change by themselves
//   npm run bench -- --out folder     writes there, parts too (the whole goes to bench/results)
//   npm run bench -- --minutes 5      stops after five; the next call goes on from there
//   npm run bench -- --retry          tries again what took too long when the machine was busy
//   npm run bench -- --fresh          forgets what an interrupted run had measured
import { execFileSync } from 'node:child_process'
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
import { arch, cpus, release, totalmem, type } from 'node:os'
import { join } from 'node:path'
import { parseArgs } from 'node:util'
import { scenes } from '../scenes'
import type { Scene } from '../scenes/scene'
import { engineBytes } from './bytes'
import { type Engine, type Setting, settingName } from './engine'
import { engineNames, loadEngine } from './engines'
import { median } from './film'
import { type Cost, type Job, medianCost } from './job'
import { type ErrorRow, ours, type PourCostRow, type Results, type SceneCostRow, verdicts } from './report'
import { bundle, type Outcome, root, runJob } from './run-job'

const { values: options } = parseArgs({
  options: {
    scene: { type: 'string' },
    engine: { type: 'string' },
    quick: { type: 'boolean', default: false },
    errors: { type: 'boolean', default: false },
    out: { type: 'string' },
    retry: { type: 'boolean', default: false },
    minutes: { type: 'string', default: 'Infinity' },
    fresh: { type: 'boolean', default: false },
    rounds: { type: 'string', default: '3' },
  },
})

const quick = options.quick
const part = Boolean(options.scene ?? options.engine)
const rounds = quick ? 1 : Number(options.rounds)
const wantedScenes =
  options.scene?.split(',') ?? (quick ? ['free-fall-drag', 'slide', 'pour-pills-60'] : undefined)
const chosenScenes = scenes.filter(
  (scene) => !wantedScenes || wantedScenes.some((name) => scene.name.includes(name)),
)
const wantedEngines = options.engine?.split(',').map((name) => (name === 'ours' ? ours : name))
const chosenEngines = engineNames.filter((name) => !wantedEngines || wantedEngines.includes(name))
const isLarge = (scene: Scene) => /-(250|1000)$/.test(scene.name)
const deadline = performance.now() + 60_000 * Number(options.minutes)
/** ms after which a job is given up: of several settings, which then get one each, or of one. */
const patience = (job: Job) => ('settings' in job && job.settings.length > 1 ? 150_000 : 30_000)

const child = await bundle('child')
const engines: Engine[] = []
for (const name of chosenEngines) engines.push(await loadEngine(name))

// What an interrupted run has measured is kept until a run is complete. Errors are the same whenever they are
// computed, so they are kept for as long as nothing they depend on changes.
const cacheFolder = join(root, 'node_modules/.cache/gravity-stack-bench')
const partial = join(cacheFolder, 'partial.jsonl')
const errorCache = join(cacheFolder, 'errors.jsonl')
mkdirSync(cacheFolder, { recursive: true })
if (options.fresh) for (const file of [partial, errorCache]) rmSync(file, { force: true })

function readCache(file: string) {
  const lines = existsSync(file) ? readFileSync(file, 'utf8').trim().split('\n').filter(Boolean) : []
  return new Map(lines.map((line) => JSON.parse(line) as [string, unknown]))
}

const done = new Map([...readCache(errorCache), ...readCache(partial)])
if (options.retry) for (const [key, outcome] of readCache(errorCache)) if (outcome === null) done.delete(key)

// What an engine's errors depend on.
const judges = ['exact-distance', 'scene', 'seeded', 'references', 'residual', 'exact', 'piles']

function sourceHash(name: string) {
  const hash = createHash('sha1')
  const read = (folder: string, keep: (file: string) => boolean) => {
    for (const file of readdirSync(join(root, folder)).sort().filter(keep)) {
      hash.update(readFileSync(join(root, folder, file)))
    }
  }
  read('scenes', (file) => judges.includes(file.replace(/\.ts$/, '')))
  if (name === ours) read('registry/gravity-stack', (file) => /^[a-z]+\.ts$/.test(file))
  else read('bench/engines', (file) => file !== 'ours.ts' && file !== 'index.ts')
  return hash.digest('hex').slice(0, 12)
}

function packageVersion(name: string): string {
  return JSON.parse(readFileSync(join(root, 'node_modules', name, 'package.json'), 'utf8')).version
}

type Task = { job: Job; round: number; key: string }
const hashes = new Map(engines.map((engine) => [engine.name, sourceHash(engine.name)]))
const task = (job: Job, round = 0): Task => ({
  job,
  round,
  key: `${hashes.get(job.engine)} ${round} ${JSON.stringify(job)}`,
})

const outcomes = new Map<string, unknown>()

/** Runs tasks in order, at most `workers` at once, and says how far it is. */
async function runAll(title: string, tasks: Task[], workers: number) {
  const queue = tasks.filter(({ key }) => {
    if (done.has(key)) outcomes.set(key, done.get(key))
    return !done.has(key)
  })
  const total = queue.length
  const start = performance.now()
  let finished = 0
  const worker = async () => {
    for (let next = queue.shift(); next && performance.now() < deadline; next = queue.shift()) {
      let outcome: unknown = null
      try {
        outcome = await runJob(child, next.job, patience(next.job))
      } catch (error) {
        console.error(`\n${error instanceof Error ? error.message : error}`)
      }
      outcomes.set(next.key, outcome)
      const file = next.job.kind === 'errors' ? errorCache : partial
      if (!quick) appendFileSync(file, `${JSON.stringify([next.key, outcome])}\n`)
      finished++
      const elapsed = (performance.now() - start) / 1000
      const remaining = (elapsed / finished) * (total - finished)
      const scene = 'scene' in next.job ? next.job.scene : `${next.job.chips} chips`
      const line = `${title} ${finished}/${total}, ${elapsed.toFixed(0)} s, ${remaining.toFixed(0)} s to go: ${next.job.engine}, ${scene}`
      if (process.stderr.isTTY) process.stderr.write(`\r\x1b[K${line.slice(0, 100)}`)
      else if (finished % 25 === 0 || finished === total) console.error(line)
    }
  }
  await Promise.all(Array.from({ length: workers }, worker))
  if (process.stderr.isTTY) process.stderr.write('\r\x1b[K')
  if (finished < total) {
    console.error(`${title}: ${finished} of ${total} done; call again to go on`)
    process.exit(75)
  }
}

const outcomeOf = <J extends Job>(job: J, round = 0) =>
  (outcomes.get(task(job, round).key) ?? null) as Outcome<J> | null

const settingsFor = (engine: Engine, scene: Scene): Setting[][] => {
  if (quick) return [[engine.settings[0]]]
  if (isLarge(scene)) return [[engine.settings[0]], [engine.accurate]]
  return [engine.settings]
}

// Errors don't depend on what else the machine does: two at a time.
let errorJobs = engines.flatMap((engine) =>
  chosenScenes.flatMap((scene) =>
    settingsFor(engine, scene).map((settings) => ({
      kind: 'errors' as const,
      engine: engine.name,
      scene: scene.name,
      settings,
      seeds: quick ? 2 : scene.seeds,
    })),
  ),
)
await runAll(
  'errors',
  errorJobs.map((job) => task(job)),
  2,
)

// Where all settings together took too long, each has a time of its own.
errorJobs = errorJobs.flatMap((job) =>
  outcomeOf(job) === null ? job.settings.map((setting) => ({ ...job, settings: [setting] })) : [job],
)
await runAll(
  'errors, setting by setting',
  errorJobs.filter((job) => job.settings.length === 1).map((job) => task(job)),
  2,
)
if (options.errors) process.exit(0)

// Costs: one process at a time, engines in turn, round after round.
const sceneCostJobs = chosenScenes.flatMap((scene) =>
  engines.flatMap((engine) =>
    settingsFor(engine, scene).map((settings) => ({
      kind: 'scene cost' as const,
      engine: engine.name,
      scene: scene.name,
      settings,
      milliseconds: quick ? 60 : settings.length * 50,
    })),
  ),
)
/** A job that was given up once is not tried again. */
const hopeful = (jobs: Job[], round: number) =>
  jobs.filter((job) => round === 0 || outcomes.get(task(job, round - 1).key) !== null)

for (let round = 0; round < rounds; round++) {
  // Large piles are few seconds each and differ little from round to round: one round.
  const jobs = sceneCostJobs.filter((job) => round === 0 || !/-(250|1000)$/.test(job.scene))
  await runAll(
    `cost of scenes, round ${round + 1} of ${rounds}`,
    hopeful(jobs, round).map((job) => task(job, round)),
    1,
  )
}

const pourSettings = (engine: Engine) =>
  quick ? [engine.settings[0]] : [engine.settings[0], engine.accurate]
const pourCosts: PourCostRow[] = []
if (!options.scene) {
  // µs per frame at the size before, to know which runs would take minutes.
  const before = new Map<string, number>()
  for (const chips of quick ? [12, 60, 250] : [12, 60, 250, 1000, 4000]) {
    const contestants = engines.flatMap((engine) =>
      pourSettings(engine).map((setting) => ({ engine: engine.name, setting })),
    )
    const nameOf = (c: { engine: string; setting: Setting }) => `${c.engine} ${JSON.stringify(c.setting)}`
    const able = contestants.filter(
      (c) => (before.get(nameOf(c)) ?? 0) < (quick ? 400 : chips > 1000 ? 10_000 : 40_000),
    )
    const jobOf = (c: { engine: string; setting: Setting }) => ({
      kind: 'pour cost' as const,
      ...c,
      chips,
      shape: 'pills' as const,
      milliseconds: quick ? 100 : 300,
    })
    const sizeRounds = chips > 1000 ? 1 : rounds
    for (let round = 0; round < sizeRounds; round++) {
      const jobs = able.filter((c) => round === 0 || (before.get(nameOf(c)) ?? 0) < 2000).map(jobOf)
      await runAll(
        `${chips} chips, round ${round + 1} of ${sizeRounds}`,
        hopeful(jobs, round).map((job) => task(job, round)),
        1,
      )
    }
    for (const contestant of contestants) {
      const runs = Array.from({ length: sizeRounds }, (_, round) => outcomeOf(jobOf(contestant), round))
      const costs = runs.filter((run): run is Cost => run !== null)
      const means = costs.map((cost) => cost.mean)
      const previous = before.get(nameOf(contestant)) ?? 0
      pourCosts.push({
        ...contestant,
        chips,
        cost: costs.length > 0 ? medianCost(costs) : null,
        spread: costs.length > 0 ? Math.max(...means) / Math.min(...means) : null,
        ...(costs.length > 0
          ? {}
          : {
              reason: able.includes(contestant)
                ? `given up after ${patience(jobOf(contestant)) / 1000} s`
                : `left out: ${(previous / 1000).toFixed(0)} ms a frame with a quarter of the chips`,
            }),
      })
      before.set(nameOf(contestant), costs.length > 0 ? median(means) : Number.POSITIVE_INFINITY)
    }
  }
}

const singles = engines.flatMap((engine) => [
  { kind: 'asleep' as const, engine: engine.name, setting: engine.settings[0], chips: 60 },
  { kind: 'allocation' as const, engine: engine.name, setting: engine.settings[0], chips: 60 },
])
if (!quick && !options.scene)
  await runAll(
    'asleep and allocation',
    singles.map((job) => task(job)),
    1,
  )

const errors: ErrorRow[] = errorJobs.flatMap((job) => {
  const rows = outcomeOf(job)
  return rows === null
    ? []
    : job.settings.map((setting, i) => ({
        engine: job.engine,
        setting,
        scene: job.scene,
        errors: rows[i].map((value) => (Number.isFinite(value) ? value : null)),
        seeds: job.seeds,
      }))
})

const sceneCosts: SceneCostRow[] = sceneCostJobs.flatMap((job) => {
  const perRound = Array.from({ length: rounds }, (_, round) => outcomeOf(job, round)).filter(
    (run) => run !== null,
  )
  if (perRound.length === 0) return []
  return job.settings.map((setting, i) => {
    const costs = perRound.map((run) => run[i])
    return {
      engine: job.engine,
      setting,
      scene: job.scene,
      cost: median(costs),
      spread: Math.max(...costs) / Math.min(...costs),
    }
  })
})

const single = (kind: 'asleep' | 'allocation') =>
  Object.fromEntries(singles.filter((job) => job.kind === kind).map((job) => [job.engine, outcomeOf(job)]))

const results: Results = {
  date: new Date().toISOString(),
  machine: {
    cpu: cpus()[0].model.trim(),
    cores: cpus().length,
    memoryGB: Math.round(totalmem() / 2 ** 30),
    system: `${type()} ${release().split('-')[0]} ${arch()}`,
    node: process.version,
  },
  versions: Object.fromEntries(
    engines.map((engine) => [
      engine.name,
      engine.packages.map(packageVersion).join(', ') || 'this repository',
    ]),
  ),
  quick,
  commit: execFileSync('git', ['rev-parse', '--short', 'HEAD'], { cwd: root, encoding: 'utf8' }).trim(),
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
  const sizes = [...new Set(pourCosts.map((row) => row.chips))]
  console.log(`${''.padEnd(50)}${sizes.map((size) => `${size} chips`.padStart(18)).join('')}`)
  for (const engine of engines) {
    for (const setting of pourSettings(engine)) {
      const cells = sizes.map((size) => {
        const row = pourCosts.find(
          (r) =>
            r.engine === engine.name &&
            r.chips === size &&
            JSON.stringify(r.setting) === JSON.stringify(setting),
        )
        return (row?.cost ? `${number(row.cost.mean)} (${number(row.cost.p95)})` : '–').padStart(18)
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
        cost?.spread.toFixed(3) ?? '',
      ].join(','),
    )
  })
  writeFileSync(
    join(folder, 'errors.csv'),
    `${['scene,measure,unit,target,engine,setting,seeds,error,us_per_frame,spread', ...errorLines].join('\n')}\n`,
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
      quote(row.reason ?? ''),
    ].join(','),
  )
  writeFileSync(
    join(folder, 'costs.csv'),
    `${['engine,setting,chips,mean_us,pour_us,settled_us,p50_us,p95_us,worst_us,spread,reason', ...costLines].join('\n')}\n`,
  )
  if (!options.out) rmSync(partial, { force: true })
  console.log(`\nwritten: results.json, errors.csv and costs.csv in ${folder}`)
}
process.exit(0)

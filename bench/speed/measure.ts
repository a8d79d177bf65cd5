// What one job of the benchmark measures. A worker holds one engine, which does its jobs one after the other.
import { sceneNamed } from '../../scenes'
import { type Kind, pourChips, pourStage } from '../../scenes/piles'
import { type Chip, conditions, type Scene } from '../../scenes/scene'
import { median, sceneErrors } from '../accuracy/trajectory'
import { loadEngine } from '../engines'
import type { Engine, Setting } from '../engines/engine'
import { type AtLeast, type Cost, type Job, medianCost } from './job'

const frames = 240
const pourFrames = 90
const settledFrom = 180

/** Pours by what makes them: where a thousand chips begin takes long to find. */
const poured = new Map<string, Chip[]>()

function pourScene(chips: number, shape: Kind = 'pills'): Scene {
  const build = (seed: number) => {
    const key = [shape, chips, seed].join()
    const known = poured.get(key) ?? pourChips(shape, chips, seed)
    poured.set(key, known)
    return known
  }
  return {
    name: 'pour',
    title: '',
    ...pourStage(chips),
    seconds: 4,
    conditions,
    seeds: 1,
    build,
    measures: [],
    measure: () => [],
  }
}

function mean(values: Float64Array) {
  return values.reduce((sum, value) => sum + value, 0) / values.length
}

function quantile(values: Float64Array, q: number) {
  return values.slice().sort()[Math.min(values.length - 1, Math.floor(q * values.length))]
}

/** ms of a run that is not played again at once: noise is a small part of it. */
const long = 400

/**
 * Microseconds of each frame, the same run played three times over and the median taken frame by frame: what
 * else the machine does hits one run here and another there. Long runs are played once; null is one that was
 * given up.
 */
function playThrice(
  engine: Engine,
  scene: Scene,
  { setting, patience }: { setting: Setting; patience: number },
  seed: number,
) {
  const runs: Float64Array[] = []
  let total = 0
  do {
    const times = new Float64Array(frames)
    const run = engine.start(scene, scene.build(seed), setting, false)
    const begin = performance.now()
    for (let k = 0; k < frames; k++) {
      const start = performance.now()
      if (start - begin > patience) return null
      run.step()
      times[k] = (performance.now() - start) * 1000
    }
    run.free()
    runs.push(times)
    total = performance.now() - begin
  } while (runs.length < 3 && total < long)
  return runs[0].map((_, k) => median(runs.map((run) => run[k])))
}

/** Plays a scene again and again for so many milliseconds of processor: the compiler's threads count. */
function warmUp(engine: Engine, scene: Scene, setting: Setting, milliseconds: number, seed = 1) {
  // To find where chips begin is no warm-up.
  scene.build(seed)
  const begin = process.cpuUsage()
  const over = () => process.cpuUsage(begin).user / 1000 > milliseconds
  for (let k = 0; !over(); k++) {
    const run = engine.start(scene, scene.build(seed + (k % 3)), setting, false)
    for (let i = 0; i < scene.seconds * 60 && !over(); i++) run.step()
    run.free()
  }
}

/** Waits for the compiler's threads: their work would slow down this engine or the next. */
async function compiled() {
  for (let waited = 0; waited < 3000; waited += 10) {
    const begin = process.cpuUsage()
    await new Promise((resolve) => setTimeout(resolve, 10))
    if (process.cpuUsage(begin).user < 2000) return
  }
}

/** Whether this process has had a turn. */
let warm = false

/** Warms up in a process's first turn, until the compiler has seen whole pours. The same for every engine. */
async function pourCost(engine: Engine, job: Extract<Job, { kind: 'pour cost' }>): Promise<Cost | AtLeast> {
  const scene = pourScene(job.chips, job.shape)
  if (!warm) {
    // Whole pours, so that all code is compiled; of a few chips first, as a large pour may take too long.
    if (job.chips > 60) warmUp(engine, pourScene(60, job.shape), job.setting, job.warmUp, 101)
    warmUp(engine, scene, job.setting, job.warmUp, job.chips > 250 ? 1 : 101)
    await compiled()
  }
  const costs: Cost[] = []
  let total = 0
  for (let seed = 1; seed <= job.seeds && (seed === 1 || total < long); seed++) {
    const times = playThrice(engine, scene, job, seed)
    if (!times) return { atLeast: (job.patience * 1000) / frames }
    total = (mean(times) * frames) / 1000
    costs.push({
      mean: mean(times),
      pour: mean(times.subarray(0, pourFrames)),
      settled: mean(times.subarray(settledFrom)),
      p50: quantile(times, 0.5),
      p95: quantile(times, 0.95),
      worst: quantile(times, 1),
    })
  }
  return medianCost(costs)
}

/** Microseconds per frame of a scene's first six seconds, for each setting. */
async function sceneCost(
  engine: Engine,
  job: Extract<Job, { kind: 'scene cost' }>,
): Promise<(number | AtLeast)[]> {
  const scene = sceneNamed(job.scene)
  const count = Math.round(60 * Math.min(6, scene.seconds))
  if (!warm) {
    // Getting to know an engine takes the compiler half a second's work where many chips meet.
    warmUp(engine, scene, job.settings[0], scene.build(1).length > 4 ? 400 : 200, job.seed)
    for (const setting of job.settings) warmUp(engine, scene, setting, 10, job.seed)
    await compiled()
  }
  // What everyone looks at comes last: by then the compiler has seen most.
  const played = job.settings.map((setting, i) => ({ setting, patience: job.patience[i] }))
  const costs = played.toReversed().map(({ setting, patience }) => {
    if (warm) warmUp(engine, scene, setting, 5, job.seed)
    const costs: number[] = []
    const begin = performance.now()
    const passed = () => performance.now() - begin
    do {
      const run = engine.start(scene, scene.build(job.seed), setting, false)
      const start = performance.now()
      for (let k = 0; k < count; k++) {
        if (patience !== null && performance.now() - start > patience) {
          return { atLeast: (patience * 1000) / count }
        }
        run.step()
      }
      costs.push(((performance.now() - start) * 1000) / count)
      run.free()
    } while (passed() < (costs.length < 3 ? 15 : 5))
    return median(costs)
  })
  return costs.toReversed()
}

/** Microseconds per frame once the engine has put everything to sleep: from 20 s after a pour on. */
function asleepCost(engine: Engine, job: Extract<Job, { kind: 'asleep' }>) {
  const scene = pourScene(job.chips)
  const run = engine.start(scene, scene.build(1), job.setting, true)
  for (let k = 0; k < 20 * 60; k++) run.step()
  // Other work of a millisecond is a hundred times what a sleeping world takes, so the median of nine seconds
  // counts.
  return median(
    Array.from({ length: 9 }, () => {
      const start = performance.now()
      for (let k = 0; k < 60; k++) run.step()
      return ((performance.now() - start) * 1000) / 60
    }),
  )
}

/** Bytes of JavaScript heap that a frame of a pour takes; needs --expose-gc and a large young generation. */
function allocation(engine: Engine, job: Extract<Job, { kind: 'allocation' }>) {
  const scene = pourScene(job.chips)
  const pour = (seed: number) => {
    const run = engine.start(scene, scene.build(seed), job.setting, false)
    globalThis.gc?.()
    const before = process.memoryUsage().heapUsed
    for (let k = 0; k < frames; k++) run.step()
    const bytes = process.memoryUsage().heapUsed - before
    run.free()
    return bytes / frames
  }
  // The compiler's own traces go with the first runs.
  for (let seed = 1; seed <= 12; seed++) pour(seed)
  // Now and then one more comes between.
  return Math.max(0, Math.min(...[1, 2, 3, 4, 5, 6, 7, 8, 9].map(pour)))
}

const seconds = () => {
  const { user, system } = process.cpuUsage()
  return (user + system) / 1e6
}

class GivenUp extends Error {}

/** The engine, which gives up once the process has had that many seconds of processor. */
const patient = (engine: Engine, patience: number): Engine => ({
  ...engine,
  start(...args) {
    const run = engine.start(...args)
    return {
      ...run,
      step() {
        if (seconds() > patience) throw new GivenUp()
        run.step()
      },
    }
  },
})

let engine: Engine | undefined

/** What comes of a job; nothing where it takes more than `patience` seconds of the worker's processor. */
export async function measure(job: Job, patience = Number.POSITIVE_INFINITY) {
  engine ??= await loadEngine(job.engine)
  try {
    return await outcomeOf(engine, job, patience)
  } catch (error) {
    if (!(error instanceof GivenUp)) throw error
  } finally {
    warm = true
  }
}

function outcomeOf(engine: Engine, job: Job, patience: number) {
  if (job.kind === 'errors') {
    const scene = sceneNamed(job.scene)
    const slow = patient(engine, patience)
    return job.settings.map((setting) => sceneErrors(slow, scene, setting, job.seeds))
  }
  if (job.kind === 'scene cost') return sceneCost(engine, job)
  if (job.kind === 'pour cost') return pourCost(engine, job)
  if (job.kind === 'asleep') return asleepCost(engine, job)
  return allocation(engine, job)
}

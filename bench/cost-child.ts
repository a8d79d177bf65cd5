// One engine, one setting, one size, in a process of its own: shared compiled code would blur the figures.
// Prints microseconds per frame as JSON. Arguments: engine, setting as JSON, chips, kind of chips, milliseconds.
import { type Kind, pourChips, pourStage } from '../scenes/piles'
import { conditions, type Scene } from '../scenes/scene'
import { loadEngine } from './engines'

const [name, settingText, countText, kind, budgetText] = process.argv.slice(2)
const setting = JSON.parse(settingText)
const count = Number(countText)
const budget = Number(budgetText)
const frames = 240
const pourFrames = 90
const settledFrom = 180

const engine = await loadEngine(name)
const scene: Scene = {
  name: 'cost',
  title: '',
  ...pourStage(count),
  seconds: 4,
  conditions,
  seeds: 1,
  build: (seed) => pourChips(kind as Kind, count, seed),
  measures: [],
  measure: () => [],
}

const times = new Float64Array(frames)

function pourOnce(seed: number) {
  const run = engine.start(scene, scene.build(seed), setting)
  for (let k = 0; k < frames; k++) {
    const start = performance.now()
    run.step()
    times[k] = (performance.now() - start) * 1000
  }
  run.free()
  return times
}

function mean(values: Float64Array) {
  return values.reduce((sum, value) => sum + value, 0) / values.length
}

function quantile(values: Float64Array, q: number) {
  return values.slice().sort()[Math.min(values.length - 1, Math.floor(q * values.length))]
}

// Warm up until the compiler has seen the whole of a pour, then measure pours of other seeds.
const warmUntil = performance.now() + budget / 3
let warm = 0
do pourOnce(101 + (warm++ % 3))
while (performance.now() < warmUntil && warm < 40)

const runs = []
const until = performance.now() + budget
let seed = 0
do {
  pourOnce(1 + (seed++ % 12))
  runs.push({
    mean: mean(times),
    pour: mean(times.subarray(0, pourFrames)),
    settled: mean(times.subarray(settledFrom)),
    p50: quantile(times, 0.5),
    p95: quantile(times, 0.95),
    worst: quantile(times, 1),
  })
} while (performance.now() < until && seed < 60)

console.log(JSON.stringify(runs))
process.exit(0)

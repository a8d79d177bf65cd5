// Pours chips with three engines in the visitor's browser and posts what it finds.

import { median, simulateScene } from '@/bench/accuracy/trajectory'
import type { Engine, Setting } from '@/bench/engines/engine'
import { matter } from '@/bench/engines/matter'
import { ours } from '@/bench/engines/ours'
import { rapierPlain } from '@/bench/engines/rapier'
import { sceneNamed } from '@/scenes'
import { Trajectory } from '@/scenes/scene'

export type DevicePoint = { engine: string; setting: Setting; cost: number; rest: number; during: number }
export type DeviceNews =
  | { kind: 'progress'; done: number; total: number; engine: string }
  | { kind: 'point'; point: DevicePoint }
  | { kind: 'done' }
  | { kind: 'failed'; why: string }

const post = (news: DeviceNews) => postMessage(news)

const seeds = [1, 2, 3]
/** Times that each variant pours all seeds, untimed and timed. */
const warmUps = 1
const rounds = 3
const variants: [Engine, Setting][] = [
  [ours, {}],
  [ours, { substeps: 16 }],
  [matter, matter.settings[0]],
  [matter, { substeps: 4, velocity: 4, position: 6 }],
  [rapierPlain, rapierPlain.settings[0]],
  [rapierPlain, { iterations: 8, hertz: 120 }],
]

async function run() {
  const scene = sceneNamed('pour-pills-60')
  const total = variants.length * (warmUps + rounds + 1) * seeds.length
  let done = 0
  const progress = (engine: Engine) => post({ kind: 'progress', done: done++, total, engine: engine.name })

  /** µs a frame of one pour. */
  function timed(engine: Engine, setting: Setting, seed: number) {
    const trajectory = new Trajectory(scene, scene.build(seed))
    const run = engine.start(scene, trajectory.chips, setting, false)
    const start = performance.now()
    for (let k = 0; k < trajectory.frames; k++) run.step()
    const cost = ((performance.now() - start) * 1000) / trajectory.frames
    run.free()
    return cost
  }

  // All are warm before any is timed, and they take turns: else the first pays for the browser's compiler.
  for (const [engine] of variants) await engine.load()
  const costs = variants.map((): number[] => [])
  for (let round = -warmUps; round < rounds; round++) {
    for (const seed of seeds) {
      for (const [i, [engine, setting]] of variants.entries()) {
        progress(engine)
        const cost = timed(engine, setting, seed)
        if (round >= 0) costs[i].push(cost)
      }
    }
  }

  // Poses are read only in runs that are not timed.
  for (const [i, [engine, setting]] of variants.entries()) {
    const rest: number[] = []
    const during: number[] = []
    for (const seed of seeds) {
      progress(engine)
      const { trajectory } = simulateScene(engine, scene, setting, seed)
      rest.push(trajectory.overlap(trajectory.frames))
      during.push(trajectory.worstOverlap())
    }
    const point = { engine: engine.name, setting, cost: median(costs[i]) }
    post({ kind: 'point', point: { ...point, rest: Math.max(...rest), during: median(during) } })
  }
  post({ kind: 'done' })
}

run().catch((error) => post({ kind: 'failed', why: String(error) }))

// Pours chips with three engines in the visitor's browser, one after the other, and posts what it finds.
import type { Engine, Setting } from '@/bench/engine'
import { matter } from '@/bench/engines/matter'
import { ours } from '@/bench/engines/ours'
import { rapierPlain } from '@/bench/engines/rapier'
import { median } from '@/bench/film'
import { sceneNamed } from '@/scenes'
import { Film } from '@/scenes/scene'

export type DevicePoint = { engine: string; setting: Setting; cost: number; rest: number; during: number }
export type DeviceNews =
  | { kind: 'progress'; done: number; total: number; engine: string }
  | { kind: 'point'; point: DevicePoint }
  | { kind: 'done' }
  | { kind: 'failed'; why: string }

const post = (news: DeviceNews) => postMessage(news)

const seeds = [1, 2, 3]
const contestants: [Engine, Setting][] = [
  [ours, {}],
  [ours, { substeps: 16 }],
  [matter, matter.settings[0]],
  [matter, { substeps: 4, velocity: 4, position: 6 }],
  [rapierPlain, rapierPlain.settings[0]],
  [rapierPlain, { iterations: 8, hertz: 120 }],
]

async function run() {
  const scene = sceneNamed('pour-pills-60')
  const total = contestants.length * (2 * seeds.length + 2)
  let done = 0
  for (const [engine, setting] of contestants) {
    post({ kind: 'progress', done, total, engine: engine.name })
    await engine.load()
    const costs: number[] = []
    const rest: number[] = []
    const during: number[] = []
    // Two pours warm up; poses are read only in runs that are not timed.
    for (const seed of [0, -1, ...seeds]) {
      const film = new Film(scene, scene.build(seed))
      const timed = engine.start(scene, film.chips, setting, false)
      const start = performance.now()
      for (let k = 0; k < film.frames; k++) timed.step()
      const cost = ((performance.now() - start) * 1000) / film.frames
      timed.free()
      post({ kind: 'progress', done: ++done, total, engine: engine.name })
      if (seed <= 0) continue
      costs.push(cost)
      const filmed = engine.start(scene, film.chips, setting, false)
      for (let k = 1; k <= film.frames; k++) {
        filmed.step()
        filmed.read(film.at(k))
      }
      filmed.free()
      rest.push(film.overlap(film.frames))
      during.push(film.worstOverlap())
      post({ kind: 'progress', done: ++done, total, engine: engine.name })
    }
    const point = { engine: engine.name, setting, cost: median(costs) }
    post({ kind: 'point', point: { ...point, rest: Math.max(...rest), during: median(during) } })
  }
  post({ kind: 'done' })
}

run().catch((error) => post({ kind: 'failed', why: String(error) }))

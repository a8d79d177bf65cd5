import { expect, it } from 'vitest'
import { conditions, frame, type Scene } from '../../scenes/scene'
import type { Engine } from '../engines/engine'
import { sceneErrors, simulateScene } from './trajectory'

/** One chip that is a pixel further right after each step, times its seed; at the third seed it is lost. */
const scene: Scene = {
  name: 'walk',
  title: 'A chip walks',
  width: 640,
  height: 340,
  seconds: 3 * frame,
  conditions,
  seeds: 5,
  build: (seed) => [{ width: 10, height: 10, x: 0, y: 0, angle: 0, vx: seed }],
  measures: [
    { name: 'worst', unit: 'px' },
    { name: 'median', unit: 'px', over: 'median' },
  ],
  measure: (trajectory) => [trajectory.state(trajectory.frames).x, trajectory.state(trajectory.frames).x],
}

const running = new Set<object>()
const walker: Engine = {
  name: 'walker',
  packages: [],
  settings: [{}],
  accurate: {},
  load: async () => {},
  start(_, [{ vx: seed = 0 }]) {
    let x = 0
    const run = {
      step: () => {
        x += seed
      },
      read: (into: Float64Array) => {
        into[0] = seed === 3 ? Number.NaN : x
      },
      work: () => ({ steps: 1 }),
      free: () => {
        running.delete(run)
      },
    }
    running.add(run)
    return run
  },
}

it('a trajectory has every frame, and the work of all', () => {
  const { trajectory, work } = simulateScene(walker, scene, {}, 2)
  expect([0, 1, 2, 3].map((k) => trajectory.state(k).x)).toEqual([0, 2, 4, 6])
  expect(work).toEqual({ steps: 3 })
  expect(running.size).toBe(0)
})

it('a scene is as wrong as the worst of its seeds, or as half of them, and what is lost is without bound', () => {
  expect(sceneErrors(walker, scene, {}, 2)).toEqual([6, 4.5])
  expect(sceneErrors(walker, scene, {})).toEqual([Number.POSITIVE_INFINITY, 12])
  expect(sceneErrors(walker, scene, {}, 99)).toEqual([Number.POSITIVE_INFINITY, 12])
})

// Errors and work of our solver in every scene of the benchmark. They are the same on every machine.
import { scenes } from '../../scenes'
import type { Scene } from '../../scenes/scene'
import { ours } from '../engines/ours'
import { simulateScene } from './trajectory'

type SceneBound = { errors: Record<string, number>; work: Record<string, number> }
export type Bounds = Record<string, SceneBound>

/** What costs time: pairs measured, contact points that touch after a step, sub-steps, sweeps. */
const counted = ['narrow', 'points', 'substeps', 'sweeps']

/** Chaotic scenes are held to their first seed. */
export function measureScene(scene: Scene): SceneBound {
  const { trajectory, work } = simulateScene(ours, scene, {}, 1)
  const errors = scene.measure(trajectory)
  return {
    errors: Object.fromEntries(scene.measures.map(({ name }, i) => [name, errors[i]])),
    work: Object.fromEntries(counted.map((key) => [key, work[key] ?? 0])),
  }
}

/** What every scene is held to; for a worker. */
export const measureAll = (): Bounds =>
  Object.fromEntries(scenes.map((scene) => [scene.name, measureScene(scene)]))

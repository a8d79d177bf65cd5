// What our solver answers and how much work it does for that, on every scene: the same numbers on every machine.
import { scenes } from '../scenes'
import { ours } from './engines/ours'
import { filmScene } from './film'

export type SceneBound = { errors: Record<string, number>; work: Record<string, number> }
export type Bounds = Record<string, SceneBound>

/** Work that costs time: pairs measured, contact points solved, sub-steps, sweeps; of one pour of many seeds. */
const counted = ['narrow', 'points', 'substeps', 'sweeps']

/** Scenes small enough to run at every change. */
export const gated = scenes.filter((scene) => !/-1000$/.test(scene.name))

export function measureScene(scene: (typeof gated)[number]): SceneBound {
  const { film, work } = filmScene(ours, scene, {}, 1)
  const errors = scene.measure(film)
  return {
    errors: Object.fromEntries(scene.measures.map(({ name }, i) => [name, errors[i]])),
    work: Object.fromEntries(counted.map((key) => [key, work[key] ?? 0])),
  }
}

// What our solver answers, how much work that takes, and how it bears the hard scenes: the same numbers everywhere.
import { scenes } from '../scenes'
import { hardScenes } from '../scenes/hard'
import { ours } from './engines/ours'
import { filmScene } from './film'
import { hardFigures } from './hard-run'

/** null stands for a figure without bound: a pile that never sleeps. */
export type SceneBound = { errors: Record<string, number | null>; work: Record<string, number> }
export type Bounds = Record<string, SceneBound>

/** What costs time: pairs measured, contact points solved, sub-steps, sweeps. */
const counted = ['narrow', 'points', 'substeps', 'sweeps']

/** Every gated scene, by name and title, with what takes its measures. Chaotic ones are held to their first seed. */
export const gated: { name: string; title: string; measure(): SceneBound }[] = [
  ...scenes.map((scene) => ({
    name: scene.name,
    title: scene.title,
    measure() {
      const { film, work } = filmScene(ours, scene, {}, 1)
      const errors = scene.measure(film)
      return {
        errors: Object.fromEntries(scene.measures.map(({ name }, i) => [name, errors[i]])),
        work: Object.fromEntries(counted.map((key) => [key, work[key] ?? 0])),
      }
    },
  })),
  ...hardScenes.map((scene) => ({
    name: scene.name,
    title: scene.title,
    measure() {
      const figures = Object.entries(hardFigures(scene, 1))
      const errors = figures.map(([name, value]) => [name, Number.isFinite(value) ? value : null])
      return { errors: Object.fromEntries(errors), work: {} }
    },
  })),
]

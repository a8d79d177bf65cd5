// How other engines bear the level rows with joints over which a chip slides.
import { type HardScene, hardScenes } from '../../scenes/hard'
import { simulateScene } from '../accuracy/trajectory'
import { loadEngine } from '../engines'
import { ours } from '../publish/report'
import { slowedBy } from './play'

/** The engines whose slides the docs tell of. */
export const slidingEngines = [ours, 'planck', 'box2d3-wasm', 'rapier', 'matter-js', 'p2-es']

/**
 * Slides of one scene in one engine at its default: how many were slowed by more than `bound`, and by how
 * much at worst, px/s.
 */
export type SlideRow = {
  engine: string
  scene: string
  slides: number
  slowed: number
  worst: number
  bound: number
}

const isSlide = ({ slider }: HardScene) => slider !== undefined
export const slideScenes = hardScenes.filter(({ name }) => name.startsWith('seams'))

export async function slideRows(name: string, scenes: HardScene[], seeds: number): Promise<SlideRow[]> {
  const engine = await loadEngine(name)
  return scenes.filter(isSlide).map((scene) => {
    const { slider = 0, bounds } = scene
    const bound = bounds.slowed!
    const slowed = Array.from({ length: Math.min(scene.seeds, seeds) }, (_, i) => {
      const unmeasured = { ...scene, measures: [], measure: () => [] }
      const { trajectory } = simulateScene(engine, unmeasured, engine.settings[0], i + 1)
      const frames = Array.from({ length: trajectory.frames }, (_, k) => k + 1)
      return Math.max(
        ...frames.map((k) => slowedBy(scene, trajectory.chips[slider], k, trajectory.state(k, slider).vx)),
      )
    })
    return {
      engine: engine.name,
      scene: scene.name,
      slides: slowed.length,
      slowed: slowed.filter((by) => !(by <= bound)).length,
      worst: Number(Math.max(...slowed).toPrecision(3)),
      bound,
    }
  })
}

import { type Scene, Trajectory } from '../../scenes/scene'
import type { Engine, Setting } from '../engines/engine'

/** Runs a scene and keeps every frame, and the sum of what the engine says it did. */
export function simulateScene(engine: Engine, scene: Scene, setting: Setting, seed = 1) {
  const trajectory = new Trajectory(scene, scene.build(seed))
  const run = engine.start(scene, trajectory.chips, setting, false)
  const work: Record<string, number> = {}
  try {
    for (let k = 1; k <= trajectory.frames; k++) {
      run.step()
      run.read(trajectory.at(k))
      for (const [key, value] of Object.entries(run.work?.() ?? {})) work[key] = (work[key] ?? 0) + value
    }
  } finally {
    run.free()
  }
  return { trajectory, work }
}

export function median(values: number[]) {
  const sorted = [...values].sort((a, b) => a - b)
  const middle = (sorted.length - 1) / 2
  return (sorted[Math.floor(middle)] + sorted[Math.ceil(middle)]) / 2
}

/** The scene's errors over its seeds, one number a measure. NaN counts as infinitely wrong. */
export function sceneErrors(engine: Engine, scene: Scene, setting: Setting, seeds = scene.seeds) {
  const perSeed: number[][] = []
  for (let seed = 1; seed <= Math.min(seeds, scene.seeds); seed++) {
    const { trajectory } = simulateScene(engine, scene, setting, seed)
    perSeed.push(
      scene.measure(trajectory).map((value) => (Number.isNaN(value) ? Number.POSITIVE_INFINITY : value)),
    )
  }
  return scene.measures.map((measure, i) => {
    const values = perSeed.map((row) => row[i])
    return measure.over === 'median' ? median(values) : Math.max(...values)
  })
}

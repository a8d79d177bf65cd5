import { simulateScene } from '@/bench/accuracy/trajectory'
import { ours } from '@/bench/engines/ours'
import type { Scene, Trajectory } from '@/scenes/scene'

/** A named scene through the component's solver, every frame kept, as the benchmark runs it. */
export const trajectoryOf = (scene: Scene, seed = 1): Trajectory =>
  simulateScene(ours, scene, {}, seed).trajectory

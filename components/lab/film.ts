import { filmScene } from '@/bench/accuracy/trajectory'
import { ours } from '@/bench/engines/ours'
import type { Film, Scene } from '@/scenes/scene'

/** A named scene through the component's solver, every frame kept, as the benchmark runs it. */
export const filmOf = (scene: Scene, seed = 1): Film => filmScene(ours, scene, {}, seed).film

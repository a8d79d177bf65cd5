// Five named scenes, each with the step at which it sleeps and the hash of its poses then: the same bits in
// every JavaScript engine. pins.json holds them.
import { sceneNamed } from '../../../scenes'
import { frame } from '../../../scenes/scene'
import type { createWorld } from '../world'

export const pinned = ['topple', 'slide', 'stack-10', 'pour-pills-60', 'pour-mixed-60'] as const

export type Pin = { steps: number; hash: string }

/** Runs a scene with sleep until all rest, for 10 s at most. */
export function fingerprint(name: string, create: typeof createWorld): Pin {
  const scene = sceneNamed(name)
  // In the air of a page: without, a disc may roll for a long while.
  const air = { linearDamping: undefined, angularDamping: undefined }
  const world = create({ width: scene.width, height: scene.height, ...scene.conditions, ...air })
  for (const chip of scene.build(1)) world.add(chip)
  let steps = 0
  while (!world.resting && steps < 600) {
    world.step(frame)
    steps++
  }
  return { steps, hash: world.hash() }
}

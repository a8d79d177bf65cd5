import { reach, releasePose, releaseTime } from '@/registry/gravity-stack/drop'
import { createWorld } from '@/registry/gravity-stack/world'
import { cornerRadius, type Shape } from '@/scenes/exact-distance'
import { frame } from '@/scenes/scene'

type PileOptions = {
  width: number
  height: number
  gravity: number
  bounce: number
  friction: number
  /** ms between releases. */
  stagger: number
  /** Another number, another drop; 0 gives the component's own. */
  seed: number
}

export type Pile = ReturnType<typeof createPile>

/** The component's drop and solver without its stage: time passes only when `step` is called. */
export function createPile(options: PileOptions, shapes: Shape[]) {
  const world = createWorld(options)
  const turn = (chip: number) => chip + 1000 * options.seed
  const ids: number[] = []
  let clock = 0

  function release(chip: number) {
    const shape = { ...shapes[chip], radius: cornerRadius(shapes[chip]) }
    const above = ids.map((id, other) => {
      const { x, y } = world.read(id)
      return { x, y, reach: reach(shapes[other].width, shapes[other].height) }
    })
    const { walls, gravity } = world.scene
    const pose = releasePose(turn(chip), shape.width, shape.height, walls.width, gravity, above)
    ids.push(world.add({ ...shape, ...pose }))
  }

  return {
    world,
    shapes,
    /** Ids of the chips in the world, in the order of the shapes. */
    ids,
    /** True when all are released and asleep. */
    get resting() {
      return ids.length === shapes.length && world.resting
    },
    /** One frame of 1/60 s. */
    step() {
      clock += frame
      while (
        ids.length < shapes.length &&
        releaseTime(turn(ids.length), (ids.length * options.stagger) / 1000) <= clock
      ) {
        release(ids.length)
      }
      world.step(frame)
    },
  }
}

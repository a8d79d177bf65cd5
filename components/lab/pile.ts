import { createLookAhead, uprightTurn } from '@/registry/gravity-stack/stage/look-ahead'
import { addReleased, type Release, reach, releaseTime } from '@/registry/gravity-stack/stage/release'
import { createWorld } from '@/registry/gravity-stack/world'
import { cornerRadius, halfExtent, type Shape } from '@/scenes/exact-distance'
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

/** `turn` is by how many rad what is drawn of a chip is turned on its body, `seen` whether that stays. */
type Drop = Release & { turn: number; seen: boolean }

export type Pile = ReturnType<typeof createPile>

/** The component's drop, look-ahead and solver without its stage: time passes only when `step` is called. */
export function createPile(options: PileOptions, shapes: Shape[]) {
  const world = createWorld(options)
  const ids: number[] = []
  /** By the ids of their bodies. */
  const chips: Drop[] = []
  const coming = {
    chips: shapes.map((shape, chip): Drop => {
      const order = chip + 1000 * options.seed
      return {
        ...shape,
        radius: cornerRadius(shape),
        reach: reach(shape.width, shape.height),
        order,
        due: releaseTime(order, (chip * options.stagger) / 1000),
        id: -1,
        turn: 0,
        seen: false,
      }
    }),
    clock: 0,
    revision: 0,
  }
  const lookAhead = createLookAhead<Drop>(() => {})

  return {
    world,
    shapes,
    /** Ids of the chips in the world, in the order of the shapes. */
    ids,
    /** True when all are released and asleep. */
    get resting() {
      return !coming.chips.length && world.resting
    },
    /** One frame of 1/60 s. */
    step() {
      coming.clock += frame
      while (coming.chips[0]?.due <= coming.clock) {
        const next = coming.chips.shift()!
        next.id = addReleased({ world, chips }, next, world.scene.width, world.scene.gravity[1])
        ids.push(next.id)
      }
      world.step(frame)
    },
    /**
     * Lets the look-ahead go on for a slice, and turns what is still above the stage by it; returns whether
     * it is far enough ahead.
     */
    plan() {
      const { width, gravity } = world.scene
      const done = lookAhead.advance({ world, chips }, coming, width, gravity[1])
      for (const chip of ids.map((id) => chips[id])) {
        const { y, angle } = world.read(chip.id)
        chip.seen ||= y + halfExtent(chip, angle)[1] > 0
        if (!chip.seen) chip.turn = uprightTurn(chip, lookAhead.expectedAngle(chip) ?? 0)
      }
      return done
    },
    /** Of a body: rad that it is drawn turned by, and the angle at which its words are expected to lie. */
    turned(id: number) {
      const { turn } = chips[id]
      const expected = lookAhead.expectedAngle(chips[id])
      return { turn, expected: expected === undefined ? undefined : expected + turn }
    },
  }
}

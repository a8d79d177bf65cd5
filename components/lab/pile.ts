import { createLookAhead, uprightTurn } from '@/registry/gravity-stack/stage/look-ahead'
import { addReleased, type Release, reach, releaseTime } from '@/registry/gravity-stack/stage/release'
import { createWorld } from '@/registry/gravity-stack/world'
import { cornerRadius, halfExtent, type Shape } from '@/scenes/exact-distance'
import { frame } from '@/scenes/scene'

type PileOptions = {
  width: number
  height: number
  gravity: number | { x: number; y: number }
  ceiling?: boolean
  bounce: number
  friction: number
  /** ms between releases. */
  stagger: number
  /** Another number, another drop; 0 gives the component's own. */
  seed: number
}

/** px: centre, size and corner radius of what chips land on. */
export type Obstacle = { x: number; y: number; width: number; height: number; radius: number }

/**
 * A chip on its way into the pile. `place` is its index among the shapes, `turn` (rad) is how far its words
 * are turned on its body, and `seen` says that it is in view, so that `turn` may no longer change.
 */
type Drop = Release & { place: number; turn: number; seen: boolean }

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
        place: chip,
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
  let obstacle: { id: number; body: Obstacle } | undefined
  /** Whether chips that had left by the top have come back since something was done to the pile. */
  let recovered = false

  function release(chip: Drop) {
    chip.id = addReleased({ world, chips }, chip)
    ids[chip.place] = chip.id
  }

  /** Releases chips anew that lie above a stage whose gravity does not bring them back. */
  function recover() {
    const { x, y } = world.gravity
    if (y > Math.abs(x) || recovered) return
    recovered = true
    for (const id of [...ids]) {
      const chip = chips[id]
      if (world.read(id).y >= -chip.reach) continue
      world.remove(id)
      delete chips[id]
      chip.seen = false
      release(chip)
    }
  }

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
      while (coming.chips[0]?.due <= coming.clock) release(coming.chips.shift()!)
      world.step(frame)
      if (!coming.chips.length && world.resting) recover()
    },
    /** Something is done to the pile, after which chips may be released anew once more. */
    touch() {
      recovered = false
    },
    /** What chips land on, beside floor and walls. */
    get obstacle() {
      return obstacle?.body
    },
    setObstacle(body: Obstacle | undefined) {
      if (!body) {
        if (obstacle) world.remove(obstacle.id)
        obstacle = undefined
        return
      }
      if (obstacle) {
        world.place(obstacle.id, { x: body.x, y: body.y })
        world.reshape(obstacle.id, body)
      }
      obstacle = { id: obstacle?.id ?? world.add({ ...body, density: Number.POSITIVE_INFINITY }), body }
      // Also in a paused pile nothing may stay inside it.
      world.makeRoom()
    },
    /**
     * Lets the look-ahead go on for a slice, and turns what is still above the stage by it; returns whether
     * it is far enough ahead.
     */
    plan() {
      const done = lookAhead.advance({ world, chips }, coming)
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

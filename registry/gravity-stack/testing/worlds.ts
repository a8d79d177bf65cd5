// What the tests of the rooms share: worlds filled with a scene's chips, and what any correct answer has.
import { type Shape, type Stage, stageDistance, worstOverlap } from '../../../scenes/exact-distance'
import { massOf } from '../../../scenes/references'
import { type Chip, frame } from '../../../scenes/scene'
import { createWorld, type World, type WorldOptions } from '../world'

export const stage = { width: 640, height: 340 }

/** A world with these chips in it, and their ids. */
export function worldOf(chips: Chip[], options: Partial<WorldOptions> = {}) {
  const world = createWorld({ ...stage, ...options })
  return { world, ids: chips.map((chip) => world.add(chip)) }
}

/** Frames until all sleep; `limit` if they don't. */
export function settle(world: World, limit = 360) {
  let frames = 0
  while (!world.resting && frames < limit) {
    world.step(frame)
    frames++
  }
  return frames
}

export function run(world: World, seconds: number) {
  for (let k = 0; k < Math.round(seconds / frame); k++) world.step(frame)
}

export const readAll = (world: World, ids: number[]) => ids.map((id) => world.read(id))

export const overlap = (world: World, ids: number[], shapes: Shape[], bounds: Stage = stage) =>
  worstOverlap(shapes, readAll(world, ids), bounds)

/** px, how far the farthest chip is outside the stage. */
export function outside(world: World, ids: number[], shapes: Shape[], bounds: Stage = stage) {
  return Math.max(
    0,
    ...ids.map((id, i) => -Math.min(...Object.values(stageDistance(shapes[i], world.read(id), bounds)))),
  )
}

/** Kinetic and potential energy over the floor, in units of density · px⁴/s². */
export function energy(world: World, ids: number[], shapes: Chip[], gravity = 2600, floor = stage.height) {
  return ids.reduce((sum, id, i) => {
    const { mass, inertia } = massOf(shapes[i])
    const { y, vx, vy, spin } = world.read(id)
    return sum + (mass * (vx * vx + vy * vy) + inertia * spin * spin) / 2 + mass * gravity * (floor - y)
  }, 0)
}

export const finite = (world: World, ids: number[]) =>
  readAll(world, ids).every(({ x, y, angle, vx, vy, spin }) =>
    Number.isFinite(x + y + angle + vx + vy + spin),
  )

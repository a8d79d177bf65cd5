import { STEP } from '../solver/constants'
import { type Box, within } from '../solver/input'
import type { World } from '../solver/world'

// Each chip starts at the same place and time for the same stage and chips, in every browser. So this module
// uses + − × ÷ √ alone, and a release falls in the middle of a step of the world, where no rounding of frame
// times moves it to another step.

/** Share of the width between two releases, 1/φ. Any releases in a row cover the stage evenly (D-063). */
const GOLDEN_SHARE = 0.6180339887498949
/** The farthest that a release strays from its place, as a share of the width (D-063). */
const STRAY = 0.05
/** s, the longest time that a release comes late (D-063). */
const LATE = 0.12
/** px between a chip and the top edge of the stage: the least, and the most that is added to it (D-063). */
const CLEARANCE = 24
const CLEARANCE_SCATTER = 120
/** rad, the largest tilt either way. `releasePose` takes its sine as 1/4 (D-063). */
const TILT = 0.25
/** px/s, the largest speed to either side (D-063). */
const DRIFT = 40
/** rad/s, the largest spin either way (D-063). */
const TWIST = 1.2
/** px/s² below which gravity brings no chip into view, and px/s with which a chip starts instead (D-063). */
const FAINT_GRAVITY = 100
const FAINT_SPEED = 240

/**
 * A number in [0, 1) for two integers: squares times an irrational number leave fractions without a pattern.
 */
export function scatter(index: number, channel: number): number {
  const n = index * 8 + channel + 1
  return (n * n * GOLDEN_SHARE) % 1
}

/** s since the drop began: time of the release with this index, at `slot` or a little later. */
export function releaseTime(index: number, slot: number): number {
  return (Math.floor((slot + LATE * scatter(index, 0)) / STEP) + 0.5) * STEP
}

/** px, from the centre of a box to its corners. A square root has the same bits in every engine. */
export function reach(width: number, height: number) {
  return Math.sqrt(width * width + height * height) / 2
}

/** A body that is released into a world, and when. */
export interface Release {
  /** px: border box, corner radius, half the diagonal. The width is 0 while the chip has no size. */
  width: number
  height: number
  radius: number
  reach: number
  /** Number of the release, and its time on the stage's clock, s. */
  order: number
  due: number
  /** Of the body in the world, or -1. */
  id: number
}

/** Pose and velocity of the release with this index, clear of everything that is still above the stage. */
export function releasePose(
  index: number,
  width: number,
  height: number,
  stageWidth: number,
  gravity: number,
  taken: Box[],
) {
  // A chip that is too long to turn between the walls falls level: tilted, it would jam above the stage.
  const turns = width * width + height * height < stageWidth * stageWidth
  const either = (channel: number) => (turns ? 2 * scatter(index, channel) - 1 : 0)
  const halfWidth = width / 2 + height / 8
  const halfHeight = height / 2 + width / 8
  const share = within((((index + 0.5) * GOLDEN_SHARE) % 1) + STRAY * either(1), 0, 1, 0)
  const x = stageWidth / 2 + (share - 0.5) * Math.max(stageWidth - 2 * halfWidth, 0)
  let y = -halfHeight - CLEARANCE - CLEARANCE_SCATTER * scatter(index, 2)
  // In the order of their tops, the lowest first: the release only moves up, so it stays clear of those it
  // has passed.
  taken.sort((a, b) => b[1] - a[1])
  for (const [left, top, right, bottom] of taken)
    if (left < x + halfWidth && right > x - halfWidth && top < y + halfHeight && bottom > y - halfHeight)
      y = top - halfHeight - 1
  return {
    x,
    y,
    angle: TILT * either(3),
    vx: DRIFT * either(4),
    vy: gravity < FAINT_GRAVITY ? FAINT_SPEED : 0,
    spin: TWIST * either(5),
  }
}

/** A world, and what was released into it by the ids of the bodies. */
export interface Pile<T extends Release = Release> {
  world: World
  chips: T[]
}

/** Puts a body into a pile, clear of all that is still above the stage; returns its id. */
export function addReleased<T extends Release>({ world, chips }: Pile<T>, next: T): number {
  const taken: Box[] = []
  chips.forEach(({ reach }, id) => {
    const { x, y } = world.read(id)
    if (y < reach) taken.push([x - reach, y - reach, x + reach, y + reach])
  })
  // Nothing starts in an obstacle.
  taken.push(...world.obstacleBoxes())
  const { order, width, height } = next
  const pose = releasePose(order, width, height, world.scene.width, world.gravity.y, taken)
  const id = world.add({ ...next, ...pose })
  chips[id] = next
  return id
}

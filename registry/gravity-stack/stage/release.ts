import { STEP } from '../solver/constants'
import type { World } from '../solver/world'

// Where and when each chip starts: the same for the same stage and chips, in every browser.
// So there is + − × ÷ √ only in here, and a release falls in the middle of a step of the world:
// no rounding of frame times can move it to another one.

/** Share of the width between one release and the next, 1/φ: every run of releases covers the stage evenly. */
const GOLDEN_SHARE = 0.6180339887498949
/** Most that a release strays from its place, as a share of the width. */
const STRAY = 0.05
/** s, most that a release comes late. */
const LATE = 0.12
/** px between the top edge of the stage and the lower edge of a chip: least, and what scatter adds. */
const CLEARANCE = 24
const CLEARANCE_SCATTER = 120
/** rad either way. The release box below takes its sine as 1/4. */
const TILT = 0.25
/** px/s either way. */
const DRIFT = 40
/** rad/s either way. */
const TWIST = 1.2
/** px/s² below which gravity alone would not bring a chip into view, and px/s that it starts with instead. */
const FAINT_GRAVITY = 100
const FAINT_SPEED = 240

/** A number in [0, 1) for two integers: squares times an irrational number leave fractions without a pattern. */
export function scatter(index: number, channel: number): number {
  const n = index * 8 + channel + 1
  return (n * n * GOLDEN_SHARE) % 1
}

/** Time of the release with this index, whose turn is at `slot`; both in s since the stage began. */
export function releaseTime(index: number, slot: number): number {
  return (Math.floor((slot + LATE * scatter(index, 0)) / STEP) + 0.5) * STEP
}

/** Distance of the farthest point of a box from its centre, px. By √, which is the same in every engine. */
export function reach(width: number, height: number) {
  return Math.sqrt(width * width + height * height) / 2
}

/** What is released, and how. */
export interface Release {
  /** Border box, corner radius and half the diagonal, px. Zero width: not measured, or nothing to see. */
  width: number
  height: number
  radius: number
  reach: number
  /** Number of its release, and its time on the stage's clock, s. */
  order: number
  due: number
  /** In the world, or -1. */
  id: number
}

/** Something in the way of a release: its centre and the distance of its farthest point from it, px. */
export interface Obstacle {
  x: number
  y: number
  reach: number
}

/** Pose and velocity of the release with this index, clear of everything that is still above the stage. */
export function releasePose(
  index: number,
  width: number,
  height: number,
  stageWidth: number,
  gravity: number,
  obstacles: Obstacle[],
) {
  // A chip too long to turn between the walls falls level: it would jam between them, out of sight.
  const turns = width * width + height * height < stageWidth * stageWidth
  const either = (channel: number) => (turns ? 2 * scatter(index, channel) - 1 : 0)
  const halfWidth = width / 2 + height / 8
  const halfHeight = height / 2 + width / 8
  const share = Math.min(Math.max((((index + 0.5) * GOLDEN_SHARE) % 1) + STRAY * either(1), 0), 1)
  const x = stageWidth / 2 + (share - 0.5) * Math.max(stageWidth - 2 * halfWidth, 0)
  let y = -halfHeight - CLEARANCE - CLEARANCE_SCATTER * scatter(index, 2)
  // From the lowest top to the highest: whatever has been cleared once stays clear.
  obstacles.sort((a, b) => b.y - b.reach - a.y + a.reach)
  for (const other of obstacles) {
    if (Math.abs(other.x - x) < halfWidth + other.reach && Math.abs(other.y - y) < halfHeight + other.reach)
      y = other.y - other.reach - halfHeight - 1
  }
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

/** Puts something into a pile where its release says, clear of all that is still above the stage there; returns the id of its body. */
export function addReleased<T extends Release>(
  { world, chips }: Pile<T>,
  next: T,
  stageWidth: number,
  gravity: number,
): number {
  const obstacles: Obstacle[] = []
  chips.forEach(({ reach }, id) => {
    const { x, y } = world.read(id)
    if (y < reach) obstacles.push({ x, y, reach })
  })
  const { order, width, height, radius } = next
  const pose = releasePose(order, width, height, stageWidth, gravity, obstacles)
  const id = world.add({ width, height, radius, ...pose })
  chips[id] = next
  return id
}

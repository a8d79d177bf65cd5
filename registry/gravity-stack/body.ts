import { STANDING, STEP } from './constants'

/**
 * Bodies live in flat arrays, one record each. Body 0 is the stage itself: it has no inverse mass and never moves,
 * so that a wall is a contact like any other.
 *
 * A chip is a core rectangle (half extents `HX`, `HY`) swept by a radius: disc, pill, rounded box and box in one family.
 */

/**
 * Mask for indices read from a list. It changes none, but tells the compiler that offsets computed from one can't overflow,
 * which saves it a check at every access.
 */
export const INDEX = 0xffffff

// Record of `state`, read by every sweep: one cache line a body.
export const X = 0
export const Y = 1
export const ANGLE = 2
export const VX = 3
export const VY = 4
export const SPIN = 5
export const INV_MASS = 6
export const INV_INERTIA = 7
export const STATE = 8

// Record of `motion`, read once a sub-step.
/** Change of velocity that the contacts give in a sub-step: the warm start, summed up by body. */
export const PUSH_X = 0
export const PUSH_Y = 1
export const PUSH_SPIN = 2
/** Velocity after gravity, drag and warm start: what the sweep starts from. */
export const KICK_X = 3
export const KICK_Y = 4
export const KICK_SPIN = 5
/** Displacement of this sub-step without what the sweep adds. */
export const DRIFT_X = 6
export const DRIFT_Y = 7
export const DRIFT_ANGLE = 8
/** Orientation as a unit vector, and the angle it stands for. */
export const COS = 9
export const SIN = 10
export const TURNED = 11
/** px, way of the farthest point of the core so far, in steps that `tally` noticed, and where it will stand after the coming sub-step. */
export const TRAVEL = 12
export const HORIZON = 13
/** The pose up to which that way counts. */
export const SEEN_X = 14
export const SEEN_Y = 15
export const SEEN_ANGLE = 16
/** Change of spin that rolling resistance gives in a sub-step. */
export const BRAKE = 17
export const MOTION = 18

// Record of `shape`.
export const HX = 0
export const HY = 1
export const RADIUS = 2
/** Distance of the farthest point from the centre. */
export const EXTENT = 3
/** Distance of the core's farthest point: turning by θ moves no point of the outline by more than this times θ. */
export const CORE = 4
export const SHAPE = 5

/** Before all turns of a sub-step's sweeps. */
export const NEVER = -0x40000000

/**
 * A class, as all that the solver reads at every contact: V8 forgets what it knows of the fields of an object written out in
 * braces when it makes the second one, and throws all code away that was compiled for the first.
 */
export class Bodies {
  /** Slots in use, body 0 included; a slot of a removed body counts until it is used again. */
  count = 1
  state: Float64Array = new Float64Array(STATE)
  motion: Float64Array = new Float64Array(MOTION)
  shape: Float64Array = new Float64Array(SHAPE)
  /** Pose at the start of the step (x, y, angle), for drawing between steps. */
  before: Float64Array = new Float64Array(3)
  /** Pose that rest is measured against (x, y, angle), and how long it has held, s. */
  rest: Float64Array = new Float64Array(4)
  /** Mass a px². */
  density: Float64Array = new Float64Array(1)
  /** 1 while the slot holds a body. */
  alive: Uint8Array = new Uint8Array(1)
  asleep: Uint8Array = new Uint8Array(1)
  /** Turn of the contact that last changed the body's velocity in the present sub-step, 0 if it set out in motion, or `NEVER`. */
  stirred: Int32Array = new Int32Array(1).fill(NEVER)
  /** 1 if the body had moved noticeably when `tally` last looked. */
  moved: Uint8Array = new Uint8Array(1)
  /** Who is awake. */
  awake: Int32Array = new Int32Array(1)
  awakeCount = 0
  /** 1 if the body has a better footing, as its step begins, than one point that it stands up on. */
  footing: Uint8Array = new Uint8Array(1)
  /** Hands that hold the body. */
  held: Uint8Array = new Uint8Array(1)
  /** 1 if the body has moved since it was last drawn. */
  undrawn: Uint8Array = new Uint8Array(1)
  /** Steps in a row in which partings have left the island of the body deep in itself. */
  jams: Int32Array = new Int32Array(1)
}

/** Makes every array of `owner` so many times as long. */
export function grow(owner: object, times: number): void {
  const named = owner as Record<string, Int32Array>
  for (const name in named) {
    const from = named[name]
    if (!ArrayBuffer.isView(from)) continue
    named[name] = new (from.constructor as typeof Int32Array)(from.length * times)
    named[name].set(from)
  }
}

/**
 * Sets the shape of body `i` from its outer size and corner radius (px) and its mass from its area.
 * Area and second moment are the rounded rectangle's own: core, four slabs and four quarter discs.
 */
export function setShape(
  bodies: Bodies,
  i: number,
  width: number,
  height: number,
  radius: number,
  density: number,
): void {
  const r = Math.max(0, Math.min(radius, width / 2, height / 2))
  const hx = width / 2 - r
  const hy = height / 2 - r
  const s = i * SHAPE
  bodies.shape[s + HX] = hx
  bodies.shape[s + HY] = hy
  bodies.shape[s + RADIUS] = r
  const core = hx * hx + hy * hy
  bodies.shape[s + CORE] = Math.sqrt(core)
  bodies.shape[s + EXTENT] = Math.sqrt(core) + r

  // The four corners together are one disc.
  const corner = Math.PI * r * r
  const area = 4 * hx * hy + 4 * hx * r + 4 * hy * r + corner
  // ∫x²+y² over the core, over the slabs left/right and above/below, and over the corners.
  const inner = (4 * hx * hy * (hx * hx + hy * hy)) / 3
  const sides = (4 * r * hy * (hy * hy + (r * r) / 4)) / 3 + 4 * r * hy * (hx + r / 2) * (hx + r / 2)
  const caps = (4 * r * hx * (hx * hx + (r * r) / 4)) / 3 + 4 * r * hx * (hy + r / 2) * (hy + r / 2)
  // A quarter disc's centre of area lies 4r/3π from its corner along each axis.
  const corners = corner * (hx * hx + hy * hy + (r * r) / 2) + (8 * r * r * r * (hx + hy)) / 3
  const mass = density * area
  const inertia = density * (inner + sides + caps + corners)
  bodies.state[i * STATE + INV_MASS] = 1 / mass
  bodies.state[i * STATE + INV_INERTIA] = 1 / inertia
}

/** px, where the right wall is for body `i`: one that fits at no turn has it as far off as it needs at any. */
export function farWall(shape: Float64Array, i: number, width: number): number {
  const s = i * SHAPE
  return 2 * (Math.min(shape[s + HX], shape[s + HY]) + shape[s + RADIUS]) > width
    ? 2 * shape[s + EXTENT]
    : width
}

/** Orientation of body `i` from its angle by + − × ÷ alone, because Math.sin is not the same in every engine. Error below 1e-15 within a turn, 1e-13 within 150. */
export function orient(state: Float64Array, motion: Float64Array, i: number): void {
  const angle = state[i * STATE + ANGLE]
  const quarter = Math.round(angle / (Math.PI / 2))
  // At most 0.79 rad from the nearest quarter turn: the series is short there.
  const a = angle - quarter * (Math.PI / 2)
  const aa = a * a
  const sin =
    a *
    (1 -
      (aa / 6) *
        (1 -
          (aa / 20) *
            (1 - (aa / 42) * (1 - (aa / 72) * (1 - (aa / 110) * (1 - (aa / 156) * (1 - aa / 210)))))))
  const cos =
    1 -
    (aa / 2) *
      (1 -
        (aa / 12) *
          (1 -
            (aa / 30) *
              (1 - (aa / 56) * (1 - (aa / 90) * (1 - (aa / 132) * (1 - (aa / 182) * (1 - aa / 240)))))))
  const odd = quarter % 2 !== 0
  const back = quarter - 4 * Math.floor(quarter / 4)
  const m = i * MOTION
  motion[m + COS] = (odd ? sin : cos) * (back === 1 || back === 2 ? -1 : 1)
  motion[m + SIN] = (odd ? cos : sin) * (back > 1 ? -1 : 1)
  motion[m + TURNED] = angle
}

/** Puts body `i` at a pose with a velocity, as if it had always been there. */
export function setPose(bodies: Bodies, i: number, x: number, y: number, angle: number): void {
  const s = i * STATE
  bodies.state[s + X] = x
  bodies.state[s + Y] = y
  bodies.state[s + ANGLE] = angle
  orient(bodies.state, bodies.motion, i)
  bodies.before.set([x, y, angle], i * 3)
  bodies.rest.set([x, y, angle, 0], i * 4)
}

/**
 * Brings the orientation of body `i` up to its angle. tan(θ/2) by a short series, the half-angle formulas are then an
 * exact rotation: off by 2e-11 rad a call at most (turned by 0.3 rad), 1e-15 at the pace of sub-steps, and the vector keeps its length.
 */
export function turn(state: Float64Array, motion: Float64Array, i: number): void {
  const m = i * MOTION
  const angle = state[i * STATE + ANGLE]
  const by = angle - motion[m + TURNED]
  if (by === 0) return
  if (by > 0.3 || by < -0.3) orient(state, motion, i)
  else {
    const bb = by * by
    const t = by * (0.5 + bb * (1 / 24 + bb * (1 / 240 + bb * (17 / 40320 + bb * (31 / 725760)))))
    const k = 2 / (1 + t * t)
    const cos = k - 1
    const sin = t * k
    const c = motion[m + COS] * cos - motion[m + SIN] * sin
    const s = motion[m + SIN] * cos + motion[m + COS] * sin
    // One Newton step keeps the length at 1 against the rounding of thousands of turns.
    const fix = 1.5 - 0.5 * (c * c + s * s)
    motion[m + COS] = c * fix
    motion[m + SIN] = s * fix
  }
  motion[m + TURNED] = angle
}

/** px, half the width and half the height of the box around the body that `halfExtents` looked at. */
export const extents: Float64Array = new Float64Array(2)

/** Leaves in `extents` how far body `i`, `give` px thinner all round, reaches at its present angle, or turned on by up to `swing` px at its end. */
export function halfExtents({ state, motion, shape }: Bodies, i: number, give: number, swing: number): void {
  turn(state, motion, i)
  const c = Math.abs(motion[i * MOTION + COS])
  const n = Math.abs(motion[i * MOTION + SIN])
  const hx = shape[i * SHAPE + HX]
  const hy = shape[i * SHAPE + HY]
  const r = shape[i * SHAPE + RADIUS] - give
  const core = shape[i * SHAPE + CORE]
  extents[X] = Math.min(core, hx * c + hy * n + swing) + r
  extents[Y] = Math.min(core, hx * n + hy * c + swing) + r
}

/** px/s, bound of the speed of the fastest point of body `i`. */
export function speedOf({ state, shape }: Bodies, i: number): number {
  const s = i * STATE
  return (
    Math.abs(state[s + VX]) + Math.abs(state[s + VY]) + shape[i * SHAPE + EXTENT] * Math.abs(state[s + SPIN])
  )
}

/** No body moves faster than `most` px/s. */
export function capSpeed(state: Float64Array, s: number, most: number): void {
  const vx = state[s + VX]
  const vy = state[s + VY]
  const square = vx * vx + vy * vy
  if (square > most * most) {
    const k = most / Math.sqrt(square)
    state[s + VX] = vx * k
    state[s + VY] = vy * k
  }
}

/** Notes how far the bodies `list[from..to)` have come, and how far they may be `ahead` seconds on: contacts go by it. */
export function tally(bodies: Bodies, list: Int32Array, from: number, to: number, ahead: number): void {
  const { state, motion, shape, moved } = bodies
  const standing = STANDING * ahead
  for (let n = from; n < to; n++) {
    const i = list[n] & INDEX
    const s = i * STATE
    const m = i * MOTION
    const x = state[s + X]
    const y = state[s + Y]
    const angle = state[s + ANGLE]
    const core = shape[i * SHAPE + CORE]
    const way =
      Math.abs(x - motion[m + SEEN_X]) +
      Math.abs(y - motion[m + SEEN_Y]) +
      core * Math.abs(angle - motion[m + SEEN_ANGLE])
    moved[i] = 0
    if (way > standing) {
      moved[i] = 1
      motion[m + TRAVEL] += way
      motion[m + SEEN_X] = x
      motion[m + SEEN_Y] = y
      motion[m + SEEN_ANGLE] = angle
    }
    motion[m + HORIZON] =
      motion[m + TRAVEL] +
      ahead * (Math.abs(state[s + VX]) + Math.abs(state[s + VY]) + core * Math.abs(state[s + SPIN]))
  }
}

/** What air does to a body in a time `h`: v ← fade·v + g·reach, x ← x + reach·v + g·fall. Exact for any h. */
export interface Air {
  fade: number
  reach: number
  fall: number
}

/** Closed form of v' = g − c·v over `h` seconds, by series, because Math.exp is not the same in every engine. c·h ≤ 0.5. */
export function air(damping: number, h: number): Air {
  const z = -damping * h
  let term = 1
  let fade = 0
  let reach = 0
  let fall = 0
  for (let k = 0; k < 18; k++) {
    fade += term
    reach += term / (k + 1)
    fall += term / ((k + 1) * (k + 2))
    term *= z / (k + 1)
  }
  return { fade, reach: reach * h, fall: fall * h * h }
}

/** The largest damping (1/s) for which `air` is exact at a whole step. */
export const MAX_DAMPING = 0.5 / STEP

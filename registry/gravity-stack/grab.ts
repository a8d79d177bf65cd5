import {
  ANGLE,
  type Bodies,
  BRAKE,
  COS,
  capSpeed,
  extents,
  farWall,
  halfExtents,
  INV_INERTIA,
  INV_MASS,
  MOTION,
  PUSH_SPIN,
  PUSH_X,
  PUSH_Y,
  SIN,
  SPIN,
  STATE,
  turn,
  VX,
  VY,
  X,
  Y,
} from './body'
import type { Walls } from './collide'
import {
  GRAB_DAMPING,
  GRAB_GRAVITY,
  GRAB_HERTZ,
  GRAB_PRESS,
  GRAB_SAG,
  GRAB_STRENGTH,
  MAX_TOSS,
  STEP,
  THROW_PAUSE,
  THROW_SLACK,
  THROW_SPEED,
  THROW_WINDOW,
} from './constants'

/** What a hand is told of its scene. */
interface Surroundings {
  bodies: Bodies
  walls: Walls
  gravity: number
  h: number
}

/**
 * The soft point constraint of a held chip: a damped spring from the grabbed point to the pointer, solved implicitly
 * (soft constraint after Box2D v3), with a limit to its force, so that a chip pressed into the pile can't crush it.
 */
export interface Hold {
  body: number
  /** Grabbed point in the body's own axes, px from its centre. */
  localX: number
  localY: number
  /** Where the pointer is, and where it was lately. */
  x: number
  y: number
  /** The place nearest to the pointer that the grabbed point can reach within walls and floor. */
  targetX: number
  targetY: number
  samples: { x: number; y: number; seconds: number }[]
  /** s simulated since the pointer last moved. */
  idle: number
  /** Impulse of a sub-step. */
  impulseX: number
  impulseY: number
  /** Arm at which it acts, px. */
  rx: number
  ry: number
}

export function createHold(bodies: Bodies, body: number, x: number, y: number): Hold {
  turn(bodies.state, bodies.motion, body)
  const c = bodies.motion[body * MOTION + COS]
  const s = bodies.motion[body * MOTION + SIN]
  const dx = x - bodies.state[body * STATE + X]
  const dy = y - bodies.state[body * STATE + Y]
  return {
    body,
    localX: c * dx + s * dy,
    localY: c * dy - s * dx,
    x,
    y,
    targetX: x,
    targetY: y,
    samples: [],
    idle: 0,
    impulseX: 0,
    impulseY: 0,
    rx: 0,
    ry: 0,
  }
}

/** px, from the centre of the held body to the grabbed point, as `aim` left it. */
const arm: Float64Array = new Float64Array(2)

/** Finds the arm and the target of `hold` at the body's present angle. Upwards every place is in reach: there is no ceiling. */
function aim({ bodies, walls }: Surroundings, hold: Hold): void {
  const { motion, shape } = bodies
  const { body, localX, localY } = hold
  halfExtents(bodies, body, 0, 0)
  const cos = motion[body * MOTION + COS]
  const sin = motion[body * MOTION + SIN]
  arm[0] = cos * localX - sin * localY
  arm[1] = sin * localX + cos * localY
  const left = extents[X] - GRAB_PRESS
  const right = Math.max(left, farWall(shape, body, walls.width) - left)
  hold.targetX = arm[0] + Math.min(Math.max(hold.x - arm[0], left), right)
  hold.targetY = arm[1] + Math.min(hold.y - arm[1], walls.height - extents[Y] + GRAB_PRESS)
}

/** Prepares the constraint for a sub-step. */
export function prepareHold(scene: Surroundings, hold: Hold): void {
  const { bodies, h } = scene
  const at = hold.body * STATE
  const angle = bodies.state[at + ANGLE]
  // The arm is that at the end of the sub-step, as at a wall: with the one before, a chip that the hand pulls against one rocks ever faster.
  bodies.state[at + ANGLE] +=
    h * (bodies.state[at + SPIN] + 0.5 * bodies.motion[hold.body * MOTION + PUSH_SPIN])
  aim(scene, hold)
  bodies.state[at + ANGLE] = angle
  hold.idle += h
  // In the hand it has no memory of what it rolled on: else it would hang askew.
  bodies.motion[hold.body * MOTION + BRAKE] = 0
  // The impulse carried over acts at the arm as it is now: with the old one a swing would feed itself.
  bodies.motion[hold.body * MOTION + PUSH_SPIN] +=
    bodies.state[at + INV_INERTIA] * ((arm[0] - hold.rx) * hold.impulseY - (arm[1] - hold.ry) * hold.impulseX)
  hold.rx = arm[0]
  hold.ry = arm[1]
}

/** px by which the hand may pull its chip further within a step than it goes by itself; nothing while it merely hangs there. */
export function pull(scene: Surroundings, hold: Hold): number {
  const i = hold.body * STATE
  const s = scene.bodies.state
  aim(scene, hold)
  const away = Math.abs(s[i + X] + arm[0] - hold.targetX) + Math.abs(s[i + Y] + arm[1] - hold.targetY)
  return Math.max(0, Math.min(away - GRAB_SAG, strength(scene.gravity) * STEP * STEP))
}

/** px/s², the most by which a hand accelerates its chip. */
function strength(gravity: number): number {
  return GRAB_STRENGTH * Math.max(Math.abs(gravity), GRAB_GRAVITY)
}

/** The impulse of the last step, added to what the body gets as warm start. */
export function carryHold(bodies: Bodies, hold: Hold): void {
  const m = hold.body * MOTION
  const i = hold.body * STATE
  bodies.motion[m + PUSH_X] += bodies.state[i + INV_MASS] * hold.impulseX
  bodies.motion[m + PUSH_Y] += bodies.state[i + INV_MASS] * hold.impulseY
  bodies.motion[m + PUSH_SPIN] +=
    bodies.state[i + INV_INERTIA] * (hold.rx * hold.impulseY - hold.ry * hold.impulseX)
}

/** One visit of a sweep, in a sub-step of `h` seconds; `gravity` in px/s² sets the scale of its strength. */
export function solveHold(bodies: Bodies, hold: Hold, h: number, gravity: number): void {
  const s = bodies.state
  const i = hold.body * STATE
  const { rx, ry } = hold
  const m = s[i + INV_MASS]
  const n = s[i + INV_INERTIA]
  const omega = 2 * Math.PI * GRAB_HERTZ
  const a1 = 2 * GRAB_DAMPING + h * omega
  const a2 = h * omega * a1
  const soft = 1 / (1 + a2)
  const vx = s[i + VX] - s[i + SPIN] * ry + (omega / a1) * (s[i + X] + rx - hold.targetX)
  const vy = s[i + VY] + s[i + SPIN] * rx + (omega / a1) * (s[i + Y] + ry - hold.targetY)
  const k11 = m + n * ry * ry
  const k12 = -n * rx * ry
  const k22 = m + n * rx * rx
  const det = 1 / (k11 * k22 - k12 * k12)
  let x = hold.impulseX * (1 - soft) - a2 * soft * (k22 * det * vx + -k12 * det * vy)
  let y = hold.impulseY * (1 - soft) - a2 * soft * (-k12 * det * vx + k11 * det * vy)
  const size = Math.sqrt(x * x + y * y)
  const limit = (strength(gravity) * h) / m
  if (size > limit) {
    x *= limit / size
    y *= limit / size
  }
  const dx = x - hold.impulseX
  const dy = y - hold.impulseY
  hold.impulseX = x
  hold.impulseY = y
  s[i + VX] += m * dx
  s[i + VY] += m * dy
  s[i + SPIN] += n * (rx * dy - ry * dx)
}

/** Notes where the pointer is at time `seconds`; samples older than the window are dropped. */
export function recordHold(hold: Hold, x: number, y: number, seconds: number): void {
  const samples = hold.samples
  const since = seconds - (samples[samples.length - 1]?.seconds ?? -Infinity)
  // Who lets go of a button says where it was a little after the last move: that is no stop.
  if (x === hold.x && y === hold.y && since > 0 && since < THROW_PAUSE) return
  hold.x = x
  hold.y = y
  hold.idle = 0
  // A clock may go back, or be too coarse to tell two moves apart.
  while (samples.length > 0 && samples[samples.length - 1]!.seconds >= seconds) samples.pop()
  samples.push({ x, y, seconds })
  while (samples.length > 2 && samples[0]!.seconds < seconds - THROW_WINDOW) samples.shift()
}

/**
 * Sets the velocity with which the body leaves: the pointer's, fitted to its own timestamps, if the body kept up with it; below
 * `THROW_SPEED` the less of that, the slower, as what swings below a hand that stands still swings on. Another hand that still holds the body decides alone.
 */
export function throwVelocity(scene: Surroundings, hold: Hold): void {
  const { bodies } = scene
  const s = bodies.state
  const i = hold.body * STATE
  const samples = hold.samples
  if (bodies.held[hold.body] === 0 && samples.length > 1 && hold.idle < THROW_WINDOW) {
    // By least squares, the slope of the way over time.
    let t = 0
    for (const { seconds } of samples) t += seconds / samples.length
    let tt = 0
    let tx = 0
    let ty = 0
    for (const sample of samples) {
      const off = sample.seconds - t
      tt += off * off
      tx += off * sample.x
      ty += off * sample.y
    }
    // Two samples within 4 ms tell of no speed.
    if (tt > 1e-5) {
      const vx = tx / tt
      const vy = ty / tt
      aim(scene, hold)
      const x = s[i + X] + arm[0]
      const y = s[i + Y] + arm[1]
      // A damped spring trails its target by 2ζ/ω s. A body that is farther behind by half as much again is stuck: the pointer's speed is not its own.
      const trail = (1.5 * 2 * GRAB_DAMPING) / (2 * Math.PI * GRAB_HERTZ)
      const speed = Math.sqrt(vx * vx + vy * vy)
      const near = (toX: number, toY: number) =>
        Math.sqrt((x - toX) * (x - toX) + (y - toY) * (y - toY)) < THROW_SLACK + trail * speed
      const share = Math.min(1, speed / THROW_SPEED)
      // A body that keeps level with a pointer far outside of a wall takes the pointer's velocity along the wall only.
      const close = near(hold.x, hold.y)
      const level = near(hold.targetX, hold.targetY)
      if (close || (level && hold.targetX === hold.x)) s[i + VX] += share * (vx - s[i + VX])
      if (close || (level && hold.targetY === hold.y)) s[i + VY] += share * (vy - s[i + VY])
    }
  }
  capSpeed(s, i, MAX_TOSS)
}

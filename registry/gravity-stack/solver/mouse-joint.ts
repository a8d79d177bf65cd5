import { capSpeed, extents, halfExtents } from './body'
import {
  GRAVITY,
  JOINT_HERTZ,
  JOINT_STRENGTH,
  MAX_TOSS,
  THROW_SPEED,
  THROW_WINDOW,
  WALL_OVERLAP,
} from './constants'
import { updateRotation } from './math'
import {
  ANGLE,
  type Bodies,
  COS,
  INV_INERTIA,
  INV_MASS,
  MOTION,
  type MouseJoint,
  ROLLING_IMPULSE,
  SIN,
  type Simulation,
  SPIN,
  STATE,
  VX,
  VY,
  WARM_SPIN,
  WARM_X,
  WARM_Y,
  X,
  Y,
} from './state'

/**
 * The mouse joint holds a chip: a critically damped spring from the grabbed point to the pointer, solved
 * implicitly, with a limit to its force, so that a chip pressed into the pile can't crush it.
 */

/** rad/s, natural frequency of the spring. */
const OMEGA = 2 * Math.PI * JOINT_HERTZ
/**
 * px that the grabbed point may be off, beside what it trails at the pointer's speed, when its chip is
 * thrown.
 */
const THROW_SLACK = 16
/** s. A report of the same place this long after the pointer's last move is a stop. */
const THROW_PAUSE = 0.025

export function createJoint(bodies: Bodies, body: number, x: number, y: number): MouseJoint {
  updateRotation(bodies, body)
  const cos = bodies.motion[body * MOTION + COS]
  const sin = bodies.motion[body * MOTION + SIN]
  const dx = x - bodies.state[body * STATE + X]
  const dy = y - bodies.state[body * STATE + Y]
  const [localX, localY] = [cos * dx + sin * dy, cos * dy - sin * dx]
  return {
    body,
    localX,
    localY,
    x,
    y,
    targetX: x,
    targetY: y,
    samples: [],
    idle: 0,
    impulseX: 0,
    impulseY: 0,
    armX: dx,
    armY: dy,
  }
}

/**
 * Finds the arm and the target of `joint` at the body's present angle. Without a ceiling every place upwards
 * is in reach.
 */
function aim({ bodies, ceiling, width, height }: Simulation, joint: MouseJoint): void {
  const { motion } = bodies
  const m = joint.body * MOTION
  halfExtents(bodies, joint.body, WALL_OVERLAP, 0)
  const { localX, localY } = joint
  joint.armX = motion[m + COS] * localX - motion[m + SIN] * localY
  joint.armY = motion[m + SIN] * localX + motion[m + COS] * localY
  const x = Math.max(extents[X], Math.min(joint.x - joint.armX, width - extents[X]))
  joint.targetX = joint.armX + x
  const y = Math.min(joint.y - joint.armY, height - extents[Y])
  joint.targetY = joint.armY + (ceiling ? Math.max(y, extents[Y]) : y)
}

/** Prepares the joint for a sub-step. */
export function prepareJoint(simulation: Simulation, joint: MouseJoint): void {
  const { bodies, h } = simulation
  const { state, motion, rest } = bodies
  const s = joint.body * STATE
  const m = joint.body * MOTION
  const angle = state[s + ANGLE]
  const { armX, armY } = joint
  // The arm is that at the end of the sub-step, as at a wall: else a chip pulled against one rocks ever
  // faster.
  state[s + ANGLE] += h * (state[s + SPIN] + 0.5 * motion[m + WARM_SPIN])
  aim(simulation, joint)
  state[s + ANGLE] = angle
  joint.idle += h
  rest[joint.body * 4 + 3] = 0
  // A chip in the hand has no memory of what it rolled on: else it would hang askew.
  motion[m + ROLLING_IMPULSE] = 0
  // The warm start acts at the arm as it is now: with the old one a swing would feed itself.
  motion[m + WARM_SPIN] +=
    state[s + INV_INERTIA] * ((joint.armX - armX) * joint.impulseY - (joint.armY - armY) * joint.impulseX)
}

/** Adds the impulse of the last step to the warm start of the body. */
export function addJointWarmStart({ state, motion }: Bodies, joint: MouseJoint): void {
  const s = joint.body * STATE
  const m = joint.body * MOTION
  motion[m + WARM_X] += state[s + INV_MASS] * joint.impulseX
  motion[m + WARM_Y] += state[s + INV_MASS] * joint.impulseY
  motion[m + WARM_SPIN] +=
    state[s + INV_INERTIA] * (joint.armX * joint.impulseY - joint.armY * joint.impulseX)
}

/** One visit of the joint in an iteration of the contact solver. */
export function solveJoint({ bodies, pull, h }: Simulation, joint: MouseJoint): void {
  const s = bodies.state
  const i = joint.body * STATE
  const { armX, armY } = joint
  const m = s[i + INV_MASS]
  const n = s[i + INV_INERTIA]
  const a1 = 2 + h * OMEGA
  const a2 = h * OMEGA * a1
  const soft = 1 / (1 + a2)
  const vx = s[i + VX] - s[i + SPIN] * armY + (OMEGA / a1) * (s[i + X] + armX - joint.targetX)
  const vy = s[i + VY] + s[i + SPIN] * armX + (OMEGA / a1) * (s[i + Y] + armY - joint.targetY)
  const k11 = m + n * armY * armY
  const k12 = -n * armX * armY
  const k22 = m + n * armX * armX
  const hard = (a2 * soft) / (k11 * k22 - k12 * k12)
  let x = joint.impulseX * (1 - soft) - hard * (k22 * vx - k12 * vy)
  let y = joint.impulseY * (1 - soft) - hard * (k11 * vy - k12 * vx)
  const most = (JOINT_STRENGTH * Math.max(pull, GRAVITY) * h) / m
  const share = Math.min(1, most / Math.sqrt(x * x + y * y))
  // No impulse at all divides by zero, and is within any limit.
  if (share < 1) {
    x *= share
    y *= share
  }
  const dx = x - joint.impulseX
  const dy = y - joint.impulseY
  joint.impulseX = x
  joint.impulseY = y
  s[i + VX] += m * dx
  s[i + VY] += m * dy
  s[i + SPIN] += n * (armX * dy - armY * dx)
}

/** Notes where the pointer is at time `seconds`; samples older than the window are dropped. */
export function movePointer(joint: MouseJoint, x: number, y: number, seconds: number): void {
  const { samples } = joint
  const since = seconds - (samples[samples.length - 1]?.seconds ?? -Infinity)
  // A released button reports its place a little after the last move. That is no stop.
  if (x === joint.x && y === joint.y && since > 0 && since < THROW_PAUSE) return
  joint.x = x
  joint.y = y
  joint.idle = 0
  // A clock may go back, or be too coarse to tell two moves apart.
  while (samples.length > 0 && samples[samples.length - 1]!.seconds >= seconds) samples.pop()
  samples.push({ x, y, seconds })
  while (samples.length > 2 && samples[0]!.seconds < seconds - THROW_WINDOW) samples.shift()
}

/**
 * Sets the velocity with which the body leaves. A body that kept up takes the pointer's, fitted to the
 * timestamps by least squares. Of a slow pointer's it takes a share, so that it swings on. A body that
 * another joint still holds is not thrown.
 */
export function throwBody(simulation: Simulation, joint: MouseJoint): void {
  const { state, held } = simulation.bodies
  const { body, samples } = joint
  const s = body * STATE
  if (held[body] === 0 && samples.length > 1 && joint.idle < THROW_WINDOW) {
    // The slope of the way over time.
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
      const speed = Math.sqrt(tx * tx + ty * ty) / tt
      const share = Math.min(1, speed / THROW_SPEED)
      aim(simulation, joint)
      const x = state[s + X] + joint.armX
      const y = state[s + Y] + joint.armY
      // A damped spring trails its target by 2/ω s. A body half as much farther behind is stuck, and does not
      // go as fast.
      const isNear = (toX: number, toY: number) =>
        Math.sqrt((x - toX) * (x - toX) + (y - toY) * (y - toY)) < THROW_SLACK + (3 / OMEGA) * speed
      const close = isNear(joint.x, joint.y)
      // A body that keeps level with a pointer far outside of a wall takes the pointer's velocity along the
      // wall only.
      const level = isNear(joint.targetX, joint.targetY)
      if (close || (level && joint.targetX === joint.x)) state[s + VX] += share * (tx / tt - state[s + VX])
      if (close || (level && joint.targetY === joint.y)) state[s + VY] += share * (ty / tt - state[s + VY])
    }
  }
  capSpeed(state, s, MAX_TOSS)
}

import { capSpeed } from './body'
import {
  GRAVITY,
  LINEAR_SLOP,
  LOOKAHEAD,
  MAX_SPEED,
  RESTING_SPEED,
  RESTING_TOLERANCE,
  ROCKING_SHARE,
  ROLLING_RESISTANCE,
  ROLLING_SHARE,
  SLOW_CONTACT,
  WRONG_WARM_START,
} from './constants'
import {
  ANGLE,
  CORE,
  DELTA_ANGLE,
  DELTA_X,
  DELTA_Y,
  EXTENT,
  HORIZON,
  INDEX,
  INV_MASS,
  MOTION,
  RADIUS,
  ROLLING_IMPULSE,
  SEEN_ANGLE,
  SEEN_X,
  SEEN_Y,
  SHAPE,
  type Simulation,
  SPIN,
  START_SPIN,
  START_X,
  START_Y,
  STATE,
  STRUCK_AT,
  TRAVEL,
  VX,
  VY,
  WARM_SPIN,
  WARM_X,
  WARM_Y,
  X,
  Y,
} from './state'

/** Value of `changed` for a body whose velocity has not changed: its contacts need no visit. */
const NEVER = -0x40000000

/** Updates the travel of each awake body, and bounds its travel in the coming sub-step. */
export function trackTravel({ bodies, h }: Simulation): void {
  const { state, motion, shape, moved, awake, awakeCount } = bodies
  for (let n = 0; n < awakeCount; n++) {
    const i = awake[n] & INDEX
    const s = i * STATE
    const m = i * MOTION
    const core = shape[i * SHAPE + CORE]
    const way =
      Math.abs(state[s + X] - motion[m + SEEN_X]) +
      Math.abs(state[s + Y] - motion[m + SEEN_Y]) +
      core * Math.abs(state[s + ANGLE] - motion[m + SEEN_ANGLE])
    moved[i] = way > LINEAR_SLOP ? 1 : 0
    if (moved[i] > 0) {
      motion[m + TRAVEL] += way
      motion[m + SEEN_X] = state[s + X]
      motion[m + SEEN_Y] = state[s + Y]
      motion[m + SEEN_ANGLE] = state[s + ANGLE]
    }
    const speed = Math.abs(state[s + VX]) + Math.abs(state[s + VY]) + core * Math.abs(state[s + SPIN])
    motion[m + HORIZON] = motion[m + TRAVEL] + LOOKAHEAD * h * speed
    motion[m + STRUCK_AT] = 0
  }
}

/**
 * Gravity, drag, rolling resistance and warm start: velocities at the end of the sub-step but for the contact
 * solver.
 */
export function integrateVelocities({ bodies, gravity, h, air, spinAir, regime }: Simulation): void {
  const { state, motion, shape, awake, awakeCount, moved, changed, supported } = bodies
  changed.fill(NEVER)
  // A world without air drag, as exact test scenes use, has no rolling resistance either.
  const rolling = spinAir.fade < 1 ? ROLLING_RESISTANCE : 0
  for (let n = 0; n < awakeCount; n++) {
    const i = awake[n] & INDEX
    const s = i * STATE
    const m = i * MOTION
    const vx = state[s + VX]
    const vy = state[s + VY]
    const spin = state[s + SPIN]
    const warmX = motion[m + WARM_X]
    const warmY = motion[m + WARM_Y]
    const warmSpin = motion[m + WARM_SPIN]
    const extent = shape[i * SHAPE + EXTENT]
    // A chip that enters the stage at `ENTRY_SPEED` is static, and gravity does not pull it.
    const pulled = state[s + INV_MASS] > 0 ? 1 : 0
    const gx = pulled * gravity[X]
    const gy = pulled * gravity[Y]
    // Rolling resistance is an impulse against the spin, limited by the load as friction is. A disc at rest
    // has twice the resistance, or it would creep on a slope at the limit for ever.
    const load = Math.abs(warmX) + Math.abs(warmY)
    const slowness = Math.max(0, 1 - (Math.abs(spin) * extent) / SLOW_CONTACT)
    const roundness = shape[i * SHAPE + RADIUS] / extent
    const limit = (rolling * (1 + slowness * roundness) * load) / extent
    // A supported body starts from its last impulse, or a disc on a slope would creep. One balanced on one
    // point starts from none: its spin is damped, not held.
    const last = motion[m + ROLLING_IMPULSE] * supported[i]
    const share = supported[i] > 0 ? ROLLING_SHARE : ROCKING_SHARE
    const freeSpin = spinAir.fade * spin + warmSpin
    const resistance = Math.max(-limit, Math.min(limit, last - share * (freeSpin + last)))
    motion[m + ROLLING_IMPULSE] = resistance
    // A constant force moves a body by half the sub-step times the velocity that it adds.
    motion[m + DELTA_X] = air.reach * vx + gx * air.fall + 0.5 * h * warmX
    motion[m + DELTA_Y] = air.reach * vy + gy * air.fall + 0.5 * h * warmY
    motion[m + DELTA_ANGLE] = spinAir.reach * spin + 0.5 * h * (warmSpin + resistance)
    state[s + VX] = motion[m + START_X] = air.fade * vx + gx * air.reach + warmX
    state[s + VY] = motion[m + START_Y] = air.fade * vy + gy * air.reach + warmY
    state[s + SPIN] = motion[m + START_SPIN] = freeSpin + resistance
    const speed = Math.abs(state[s + VX]) + Math.abs(state[s + VY]) + extent * Math.abs(state[s + SPIN])
    changed[i] = speed > Math.min(regime.tolerance, RESTING_SPEED) || moved[i] > 0 ? 0 : NEVER
  }
}

/**
 * Moves what is awake through the sub-step, and takes what the contact solver changed into the warm start.
 * Returns whether all are in balance: none moves, nor gains speed by what warm start and gravity give.
 */
export function integratePositions({ bodies, gravity, h, pull }: Simulation): boolean {
  const { state, motion, shape, awake, awakeCount, knocked } = bodies
  const wrong = WRONG_WARM_START * Math.max(1, pull / GRAVITY)
  let balanced = true
  for (let n = 0; n < awakeCount; n++) {
    const i = awake[n] & INDEX
    const s = i * STATE
    const m = i * MOTION
    const extent = shape[i * SHAPE + EXTENT]
    const dvx = state[s + VX] - motion[m + START_X]
    const dvy = state[s + VY] - motion[m + START_Y]
    const dSpin = state[s + SPIN] - motion[m + START_SPIN]
    // A wrong warm start was no constant force: all of its velocity counts for the displacement.
    const whole = Math.abs(dvx) + Math.abs(dvy) + extent * Math.abs(dSpin) > wrong ? 0.5 * h : 0
    if (whole > 0) knocked[i] = 1
    state[s + X] += motion[m + DELTA_X] + h * dvx + whole * motion[m + WARM_X]
    state[s + Y] += motion[m + DELTA_Y] + h * dvy + whole * motion[m + WARM_Y]
    state[s + ANGLE] += motion[m + DELTA_ANGLE] + h * dSpin + whole * motion[m + WARM_SPIN]
    motion[m + WARM_X] += dvx
    motion[m + WARM_Y] += dvy
    motion[m + WARM_SPIN] += dSpin
    const speed = Math.abs(state[s + VX]) + Math.abs(state[s + VY]) + extent * Math.abs(state[s + SPIN])
    const gain = Math.abs(motion[m + WARM_X] + gravity[X] * h) + Math.abs(motion[m + WARM_Y] + gravity[Y] * h)
    if (Math.max(speed - RESTING_SPEED, gain - 4 * RESTING_TOLERANCE) > 0) balanced = false
    capSpeed(state, s, MAX_SPEED)
  }
  return balanced
}

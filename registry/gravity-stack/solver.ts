import {
  type Air,
  ANGLE,
  type Bodies,
  DRIFT_ANGLE,
  DRIFT_X,
  DRIFT_Y,
  EXTENT,
  INV_INERTIA,
  INV_MASS,
  KICK_SPIN,
  KICK_X,
  KICK_Y,
  MOTION,
  NEXT,
  PUSH_SPIN,
  PUSH_X,
  PUSH_Y,
  SHAPE,
  SPIN,
  STATE,
  VX,
  VY,
  WAY,
  X,
  Y,
} from './body'
import { CLOSING, MAX_PUSH, MAX_SPEED, PUSH, SLOP } from './constants'
import {
  BASE1,
  BASE2,
  CONTACT,
  type Contacts,
  DRAG,
  INV_DET,
  K11,
  K12,
  K22,
  LOAD1,
  LOAD2,
  MASS_T,
  NA1,
  NA2,
  NB1,
  NB2,
  NX,
  NY,
  POINTS,
  SLACK,
  TA,
  TB,
} from './contacts'

/** Gravity, drag and warm start for the bodies `list[from..to)`: velocities at the end of the sub-step were it not for the sweep. */
export function kick(
  bodies: Bodies,
  list: Int32Array,
  from: number,
  to: number,
  gravity: number,
  air: Air,
  spinAir: Air,
): void {
  const { state, motion } = bodies
  const half = 0.5 * air.h
  for (let a = from; a < to; a++) {
    const s = list[a] * STATE
    const m = list[a] * MOTION
    const vx = state[s + VX]
    const vy = state[s + VY]
    const spin = state[s + SPIN]
    const pushX = motion[m + PUSH_X]
    const pushY = motion[m + PUSH_Y]
    const pushSpin = motion[m + PUSH_SPIN]
    // Smooth forces act evenly through the sub-step, so half their change of velocity counts for the way: exact for
    // constant ones. What the sweep adds counts in full.
    motion[m + DRIFT_X] = air.reach * vx + half * pushX
    motion[m + DRIFT_Y] = air.reach * vy + gravity * air.fall + half * pushY
    motion[m + DRIFT_ANGLE] = spinAir.reach * spin + half * pushSpin
    state[s + VX] = motion[m + KICK_X] = air.fade * vx + pushX
    state[s + VY] = motion[m + KICK_Y] = air.fade * vy + gravity * air.reach + pushY
    state[s + SPIN] = motion[m + KICK_SPIN] = spinAir.fade * spin + pushSpin
  }
}

/**
 * One Gauss–Seidel sweep over the contacts `list[from..to)`: both normals of a manifold together (the 2×2 block of the
 * complementarity problem, by cases), then friction in the interval ±μ·load. With `push`, overlap left by the last move is
 * taken out of the poses first (`separate` in passing, as the gaps are at hand). Returns the largest change of a normal velocity, px/s.
 */
export function sweep(
  bodies: Bodies,
  contacts: Contacts,
  list: Int32Array,
  from: number,
  to: number,
  h: number,
  friction: number,
  push: boolean,
): number {
  const s = bodies.state
  const d = contacts.data
  const pair = contacts.pair
  const perH = 1 / h
  let most = 0
  for (let i = from; i < to; i++) {
    const c = list[i]
    const k = c * CONTACT
    const points = d[k + POINTS]
    if (points === 0) continue
    const a = pair[2 * c] * STATE
    const b = pair[2 * c + 1] * STATE
    const nx = d[k + NX]
    const ny = d[k + NY]
    let spinA = s[a + SPIN]
    let spinB = s[b + SPIN]
    const iia = s[a + INV_INERTIA]
    const iib = s[b + INV_INERTIA]
    const angleA = s[a + ANGLE]
    const angleB = s[b + ANGLE]
    const vx = s[b + VX] - s[a + VX]
    const vy = s[b + VY] - s[a + VY]
    const across = nx * (s[b + X] - s[a + X]) + ny * (s[b + Y] - s[a + Y])
    const speed = nx * vx + ny * vy
    const na1 = d[k + NA1]
    const nb1 = d[k + NB1]
    const l1 = d[k + LOAD1]
    const gap1 = d[k + BASE1] + across + nb1 * angleB - na1 * angleA
    const w1 =
      speed +
      nb1 * spinB -
      na1 * spinA +
      (gap1 > 0 ? (l1 > 0 ? CLOSING * gap1 * perH : gap1 * perH + d[k + SLACK]) : 0)
    const k11 = d[k + K11]
    // A body on its way out, as after an impact, needs no push.
    if (push && gap1 < -SLOP && (w1 <= 0 || gap1 + w1 * h < -SLOP)) part(bodies, s, d, k, a, b, gap1, 0)
    let p1: number
    let normal: number
    let load: number
    if (points === 1) {
      p1 = l1 - w1 / k11
      if (p1 < 0) p1 = 0
      d[k + LOAD1] = p1
      load = p1
      p1 -= l1
      normal = p1
      spinA -= iia * na1 * p1
      spinB += iib * nb1 * p1
      const change = p1 * k11
      if (change > most) most = change
      else if (-change > most) most = -change
    } else {
      const na2 = d[k + NA2]
      const nb2 = d[k + NB2]
      const l2 = d[k + LOAD2]
      const gap2 = d[k + BASE2] + across + nb2 * angleB - na2 * angleA
      const w2 =
        speed +
        nb2 * spinB -
        na2 * spinA +
        (gap2 > 0 ? (l2 > 0 ? CLOSING * gap2 * perH : gap2 * perH + d[k + SLACK]) : 0)
      if (push && gap2 < -SLOP && (w2 <= 0 || gap2 + w2 * h < -SLOP)) part(bodies, s, d, k, a, b, gap2, 1)
      const k12 = d[k + K12]
      const k22 = d[k + K22]
      const det = d[k + INV_DET]
      let p2: number
      if (det === 0) {
        p1 = l1 - w1 / k11
        if (p1 < 0) p1 = 0
        p2 = l2 - (w2 + k12 * (p1 - l1)) / k22
        if (p2 < 0) p2 = 0
      } else {
        // Velocities that zero impulses would leave: q + K·p ≥ 0 with p ≥ 0, one of each zero.
        const q1 = w1 - k11 * l1 - k12 * l2
        const q2 = w2 - k12 * l1 - k22 * l2
        p1 = det * (k12 * q2 - k22 * q1)
        p2 = det * (k12 * q1 - k11 * q2)
        if (p1 < 0 || p2 < 0) {
          p1 = -q1 / k11
          p2 = 0
          if (p1 < 0 || q2 + k12 * p1 < 0) {
            p1 = 0
            p2 = -q2 / k22
            if (p2 < 0 || q1 + k12 * p2 < 0) p2 = 0
          }
        }
      }
      d[k + LOAD1] = p1
      d[k + LOAD2] = p2
      load = p1 + p2
      p1 -= l1
      p2 -= l2
      normal = p1 + p2
      spinA -= iia * (na1 * p1 + na2 * p2)
      spinB += iib * (nb1 * p1 + nb2 * p2)
      const change = (p1 < 0 ? -p1 : p1) * k11 + (p2 < 0 ? -p2 : p2) * k22
      if (change > most) most = change
    }
    const ima = s[a + INV_MASS]
    const imb = s[b + INV_MASS]
    const ta = d[k + TA]
    const tb = d[k + TB]
    const old = d[k + DRAG]
    let t = old - d[k + MASS_T] * (nx * vy - ny * vx + tb * spinB - ta * spinA)
    const limit = friction * load
    if (t > limit) t = limit
    else if (t < -limit) t = -limit
    d[k + DRAG] = t
    t -= old
    const x = nx * normal - ny * t
    const y = ny * normal + nx * t
    s[a + VX] -= ima * x
    s[a + VY] -= ima * y
    s[a + SPIN] = spinA - iia * ta * t
    s[b + VX] += imb * x
    s[b + VY] += imb * y
    s[b + SPIN] = spinB + iib * tb * t
  }
  return most
}

/** Moves the bodies `list[from..to)` through the sub-step, and keeps what the sweep changed as the next warm start. */
export function move(bodies: Bodies, list: Int32Array, from: number, to: number, h: number): void {
  const { state, motion, shape } = bodies
  for (let a = from; a < to; a++) {
    const i = list[a]
    const s = i * STATE
    const m = i * MOTION
    const dvx = state[s + VX] - motion[m + KICK_X]
    const dvy = state[s + VY] - motion[m + KICK_Y]
    const dSpin = state[s + SPIN] - motion[m + KICK_SPIN]
    motion[m + PUSH_X] += dvx
    motion[m + PUSH_Y] += dvy
    motion[m + PUSH_SPIN] += dSpin
    const dx = motion[m + DRIFT_X] + h * dvx
    const dy = motion[m + DRIFT_Y] + h * dvy
    const by = motion[m + DRIFT_ANGLE] + h * dSpin
    state[s + X] += dx
    state[s + Y] += dy
    state[s + ANGLE] += by
    const extent = shape[i * SHAPE + EXTENT]
    motion[m + WAY] += Math.abs(dx) + Math.abs(dy) + extent * Math.abs(by)
    capSpeed(state, s)
    motion[m + NEXT] =
      1.25 * h * (Math.abs(state[s + VX]) + Math.abs(state[s + VY]) + extent * Math.abs(state[s + SPIN]))
  }
}

/** Nothing moves faster than the cap, so that no margin is ever too small. */
export function capSpeed(state: Float64Array, s: number): void {
  const vx = state[s + VX]
  const vy = state[s + VY]
  const square = vx * vx + vy * vy
  if (square > MAX_SPEED * MAX_SPEED) {
    const k = MAX_SPEED / Math.sqrt(square)
    state[s + VX] = vx * k
    state[s + VY] = vy * k
  }
}

/** Pushes the bodies of a point (0 or 1) of a manifold apart along its normal. */
function part(
  bodies: Bodies,
  s: Float64Array,
  d: Float64Array,
  k: number,
  a: number,
  b: number,
  gap: number,
  point: number,
): void {
  const want = PUSH * (-SLOP - gap)
  const p = Math.min(want, MAX_PUSH) / (point === 0 ? d[k + K11] : d[k + K22])
  const pa = s[a + INV_MASS] * p
  const pb = s[b + INV_MASS] * p
  s[a + X] -= d[k + NX] * pa
  s[a + Y] -= d[k + NY] * pa
  s[a + ANGLE] -= s[a + INV_INERTIA] * (point === 0 ? d[k + NA1] : d[k + NA2]) * p
  s[b + X] += d[k + NX] * pb
  s[b + Y] += d[k + NY] * pb
  s[b + ANGLE] += s[b + INV_INERTIA] * (point === 0 ? d[k + NB1] : d[k + NB2]) * p
  // A push is a way gone too: else a chip pushed far, by a wall that moves in, would pass through its neighbours unseen.
  bodies.motion[(a / STATE) * MOTION + WAY] += 2 * pa
  bodies.motion[(b / STATE) * MOTION + WAY] += 2 * pb
}

/** One sweep that pushes overlapping poses apart and never touches a velocity, so that correcting adds no energy. */
export function separate(
  bodies: Bodies,
  contacts: Contacts,
  list: Int32Array,
  from: number,
  to: number,
): void {
  const s = bodies.state
  const d = contacts.data
  const pair = contacts.pair
  for (let i = from; i < to; i++) {
    const c = list[i]
    const k = c * CONTACT
    const points = d[k + POINTS]
    if (points === 0) continue
    const a = pair[2 * c] * STATE
    const b = pair[2 * c + 1] * STATE
    const nx = d[k + NX]
    const ny = d[k + NY]
    const across = nx * (s[b + X] - s[a + X]) + ny * (s[b + Y] - s[a + Y])
    const gap1 = d[k + BASE1] + across + d[k + NB1] * s[b + ANGLE] - d[k + NA1] * s[a + ANGLE]
    if (gap1 < -SLOP) part(bodies, s, d, k, a, b, gap1, 0)
    if (points > 1) {
      const gap2 =
        d[k + BASE2] +
        nx * (s[b + X] - s[a + X]) +
        ny * (s[b + Y] - s[a + Y]) +
        d[k + NB2] * s[b + ANGLE] -
        d[k + NA2] * s[a + ANGLE]
      if (gap2 < -SLOP) part(bodies, s, d, k, a, b, gap2, 1)
    }
  }
}

import {
  type Air,
  ANGLE,
  type Bodies,
  CORE,
  DRIFT_ANGLE,
  DRIFT_X,
  DRIFT_Y,
  EXTENT,
  INDEX,
  INV_INERTIA,
  INV_MASS,
  KICK_SPIN,
  KICK_X,
  KICK_Y,
  MOTION,
  PUSH_SPIN,
  PUSH_X,
  PUSH_Y,
  PUSHED,
  SHAPE,
  SPIN,
  STATE,
  VX,
  VY,
  X,
  Y,
} from './body'
import { touch } from './collide'
import {
  BALANCE,
  CLOSING,
  MARGIN,
  MAX_PUSH,
  MAX_SPEED,
  PUSH,
  REFRESH,
  SLOP,
  STANDING,
  WALL_REFRESH,
} from './constants'
import {
  BASE1,
  BASE2,
  CLEAR,
  CLOSING1,
  CLOSING2,
  CONTACT,
  type Contacts,
  DRAG,
  FROM_A,
  FROM_B,
  FROM_X,
  FROM_Y,
  INV_DET,
  K11,
  K12,
  K22,
  LOAD1,
  LOAD2,
  MASS_T,
  MASS1,
  MASS2,
  measure,
  NA1,
  NA2,
  NB1,
  NB2,
  NX,
  NY,
  POINTS,
  TA,
  TB,
} from './contacts'
import { enterImpact, type ImpactScene, type Impacts, resolve } from './impacts'

/**
 * Gravity, drag and warm start for the bodies `list[from..to)`: velocities at the end of the sub-step were it not for the sweep.
 * Those that move are marked as stirred for the sweep with number `round`.
 */
export function kick(
  bodies: Bodies,
  list: Int32Array,
  from: number,
  to: number,
  gravity: number,
  air: Air,
  spinAir: Air,
  round: number,
): void {
  const { state, motion, shape, stirred } = bodies
  const half = 0.5 * air.h
  for (let a = from; a < to; a++) {
    const i = list[a] & INDEX
    const s = i * STATE
    const m = i * MOTION
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
    const toX = air.fade * vx + pushX
    const toY = air.fade * vy + gravity * air.reach + pushY
    const toSpin = spinAir.fade * spin + pushSpin
    state[s + VX] = motion[m + KICK_X] = toX
    state[s + VY] = motion[m + KICK_Y] = toY
    state[s + SPIN] = motion[m + KICK_SPIN] = toSpin
    const speed = Math.abs(toX) + Math.abs(toY) + shape[i * SHAPE + EXTENT] * Math.abs(toSpin)
    if (speed > BALANCE) stirred[i] = round - 1
  }
}

/**
 * What the contacts `list[from..to)` ask of the coming sub-step of `h` seconds. Those that have moved are measured again (a
 * wall at every move, a touching pair after `REFRESH`, others when they may meet); those that will hit join the impacts;
 * the others learn how fast they may close. Those that touch, or are about to, are written into `live` from `from` on;
 * returns where they end. With `again`, a contact whose bodies stood still in the last sub-step is left as it is.
 */
export function prepare(
  scene: ImpactScene,
  impacts: Impacts,
  list: Int32Array,
  live: Int32Array,
  from: number,
  to: number,
  h: number,
  again: boolean,
): number {
  const { bodies, contacts } = scene
  const d = contacts.data
  const s = bodies.state
  const { shape, moved } = bodies
  const pair = contacts.pair
  const ahead = 1.25 * h
  const enough = scene.threshold - Math.abs(scene.gravity) * h
  let end = from
  for (let n = from; n < to; n++) {
    const c = list[n] & INDEX
    const k = c * CONTACT
    const bodyA = pair[2 * c] & INDEX
    const bodyB = pair[2 * c + 1] & INDEX
    let touching = d[k + POINTS] > 0
    if (again && moved[bodyA] === 0 && moved[bodyB] === 0) {
      if (touching) live[end++] = c
      continue
    }
    const a = bodyA * STATE
    const b = bodyB * STATE
    const coreA = shape[bodyA * SHAPE + CORE]
    const coreB = shape[bodyB * SHAPE + CORE]
    const shift =
      Math.abs(s[b + X] - s[a + X] - d[k + FROM_X]) +
      Math.abs(s[b + Y] - s[a + Y] - d[k + FROM_Y]) +
      coreA * Math.abs(s[a + ANGLE] - d[k + FROM_A]) +
      coreB * Math.abs(s[b + ANGLE] - d[k + FROM_B])
    const vx = s[b + VX] - s[a + VX]
    const vy = s[b + VY] - s[a + VY]
    const spinA = s[a + SPIN]
    const spinB = s[b + SPIN]
    if (!touching || shift > (bodyA > 0 ? REFRESH : WALL_REFRESH)) {
      const near =
        MARGIN + ahead * (Math.abs(vx) + Math.abs(vy) + coreA * Math.abs(spinA) + coreB * Math.abs(spinB))
      if (!touching && d[k + CLEAR] - shift > near) continue
      touch.margin = near
      touch.ahead = h
      measure(bodies, contacts, scene.walls, c)
      touch.ahead = 0
      contacts.measured++
      touching = touch.count > 0
      if (!touching) continue
    }
    live[end++] = c
    if (d[k + LOAD1] + d[k + LOAD2] === 0) {
      // What an impact asks first, for both points at once, and generously: nearly every contact fails here.
      const speed = d[k + NX] * vx + d[k + NY] * vy + enough
      if (
        speed + d[k + NB1] * spinB - d[k + NA1] * spinA < 0 ||
        (d[k + POINTS] > 1 && speed + d[k + NB2] * spinB - d[k + NA2] * spinA < 0)
      ) {
        enterImpact(impacts, scene, c, h)
        if (d[k + POINTS] === 0) {
          end--
          continue
        }
      }
    }
    close(scene, c, h)
  }
  if (impacts.count === 0) return end
  resolve(impacts, scene, h)
  for (let n = 0; n < impacts.bodyCount; n++) {
    for (let edge = contacts.head[impacts.bodies[n]]; edge >= 0; edge = contacts.next[edge]) {
      if (d[(edge >> 1) * CONTACT + POINTS] > 0) close(scene, edge >> 1, h)
    }
  }
  return end
}

/**
 * How fast the gaps of contact `c` may close in the coming sub-step; one that carries a load closes slowly: less chatter.
 * Overlap that the last move has left is taken out of the poses in passing.
 */
function close(scene: ImpactScene, c: number, h: number): void {
  const { bodies, contacts } = scene
  const s = bodies.state
  const d = contacts.data
  const k = (c & INDEX) * CONTACT
  const bodyA = contacts.pair[2 * c] & INDEX
  const bodyB = contacts.pair[2 * c + 1] & INDEX
  const a = bodyA * STATE
  const b = bodyB * STATE
  const nx = d[k + NX]
  const ny = d[k + NY]
  const across = nx * (s[b + X] - s[a + X]) + ny * (s[b + Y] - s[a + Y])
  const gap1 = d[k + BASE1] + across + d[k + NB1] * s[b + ANGLE] - d[k + NA1] * s[a + ANGLE]
  const gap2 =
    d[k + POINTS] > 1 ? d[k + BASE2] + across + d[k + NB2] * s[b + ANGLE] - d[k + NA2] * s[a + ANGLE] : 0
  let closing1 = 0
  let closing2 = 0
  if (gap1 > 0 || gap2 > 0) {
    const l1 = d[k + LOAD1]
    const l2 = d[k + LOAD2]
    if (gap1 > 0) closing1 = (l1 > 0 ? CLOSING * gap1 : gap1) / h
    if (gap2 > 0) closing2 = (l2 > 0 ? CLOSING * gap2 : gap2) / h
    if (l1 + l2 === 0) {
      // The gap closes with the mean velocity of the sub-step, half of what it gains behind the one at its end.
      const m = bodies.motion
      const ma = bodyA * MOTION
      const mb = bodyB * MOTION
      const fall = bodyA > 0 ? 0 : scene.gravity * h
      const gain =
        nx * (m[mb + PUSH_X] - m[ma + PUSH_X]) +
        ny * (m[mb + PUSH_Y] - m[ma + PUSH_Y] + fall) +
        d[k + NB1] * m[mb + PUSH_SPIN] -
        d[k + NA1] * m[ma + PUSH_SPIN]
      if (gap1 > 0) closing1 -= 0.5 * gain
      if (gap2 > 0) closing2 -= 0.5 * gain
    }
  }
  d[k + CLOSING1] = closing1
  d[k + CLOSING2] = closing2
  if (gap1 < -SLOP) part(bodies, d, k, a, b, gap1, 0, h)
  if (gap2 < -SLOP) part(bodies, d, k, a, b, gap2, 1, h)
}

/**
 * One Gauss–Seidel sweep over the contacts `list[from..to)`: both normals of a manifold together (the 2×2 block of the
 * complementarity problem, by cases), then friction in the interval ±μ·load. Returns how many contacts
 * it changed by more than `tolerance`, px/s. Visits the contacts with a body that moves, or that was stirred by as much in this round or
 * the last.
 */
export function sweep(
  bodies: Bodies,
  contacts: Contacts,
  list: Int32Array,
  from: number,
  to: number,
  friction: number,
  tolerance: number,
  round: number,
): number {
  const s = bodies.state
  const d = contacts.data
  const pair = contacts.pair
  const stirred = bodies.stirred
  const lull = round - 1
  let stirs = 0
  for (let i = from; i < to; i++) {
    const c = list[i] & INDEX
    const bodyA = pair[2 * c] & INDEX
    const bodyB = pair[2 * c + 1] & INDEX
    if (stirred[bodyA] < lull && stirred[bodyB] < lull) continue
    contacts.rows++
    const k = c * CONTACT
    const a = bodyA * STATE
    const b = bodyB * STATE
    const nx = d[k + NX]
    const ny = d[k + NY]
    let spinA = s[a + SPIN]
    let spinB = s[b + SPIN]
    const vx = s[b + VX] - s[a + VX]
    const vy = s[b + VY] - s[a + VY]
    const speed = nx * vx + ny * vy
    const na1 = d[k + NA1]
    const nb1 = d[k + NB1]
    const l1 = d[k + LOAD1]
    const w1 = speed + nb1 * spinB - na1 * spinA + d[k + CLOSING1]
    let load: number
    let normal: number
    let change: number
    if (d[k + POINTS] === 1) {
      // ½(x + |x|) is max(0, x) without a branch, which nobody could predict here.
      load = l1 - w1 * d[k + MASS1]
      load = 0.5 * (load + Math.abs(load))
      normal = load - l1
      if (normal === 0 && load === 0) continue
      change = Math.abs(normal) * d[k + K11]
      d[k + LOAD1] = load
      spinA -= s[a + INV_INERTIA] * na1 * normal
      spinB += s[b + INV_INERTIA] * nb1 * normal
    } else {
      const na2 = d[k + NA2]
      const nb2 = d[k + NB2]
      const l2 = d[k + LOAD2]
      const w2 = speed + nb2 * spinB - na2 * spinA + d[k + CLOSING2]
      const k11 = d[k + K11]
      const k12 = d[k + K12]
      const k22 = d[k + K22]
      const det = d[k + INV_DET]
      // Velocities that zero impulses would leave: q + K·p ≥ 0 with p ≥ 0, one of each zero.
      const q1 = w1 - k11 * l1 - k12 * l2
      const q2 = w2 - k12 * l1 - k22 * l2
      let p1: number
      let p2: number
      if (det > 0) {
        p1 = det * (k12 * q2 - k22 * q1)
        p2 = det * (k12 * q1 - k11 * q2)
      } else {
        // The two points are nearly one: they take turns.
        p1 = l1 - w1 * d[k + MASS1]
        if (p1 < 0) p1 = 0
        p2 = l2 - (w2 + k12 * (p1 - l1)) * d[k + MASS2]
        if (p2 < 0) p2 = 0
      }
      if (p1 < 0 || p2 < 0) {
        p1 = -q1 * d[k + MASS1]
        p2 = 0
        if (p1 < 0 || q2 + k12 * p1 < 0) {
          p1 = 0
          p2 = -q2 * d[k + MASS2]
          if (p2 < 0 || q1 + k12 * p2 < 0) p2 = 0
        }
      }
      load = p1 + p2
      if (load === 0 && l1 + l2 === 0) continue
      d[k + LOAD1] = p1
      d[k + LOAD2] = p2
      p1 -= l1
      p2 -= l2
      normal = p1 + p2
      change = Math.abs(p1) * k11 + Math.abs(p2) * k22
      spinA -= s[a + INV_INERTIA] * (na1 * p1 + na2 * p2)
      spinB += s[b + INV_INERTIA] * (nb1 * p1 + nb2 * p2)
    }
    if (change > tolerance) {
      stirred[bodyA] = round
      stirred[bodyB] = round
      stirs++
    }
    const ta = d[k + TA]
    const tb = d[k + TB]
    const old = d[k + DRAG]
    const limit = friction * load
    let t = old - d[k + MASS_T] * (nx * vy - ny * vx + tb * spinB - ta * spinA)
    if (t > limit) t = limit
    else if (t < -limit) t = -limit
    d[k + DRAG] = t
    t -= old
    const x = nx * normal - ny * t
    const y = ny * normal + nx * t
    const ima = s[a + INV_MASS]
    const imb = s[b + INV_MASS]
    s[a + VX] -= ima * x
    s[a + VY] -= ima * y
    s[a + SPIN] = spinA - s[a + INV_INERTIA] * ta * t
    s[b + VX] += imb * x
    s[b + VY] += imb * y
    s[b + SPIN] = spinB + s[b + INV_INERTIA] * tb * t
  }
  return stirs
}

/** Moves the bodies `list[from..to)` through the sub-step, and keeps what the sweep changed as the next warm start. */
export function move(bodies: Bodies, list: Int32Array, from: number, to: number, h: number): void {
  const { state, motion, shape, moved } = bodies
  for (let a = from; a < to; a++) {
    const i = list[a] & INDEX
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
    const way = Math.abs(dx) + Math.abs(dy) + shape[i * SHAPE + CORE] * Math.abs(by)
    moved[i] = moved[i] === PUSHED || way > STANDING ? 1 : 0
    capSpeed(state, s)
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

/** Pushes the bodies of a point (0 or 1) of a manifold apart along its normal, unless they part by themselves within `h` s. */
function part(
  bodies: Bodies,
  d: Float64Array,
  k: number,
  a: number,
  b: number,
  gap: number,
  point: number,
  h: number,
): void {
  const s = bodies.state
  const nx = d[k + NX]
  const ny = d[k + NY]
  const na = point === 0 ? d[k + NA1] : d[k + NA2]
  const nb = point === 0 ? d[k + NB1] : d[k + NB2]
  const leaving =
    nx * (s[b + VX] - s[a + VX]) + ny * (s[b + VY] - s[a + VY]) + nb * s[b + SPIN] - na * s[a + SPIN]
  if (gap + leaving * h > -SLOP) return
  const p = Math.min(PUSH * (-SLOP - gap), MAX_PUSH) * (point === 0 ? d[k + MASS1] : d[k + MASS2])
  const pa = s[a + INV_MASS] * p
  const pb = s[b + INV_MASS] * p
  s[a + X] -= nx * pa
  s[a + Y] -= ny * pa
  s[a + ANGLE] -= s[a + INV_INERTIA] * na * p
  s[b + X] += nx * pb
  s[b + Y] += ny * pb
  s[b + ANGLE] += s[b + INV_INERTIA] * nb * p
  bodies.moved[a / STATE] = PUSHED
  bodies.moved[b / STATE] = PUSHED
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
    const c = list[i] & INDEX
    const k = c * CONTACT
    const points = d[k + POINTS]
    if (points === 0) continue
    const a = (pair[2 * c] & INDEX) * STATE
    const b = (pair[2 * c + 1] & INDEX) * STATE
    const nx = d[k + NX]
    const ny = d[k + NY]
    const across = nx * (s[b + X] - s[a + X]) + ny * (s[b + Y] - s[a + Y])
    const gap1 = d[k + BASE1] + across + d[k + NB1] * s[b + ANGLE] - d[k + NA1] * s[a + ANGLE]
    if (gap1 < -SLOP) part(bodies, d, k, a, b, gap1, 0, 0)
    if (points > 1) {
      const gap2 =
        d[k + BASE2] +
        nx * (s[b + X] - s[a + X]) +
        ny * (s[b + Y] - s[a + Y]) +
        d[k + NB2] * s[b + ANGLE] -
        d[k + NA2] * s[a + ANGLE]
      if (gap2 < -SLOP) part(bodies, d, k, a, b, gap2, 1, 0)
    }
  }
}

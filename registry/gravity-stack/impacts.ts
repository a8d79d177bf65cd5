import {
  ANGLE,
  type Bodies,
  grown,
  INDEX,
  INV_INERTIA,
  INV_MASS,
  MOTION,
  PUSH_SPIN,
  PUSH_X,
  PUSH_Y,
  SPIN,
  STATE,
  VX,
  VY,
  X,
  Y,
} from './body'
import { touch, type Walls } from './collide'
import {
  IMPACT_SHARE,
  IMPACT_SPREAD,
  IMPACT_SPREAD_SHARE,
  IMPACT_SWEEPS,
  IMPACT_TOLERANCE,
  IMPACT_TOUCH,
  MARGIN,
} from './constants'
import {
  CHANGE,
  CONTACT,
  type Contacts,
  GOAL_T,
  GOAL1,
  GOAL2,
  gapOf,
  HIT_T,
  HIT1,
  HIT2,
  K11,
  K22,
  MASS_T,
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

/**
 * Bounces, each at its time inside the sub-step: the velocity changes at the start of it, and the pose goes back by
 * what the change would have moved too early. Exact for a single impact, at any step.
 */
export interface Impacts {
  /** Contacts of the cluster under way. */
  list: Int32Array
  count: number
  /** Bodies it reached: their velocities before (3 each) and the time of their first impact, s. */
  bodies: Int32Array
  bodyCount: number
  before: Float64Array
  when: Float64Array
  /** Number of the phase that last reached each body. */
  mark: Int32Array
  phase: number
  sweeps: number
  /** px/s, the hardest hit of the cluster. */
  fastest: number
}

export function createImpacts(): Impacts {
  return {
    list: new Int32Array(64),
    count: 0,
    bodies: new Int32Array(0),
    bodyCount: 0,
    before: new Float64Array(0),
    when: new Float64Array(0),
    mark: new Int32Array(0),
    phase: 0,
    sweeps: 0,
    fastest: 0,
  }
}

export function reserveImpacts(impacts: Impacts, bodies: number): void {
  if (impacts.mark.length >= bodies) return
  impacts.bodies = grown(impacts.bodies, bodies)
  impacts.before = grown(impacts.before, bodies * 3)
  impacts.when = grown(impacts.when, bodies)
  impacts.mark = grown(impacts.mark, bodies)
}

/** Gravity, bounce and the rest of what an impact needs to know. */
export interface ImpactScene {
  bodies: Bodies
  contacts: Contacts
  walls: Walls
  gravity: number
  bounce: number
  friction: number
  threshold: number
}

/** px/s, velocity along the normal of point 1 (or 2). */
function approach(
  state: Float64Array,
  d: Float64Array,
  k: number,
  a: number,
  b: number,
  second: boolean,
): number {
  const along = d[k + NX] * (state[b + VX] - state[a + VX]) + d[k + NY] * (state[b + VY] - state[a + VY])
  return second
    ? along + d[k + NB2] * state[b + SPIN] - d[k + NA2] * state[a + SPIN]
    : along + d[k + NB1] * state[b + SPIN] - d[k + NA1] * state[a + SPIN]
}

/** px/s, change of that velocity over the sub-step by gravity and the contacts that already push. */
function pull(scene: ImpactScene, k: number, a: number, b: number, second: boolean, h: number): number {
  const d = scene.contacts.data
  const m = scene.bodies.motion
  const ma = a * MOTION
  const mb = b * MOTION
  const fallA = a > 0 ? scene.gravity * h : 0
  const fallB = b > 0 ? scene.gravity * h : 0
  const along =
    d[k + NX] * (m[mb + PUSH_X] - m[ma + PUSH_X]) +
    d[k + NY] * (m[mb + PUSH_Y] + fallB - m[ma + PUSH_Y] - fallA)
  return second
    ? along + d[k + NB2] * m[mb + PUSH_SPIN] - d[k + NA2] * m[ma + PUSH_SPIN]
    : along + d[k + NB1] * m[mb + PUSH_SPIN] - d[k + NA1] * m[ma + PUSH_SPIN]
}

/** The impact that `predict` found. */
const ahead = { time: 0, goal: 0, speed: 0 }

/**
 * Whether a point of contact `c` will hit within `h` hard enough to bounce; when, and with what velocity at the start
 * of the sub-step it would leave as it should.
 */
function predict(scene: ImpactScene, c: number, second: boolean, h: number): boolean {
  const { bodies, contacts } = scene
  const k = c * CONTACT
  const a = contacts.pair[2 * c]
  const b = contacts.pair[2 * c + 1]
  const v = approach(bodies.state, contacts.data, k, a * STATE, b * STATE, second)
  if (v > 0) return false
  const gap = Math.max(0, gapOf(bodies, contacts, c, second))
  const change = pull(scene, k, a, b, second, h)
  if (gap + (v + 0.5 * change) * h >= 0) return false
  const rate = change / h
  const square = v * v - 2 * rate * gap
  if (!(square > scene.threshold * scene.threshold)) return false
  const hit = -Math.sqrt(square)
  const time = Math.min(h, (2 * gap) / (-v - hit))
  // A bounce so low that it would land again within the sub-step is left to rest.
  const e = scene.bounce * -hit > 0.5 * Math.abs(rate) * (h - time) ? scene.bounce : 0
  ahead.time = time
  ahead.speed = -hit
  ahead.goal = -e * hit - (hit - v)
  return true
}

/** Takes contact `c` into the cluster with both goals and a time. */
function enlist(
  impacts: Impacts,
  scene: ImpactScene,
  c: number,
  goal1: number,
  goal2: number,
  when: number,
  h: number,
): void {
  const { bodies, contacts } = scene
  if (impacts.count >= impacts.list.length) impacts.list = grown(impacts.list, impacts.count * 2)
  impacts.list[impacts.count++] = c
  contacts.mark[c] = impacts.phase
  const k = c * CONTACT
  const d = contacts.data
  d[k + GOAL1] = goal1
  d[k + GOAL2] = goal2
  d[k + HIT1] = 0
  d[k + HIT2] = 0
  d[k + HIT_T] = 0
  const m = bodies.motion
  const a = contacts.pair[2 * c]
  const b = contacts.pair[2 * c + 1]
  const ma = a * MOTION
  const mb = b * MOTION
  const fall = (b > 0 ? scene.gravity * h : 0) - (a > 0 ? scene.gravity * h : 0)
  const slip =
    d[k + NX] * (m[mb + PUSH_Y] - m[ma + PUSH_Y] + fall) -
    d[k + NY] * (m[mb + PUSH_X] - m[ma + PUSH_X]) +
    d[k + TB] * m[mb + PUSH_SPIN] -
    d[k + TA] * m[ma + PUSH_SPIN]
  d[k + GOAL_T] = (-slip * when) / h
  reach(impacts, scene, contacts.pair[2 * c], when)
  reach(impacts, scene, contacts.pair[2 * c + 1], when)
}

function reach(impacts: Impacts, scene: ImpactScene, i: number, when: number): void {
  if (i === 0 || impacts.mark[i] === impacts.phase) return
  impacts.mark[i] = impacts.phase
  const state = scene.bodies.state
  const n = impacts.bodyCount++
  impacts.bodies[n] = i
  impacts.before[n * 3] = state[i * STATE + VX]
  impacts.before[n * 3 + 1] = state[i * STATE + VY]
  impacts.before[n * 3 + 2] = state[i * STATE + SPIN]
  impacts.when[i] = when
}

/** Measures contact `c` at the poses that its bodies will have when it hits: the geometry of the impact, not of its eve. */
function measureAt(scene: ImpactScene, c: number, time: number, h: number): void {
  const { bodies, contacts } = scene
  const a = contacts.pair[2 * c]
  const b = contacts.pair[2 * c + 1]
  const s = bodies.state
  const ax = s[a * STATE + X]
  const ay = s[a * STATE + Y]
  const aa = s[a * STATE + ANGLE]
  const bx = s[b * STATE + X]
  const by = s[b * STATE + Y]
  const ba = s[b * STATE + ANGLE]
  advance(scene, a, time, h)
  advance(scene, b, time, h)
  touch.margin = MARGIN
  measure(bodies, contacts, scene.walls, c)
  s[a * STATE + X] = ax
  s[a * STATE + Y] = ay
  s[a * STATE + ANGLE] = aa
  s[b * STATE + X] = bx
  s[b * STATE + Y] = by
  s[b * STATE + ANGLE] = ba
}

function advance(scene: ImpactScene, i: number, time: number, h: number): void {
  if (i === 0) return
  const { state, motion } = scene.bodies
  const s = i * STATE
  const m = i * MOTION
  const half = (0.5 * time * time) / h
  state[s + X] += state[s + VX] * time + motion[m + PUSH_X] * half
  state[s + Y] += state[s + VY] * time + motion[m + PUSH_Y] * half + 0.5 * scene.gravity * time * time
  state[s + ANGLE] += state[s + SPIN] * time + motion[m + PUSH_SPIN] * half
}

/** Empties the cluster for a new sub-step. */
export function clearImpacts(impacts: Impacts): void {
  impacts.count = 0
  impacts.bodyCount = 0
  impacts.phase++
  impacts.fastest = 0
}

/** Contact `c` joins the cluster if one of its points will hit. */
export function enterImpact(impacts: Impacts, scene: ImpactScene, c: number, h: number): void {
  const d = scene.contacts.data
  const k = c * CONTACT
  if (!(predict(scene, c, false, h) || (d[k + POINTS] > 1 && predict(scene, c, true, h)))) return
  // Measured again at the time of impact until that time stands still.
  let time = ahead.time
  for (let n = 0; n < 6; n++) {
    measureAt(scene, c, time, h)
    if (d[k + POINTS] === 0) return
    let next = predict(scene, c, false, h) ? ahead.time : h
    if (d[k + POINTS] > 1 && predict(scene, c, true, h)) next = Math.min(next, ahead.time)
    const step = next - time
    time = next
    if (step < 1e-13 && step > -1e-13) break
  }
  const goal1 = predict(scene, c, false, h) ? ahead.goal : -Infinity
  if (goal1 > -Infinity && ahead.speed > impacts.fastest) impacts.fastest = ahead.speed
  const goal2 = d[k + POINTS] > 1 && predict(scene, c, true, h) ? ahead.goal : -Infinity
  if (goal2 > -Infinity && ahead.speed > impacts.fastest) impacts.fastest = ahead.speed
  if (goal1 > -Infinity || goal2 > -Infinity) enlist(impacts, scene, c, goal1, goal2, time, h)
}

/** Sweeps over the cluster until it stands still; it grows to the neighbours that the impact reaches. */
export function resolve(impacts: Impacts, scene: ImpactScene, h: number): void {
  const { bodies, contacts } = scene
  const state = bodies.state
  const d = contacts.data
  // What dull chips leave unfinished the next sub-step would have swallowed anyway; lively ones would miss it.
  const share = 1 - scene.bounce * scene.bounce
  for (let n = 0; n < IMPACT_SWEEPS; n++) {
    // One contact alone is brought to its exact answer, a crowd to what its sub-steps can tell apart.
    const exact = impacts.count === 1
    const still = exact ? 1e-11 : Math.max(IMPACT_TOLERANCE, share * IMPACT_SHARE * impacts.fastest)
    const passOn = Math.max(IMPACT_SPREAD, share * IMPACT_SPREAD_SHARE * impacts.fastest)
    const before = impacts.count
    let most = 0
    for (let i = 0; i < impacts.count; i++) {
      const c = impacts.list[i]
      hit(state, d, contacts.pair, c, scene.friction)
      const change = d[c * CONTACT + CHANGE]
      if (change > most) most = change
      if (change > passOn) {
        spread(impacts, scene, contacts.pair[2 * c], passOn, h)
        spread(impacts, scene, contacts.pair[2 * c + 1], passOn, h)
      }
    }
    impacts.sweeps += impacts.count
    if (most < still && impacts.count === before) break
  }
  keepEnergy(impacts, scene, h)
  for (let n = 0; n < impacts.bodyCount; n++) {
    const i = impacts.bodies[n]
    const s = i * STATE
    const when = impacts.when[i]
    const dx = (state[s + VX] - impacts.before[n * 3]) * when
    const dy = (state[s + VY] - impacts.before[n * 3 + 1]) * when
    const by = (state[s + SPIN] - impacts.before[n * 3 + 2]) * when
    state[s + X] -= dx
    state[s + Y] -= dy
    state[s + ANGLE] -= by
  }
}

/** One contact of the cluster: normals to their goals, friction within its cone. Leaves the change of velocity, px/s. */
function hit(s: Float64Array, d: Float64Array, pair: Int32Array, c: number, friction: number): void {
  const k = c * CONTACT
  const a = (pair[2 * c] & INDEX) * STATE
  const b = (pair[2 * c + 1] & INDEX) * STATE
  const nx = d[k + NX]
  const ny = d[k + NY]
  const ima = s[a + INV_MASS]
  const imb = s[b + INV_MASS]
  const iia = s[a + INV_INERTIA]
  const iib = s[b + INV_INERTIA]
  let spinA = s[a + SPIN]
  let spinB = s[b + SPIN]
  const vx = s[b + VX] - s[a + VX]
  const vy = s[b + VY] - s[a + VY]
  let speed = nx * vx + ny * vy
  let normal = 0
  let change = 0
  if (d[k + GOAL1] > -Infinity) {
    const old = d[k + HIT1]
    let p = old + (d[k + GOAL1] - speed - d[k + NB1] * spinB + d[k + NA1] * spinA) / d[k + K11]
    if (p < 0) p = 0
    d[k + HIT1] = p
    p -= old
    normal = p
    speed += p * (ima + imb)
    spinA -= iia * d[k + NA1] * p
    spinB += iib * d[k + NB1] * p
    change = Math.abs(p) * d[k + K11]
  }
  if (d[k + POINTS] > 1 && d[k + GOAL2] > -Infinity) {
    const old = d[k + HIT2]
    let p = old + (d[k + GOAL2] - speed - d[k + NB2] * spinB + d[k + NA2] * spinA) / d[k + K22]
    if (p < 0) p = 0
    d[k + HIT2] = p
    p -= old
    normal += p
    spinA -= iia * d[k + NA2] * p
    spinB += iib * d[k + NB2] * p
    change = Math.max(change, Math.abs(p) * d[k + K22])
  }
  const ta = d[k + TA]
  const tb = d[k + TB]
  const limit = friction * (d[k + HIT1] + d[k + HIT2])
  const old = d[k + HIT_T]
  let t = old + d[k + MASS_T] * (d[k + GOAL_T] - nx * vy + ny * vx - tb * spinB + ta * spinA)
  t = t > limit ? limit : Math.max(t, -limit)
  d[k + HIT_T] = t
  t -= old
  d[k + CHANGE] = change
  const x = nx * normal - ny * t
  const y = ny * normal + nx * t
  s[a + VX] -= ima * x
  s[a + VY] -= ima * y
  s[a + SPIN] = spinA - iia * ta * t
  s[b + VX] += imb * x
  s[b + VY] += imb * y
  s[b + SPIN] = spinB + iib * tb * t
}

/** Takes up the contacts of body `i` that touch and now approach by `from` px/s: they stop dead, they don't bounce. */
function spread(impacts: Impacts, scene: ImpactScene, i: number, from: number, h: number): void {
  if (i === 0) return
  const { bodies, contacts } = scene
  const d = contacts.data
  const s = bodies.state
  for (let edge = contacts.head[i]; edge >= 0; edge = contacts.next[edge]) {
    const c = edge >> 1
    const k = c * CONTACT
    const points = d[k + POINTS]
    if (points === 0 || contacts.mark[c] === impacts.phase) continue
    const bodyA = contacts.pair[2 * c]
    const bodyB = contacts.pair[2 * c + 1]
    const a = bodyA * STATE
    const b = bodyB * STATE
    const nx = d[k + NX]
    const ny = d[k + NY]
    const speed = nx * (s[b + VX] - s[a + VX]) + ny * (s[b + VY] - s[a + VY])
    const fast1 = speed + d[k + NB1] * s[b + SPIN] - d[k + NA1] * s[a + SPIN] < -from
    const fast2 = points > 1 && speed + d[k + NB2] * s[b + SPIN] - d[k + NA2] * s[a + SPIN] < -from
    if (!fast1 && !fast2) continue
    const near1 = gapOf(bodies, contacts, c, false) < IMPACT_TOUCH
    const near2 = points > 1 && gapOf(bodies, contacts, c, true) < IMPACT_TOUCH
    if (!(fast1 && near1) && !(fast2 && near2)) continue
    if (bodies.asleep[bodyA] === 1 || bodies.asleep[bodyB] === 1) continue
    enlist(impacts, scene, c, near1 ? 0 : -Infinity, near2 ? 0 : -Infinity, impacts.when[i], h)
  }
}

/** An impact never gains energy: should unfinished sweeps or friction have made some, all impulses shrink alike. */
function keepEnergy(impacts: Impacts, scene: ImpactScene, h: number): void {
  const { state, motion } = scene.bodies
  let linear = 0
  let square = 0
  for (let n = 0; n < impacts.bodyCount; n++) {
    const i = impacts.bodies[n]
    const s = i * STATE
    const part = impacts.when[i] / h
    const m = 1 / state[s + INV_MASS]
    const inertia = 1 / state[s + INV_INERTIA]
    for (let axis = 0; axis < 3; axis++) {
      const weight = axis < 2 ? m : inertia
      const before = impacts.before[n * 3 + axis]
      const change = state[s + VX + axis] - before
      // Velocities change on the way to the impact: energy counts at its time.
      const gained = part * (motion[i * MOTION + PUSH_X + axis] + (axis === 1 ? scene.gravity * h : 0))
      linear += weight * (before + gained) * change
      square += weight * change * change
    }
  }
  // Kinetic energy after a share α of the impulses: E + α·linear + ½α²·square.
  if (linear + 0.5 * square <= 0 || square === 0) return
  const share = Math.max(0, (-2 * linear) / square)
  for (let n = 0; n < impacts.bodyCount; n++) {
    const s = impacts.bodies[n] * STATE
    for (let axis = 0; axis < 3; axis++) {
      const before = impacts.before[n * 3 + axis]
      state[s + VX + axis] = before + share * (state[s + VX + axis] - before)
    }
  }
}

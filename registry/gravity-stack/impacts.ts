import {
  ANGLE,
  type Bodies,
  grown,
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
  WAY,
  X,
  Y,
} from './body'
import { IMPACT_SPREAD, IMPACT_SWEEPS, IMPACT_TOLERANCE, IMPACT_TOUCH } from './constants'
import {
  CONTACT,
  type Contacts,
  GOAL1,
  GOAL2,
  gapOf,
  HIT_T,
  HIT1,
  HIT2,
  K11,
  K22,
  LOAD1,
  LOAD2,
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
  type Walls,
  WHEN,
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
const ahead = { time: 0, goal: 0 }

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
  if (square < scene.threshold * scene.threshold) return false
  const hit = -Math.sqrt(square)
  const time = Math.min(h, (2 * gap) / (-v - hit))
  // A bounce so low that it would land again within the sub-step is left to rest.
  const e = scene.bounce * -hit > 0.5 * Math.abs(rate) * (h - time) ? scene.bounce : 0
  ahead.time = time
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
): void {
  const { contacts } = scene
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
  d[k + WHEN] = when
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
  measure(bodies, contacts, scene.walls, c, 1)
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

/** All impacts of the contacts `list[from..to)` within the coming sub-step of `h` seconds. */
export function bounceAll(
  impacts: Impacts,
  scene: ImpactScene,
  list: Int32Array,
  from: number,
  to: number,
  h: number,
): void {
  const { contacts } = scene
  const d = contacts.data
  impacts.count = 0
  impacts.bodyCount = 0
  impacts.phase++
  for (let i = from; i < to; i++) {
    const c = list[i]
    const k = c * CONTACT
    if (d[k + POINTS] === 0 || d[k + LOAD1] + d[k + LOAD2] > 0) continue
    let hit1 = predict(scene, c, false, h)
    let hit2 = !hit1 && d[k + POINTS] > 1 && predict(scene, c, true, h)
    if (!hit1 && !hit2) continue
    // Measured again at the time of impact until that time stands still.
    let time = ahead.time
    for (let n = 0; n < 6; n++) {
      measureAt(scene, c, time, h)
      if (d[k + POINTS] === 0) break
      hit1 = predict(scene, c, false, h)
      let next = hit1 ? ahead.time : h
      hit2 = d[k + POINTS] > 1 && predict(scene, c, true, h)
      if (hit2) next = Math.min(next, ahead.time)
      const step = next - time
      time = next
      if (step < 1e-13 && step > -1e-13) break
    }
    if (d[k + POINTS] === 0 || !(hit1 || hit2)) continue
    const goal1 = predict(scene, c, false, h) ? ahead.goal : -Infinity
    const goal2 = d[k + POINTS] > 1 && predict(scene, c, true, h) ? ahead.goal : -Infinity
    if (goal1 > -Infinity || goal2 > -Infinity) enlist(impacts, scene, c, goal1, goal2, time)
  }
  if (impacts.count > 0) resolve(impacts, scene)
}

/** Sweeps over the cluster until it stands still; it grows to the neighbours that the impact reaches. */
function resolve(impacts: Impacts, scene: ImpactScene): void {
  const { bodies, contacts } = scene
  const state = bodies.state
  const d = contacts.data
  let asked = 0
  for (let n = 0; n < IMPACT_SWEEPS; n++) {
    let most = 0
    for (let i = 0; i < impacts.count; i++) {
      const change = hit(state, d, contacts.pair, impacts.list[i], scene.friction)
      if (change > most) most = change
    }
    impacts.sweeps += impacts.count
    // Bodies whose neighbours have not been asked since they last moved.
    const before = impacts.count
    for (asked = 0; asked < impacts.bodyCount; asked++) spread(impacts, scene, impacts.bodies[asked])
    if (most < IMPACT_TOLERANCE && impacts.count === before) break
  }
  keepEnergy(impacts, bodies)
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
    bodies.motion[i * MOTION + WAY] += Math.abs(dx) + Math.abs(dy)
  }
}

/** One contact of the cluster: normals to their goals, friction within its cone. Returns the change of velocity, px/s. */
function hit(s: Float64Array, d: Float64Array, pair: Int32Array, c: number, friction: number): number {
  const k = c * CONTACT
  const a = pair[2 * c] * STATE
  const b = pair[2 * c + 1] * STATE
  const nx = d[k + NX]
  const ny = d[k + NY]
  let most = 0
  for (let point = 0; point < (d[k + POINTS] > 1 ? 2 : 1); point++) {
    const goal = d[k + GOAL1 + point]
    if (goal === -Infinity) continue
    const kk = point === 0 ? d[k + K11] : d[k + K22]
    const na = point === 0 ? d[k + NA1] : d[k + NA2]
    const nb = point === 0 ? d[k + NB1] : d[k + NB2]
    const old = d[k + HIT1 + point]
    const v = approach(s, d, k, a, b, point === 1)
    let p = old + (goal - v) / kk
    if (p < 0) p = 0
    d[k + HIT1 + point] = p
    p -= old
    const change = Math.abs(p) * kk
    if (change > most) most = change
    s[a + VX] -= s[a + INV_MASS] * nx * p
    s[a + VY] -= s[a + INV_MASS] * ny * p
    s[a + SPIN] -= s[a + INV_INERTIA] * na * p
    s[b + VX] += s[b + INV_MASS] * nx * p
    s[b + VY] += s[b + INV_MASS] * ny * p
    s[b + SPIN] += s[b + INV_INERTIA] * nb * p
  }
  const ta = d[k + TA]
  const tb = d[k + TB]
  const along =
    nx * (s[b + VY] - s[a + VY]) - ny * (s[b + VX] - s[a + VX]) + tb * s[b + SPIN] - ta * s[a + SPIN]
  const limit = friction * (d[k + HIT1] + d[k + HIT2])
  const old = d[k + HIT_T]
  let t = old - d[k + MASS_T] * along
  t = t > limit ? limit : t < -limit ? -limit : t
  d[k + HIT_T] = t
  t -= old
  s[a + VX] += s[a + INV_MASS] * ny * t
  s[a + VY] -= s[a + INV_MASS] * nx * t
  s[a + SPIN] -= s[a + INV_INERTIA] * ta * t
  s[b + VX] -= s[b + INV_MASS] * ny * t
  s[b + VY] += s[b + INV_MASS] * nx * t
  s[b + SPIN] += s[b + INV_INERTIA] * tb * t
  return most
}

/** Takes up the contacts of body `i` that touch and now approach: they stop dead, they don't bounce. */
function spread(impacts: Impacts, scene: ImpactScene, i: number): void {
  const { bodies, contacts } = scene
  const d = contacts.data
  for (let edge = contacts.head[i]; edge >= 0; edge = contacts.next[edge]) {
    const c = edge >> 1
    const k = c * CONTACT
    const points = d[k + POINTS]
    if (points === 0 || contacts.mark[c] === impacts.phase) continue
    const a = contacts.pair[2 * c] * STATE
    const b = contacts.pair[2 * c + 1] * STATE
    const near1 = gapOf(bodies, contacts, c, false) < IMPACT_TOUCH
    const near2 = points > 1 && gapOf(bodies, contacts, c, true) < IMPACT_TOUCH
    const fast1 = near1 && approach(bodies.state, d, k, a, b, false) < -IMPACT_SPREAD
    const fast2 = near2 && approach(bodies.state, d, k, a, b, true) < -IMPACT_SPREAD
    if (fast1 || fast2) {
      if (bodies.asleep[contacts.pair[2 * c]] === 1 || bodies.asleep[contacts.pair[2 * c + 1]] === 1) continue
      enlist(impacts, scene, c, near1 ? 0 : -Infinity, near2 ? 0 : -Infinity, impacts.when[i])
    }
  }
}

/** An impact never gains energy: should unfinished sweeps or friction have made some, all impulses shrink alike. */
function keepEnergy(impacts: Impacts, bodies: Bodies): void {
  const { state } = bodies
  let linear = 0
  let square = 0
  for (let n = 0; n < impacts.bodyCount; n++) {
    const s = impacts.bodies[n] * STATE
    const m = 1 / state[s + INV_MASS]
    const inertia = 1 / state[s + INV_INERTIA]
    for (let axis = 0; axis < 3; axis++) {
      const weight = axis < 2 ? m : inertia
      const before = impacts.before[n * 3 + axis]
      const change = state[s + VX + axis] - before
      linear += weight * before * change
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

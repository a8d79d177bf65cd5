import {
  ANGLE,
  EXTENT,
  INDEX,
  INV_INERTIA,
  INV_MASS,
  MOTION,
  PUSH_SPIN,
  PUSH_X,
  PUSH_Y,
  SHAPE,
  SPIN,
  STATE,
  VX,
  VY,
  Y,
} from './body'
import { GAP_NOW, RATE_NOW, touch, WIDEST } from './collide'
import {
  IMPACT_NEAR,
  IMPACT_SHARE,
  IMPACT_SPREAD,
  IMPACT_SPREAD_SHARE,
  IMPACT_SWEEPS,
  IMPACT_TOLERANCE,
  IMPACT_TOUCH,
  LIVELY,
  RUNAWAY,
  SWEEPS_PLAIN,
  SWEEPS_UNEVEN,
  UNEVEN,
} from './constants'
import {
  CHANGE,
  CONTACT,
  GOAL,
  GOAL_T,
  gainOf,
  HIT,
  HIT_T,
  HITS,
  K,
  LOAD,
  MASS_T,
  measure,
  NA,
  NB,
  NX,
  NY,
  POINTS,
  probe,
  type Scene,
  SECOND,
  TA,
  TB,
} from './contacts'

/**
 * Bounces, each at its time inside the sub-step: the velocity changes at the start of it, and the pose goes back by
 * what the change would have moved too early. Exact for a single impact, at any step.
 */
export class Impacts {
  foundCount = 0
  /** Contacts of the cluster under way: those of them that come first, and what these spread to. */
  count = 0
  /** Bodies it reached; of each body its velocities before (3 each) and the time of its first impact, s. */
  bodies: Int32Array = new Int32Array(1)
  bodyCount = 0
  before: Float64Array = new Float64Array(3)
  when: Float64Array = new Float64Array(1)
  /** Number of the sub-step's first phase; for each body the same plus the part of the sub-step in which it was last hit. */
  first = 0
  since: Float64Array = new Float64Array(1)
  /** Number of the phase that last reached each body: after some weeks of motion more than 32 bits hold. */
  mark: Float64Array = new Float64Array(1)
  phase = 0
  /** px/s, the hardest hit of the cluster, and the approach from which it is passed on to a neighbour. */
  fastest = 0.5
  passOn = 0.5
}

/** What `foresee` found: when contact `c` will hit (s from the start of the sub-step, its end if not), and how hard (px/s). */
const ahead = { time: 0.5, speed: 0.5 }

/**
 * Whether a point of contact `c` will hit within the sub-step hard enough to bounce. The goals are the velocities at the
 * start of the sub-step with which the points would leave as they should.
 */
function foresee(impacts: Impacts, scene: Scene, c: number): boolean {
  const { contacts, h } = scene
  const d = contacts.data
  const k = c * CONTACT
  // What comes after an earlier hit of this sub-step.
  const from = hitBefore(impacts, scene, c)
  ahead.time = h
  ahead.speed = 0
  d[k + SECOND + GOAL] = -Infinity
  for (let p = k, n = 0; n < d[k + POINTS]; n++, p += SECOND) {
    d[p + GOAL] = d[p + LOAD] > 0 ? 0 : -Infinity
    probe(scene, c, p)
    const start = touch[RATE_NOW]
    // A push of more is what a blow has left: the contact on its other side is gone, and the sweeps will take it back.
    const rate = Math.max(gainOf(scene, c, p), -LIVELY - Math.abs(scene.gravity) * h) / h
    const v = start + rate * from
    const gap = Math.max(0, touch[GAP_NOW] + 0.5 * (start + v) * from)
    const rest = h - from
    if (v > 0 || gap + (v + 0.5 * rate * rest) * rest >= 0) continue
    const square = v * v - 2 * rate * gap
    if (!(square > scene.threshold * scene.threshold)) continue
    const hit = -Math.sqrt(square)
    const time = from + Math.min(rest, (2 * gap) / (-v - hit))
    // A bounce so low that it would land again within the sub-step is left to rest.
    const e = scene.bounce * -hit > 0.5 * Math.abs(rate) * (h - time) ? scene.bounce : 0
    // Of two ends the first to hit turns the chip: what the other does then is asked in the next round.
    if (ahead.speed > 0 && Math.abs(time - ahead.time) * -hit > IMPACT_TOUCH) {
      if (time > ahead.time) continue
      d[k + GOAL] = d[k + LOAD] > 0 ? 0 : -Infinity
      ahead.speed = 0
    }
    ahead.time = Math.min(ahead.time, time)
    ahead.speed = Math.max(ahead.speed, -hit)
    d[p + GOAL] = -e * hit - (hit - start)
  }
  return ahead.speed > 0
}

/** Takes contact `c`, which hits at time `when`, into the cluster. */
function enlist(impacts: Impacts, scene: Scene, c: number, when: number): void {
  const { data: d, mark, pair, struck } = scene.contacts
  struck[impacts.count++] = c
  mark[c] = impacts.phase
  const k = c * CONTACT
  d[k + HIT] = d[k + SECOND + HIT] = d[k + HIT_T] = 0
  const m = scene.bodies.motion
  const a = pair[2 * c] * MOTION
  const b = pair[2 * c + 1] * MOTION
  const slip =
    d[k + NX] * (m[b + PUSH_Y] - m[a + PUSH_Y] + (a > 0 ? 0 : scene.gravity * scene.h)) -
    d[k + NY] * (m[b + PUSH_X] - m[a + PUSH_X]) +
    d[k + TB] * m[b + PUSH_SPIN] -
    d[k + TA] * m[a + PUSH_SPIN]
  d[k + GOAL_T] = (-slip * when) / scene.h
  for (let side = 0; side < 2; side++) {
    const i = pair[2 * c + side]
    if (i === 0) continue
    if (impacts.mark[i] === impacts.phase) {
      if (when < impacts.when[i]) impacts.when[i] = when
      continue
    }
    impacts.mark[i] = impacts.phase
    impacts.bodies[impacts.bodyCount++] = i
    impacts.when[i] = when
    for (let axis = 0; axis < 3; axis++)
      impacts.before[i * 3 + axis] = scene.bodies.state[i * STATE + VX + axis]
  }
}

/** Poses of two bodies while one is measured where it will be. */
const kept: Float64Array = new Float64Array(6)

/** Measures contact `c` at the poses that its bodies will have at `time`: the geometry of the impact, not of its eve. */
function measureAt(scene: Scene, c: number, time: number, widest: number): void {
  const { bodies, contacts, gravity, h } = scene
  const { state, motion, shape } = bodies
  const half = (0.5 * time * time) / h
  for (let n = 0; n < 6; n++) {
    const axis = n % 3
    const i = contacts.pair[2 * c + (n > 2 ? 1 : 0)]
    const s = i * STATE + axis
    kept[n] = state[s]
    if (i > 0) {
      const gain = motion[i * MOTION + axis] + (axis === Y ? gravity * h : 0)
      const most = (LIVELY + Math.abs(gravity) * h) / (axis === ANGLE ? shape[i * SHAPE + EXTENT] : 1)
      state[s] += state[s + VX] * time + Math.max(-most, Math.min(most, gain)) * half
    }
  }
  touch[WIDEST] = widest
  measure(scene, c)
  for (let n = 0; n < 6; n++) state[contacts.pair[2 * c + (n > 2 ? 1 : 0)] * STATE + (n % 3)] = kept[n]
}

/** Forgets what will hit, and what has, for a new round. */
export function clearImpacts(impacts: Impacts): void {
  impacts.foundCount = 0
  impacts.count = 0
  impacts.bodyCount = 0
  impacts.phase++
  impacts.fastest = 0
}

/** What bodies hit in this sub-step will hit next: contact `c` is measured where they were hit, as far as they may then go. */
export function enterAgain(impacts: Impacts, scene: Scene, c: number, way: number): void {
  measureAt(scene, c, hitBefore(impacts, scene, c), way)
  enterImpact(impacts, scene, c, way)
}

/** s from the start of the sub-step at which the bodies of contact `c` were last hit in it. */
function hitBefore({ since, first }: Impacts, { contacts: { pair }, h }: Scene, c: number): number {
  return h * Math.max(0, since[pair[2 * c]] - first, since[pair[2 * c + 1]] - first)
}

/** Contact `c`, whose bodies may come nearer by `way` px in the sub-step, is found if one of its points will hit. */
export function enterImpact(impacts: Impacts, scene: Scene, c: number, way: number): void {
  if (!foresee(impacts, scene, c)) return
  let hits = true
  // Measured again at the time of impact until that time stands still.
  for (let n = 0; n < 6; n++) {
    const time = ahead.time
    measureAt(scene, c, time, way)
    hits = foresee(impacts, scene, c)
    if (Math.abs(ahead.time - time) < 1e-13) break
  }
  if (!hits) return
  impacts.fastest = Math.max(impacts.fastest, ahead.speed)
  const { found, times, mark } = scene.contacts
  let n = impacts.foundCount++
  for (; n > 0 && times[n - 1] > ahead.time; n--) {
    found[n] = found[n - 1]
    times[n] = times[n - 1]
  }
  found[n] = c
  times[n] = ahead.time
  mark[c] = impacts.phase
}

/** Of two hits of one body the later is put off to the next round, if there is one: the first changes what comes of it. */
function enlistFirst(impacts: Impacts, scene: Scene, last: boolean): void {
  const phase = ++impacts.phase
  const { foundCount, when, mark } = impacts
  const { found, pair, times } = scene.contacts
  const slack = last ? Infinity : IMPACT_TOUCH / impacts.fastest
  for (let n = 0; n < foundCount; n++) {
    const c = found[n]
    const a = pair[2 * c]
    const b = pair[2 * c + 1]
    const before = times[n] - slack
    if ((mark[a] === phase && when[a] < before) || (mark[b] === phase && when[b] < before)) continue
    enlist(impacts, scene, c, times[n])
  }
}

/**
 * How far sweep `n` of `most` goes where masses are very unequal: at first and at last no further than each contact asks, up to `further`
 * between. Friction answers to a load, and the load to it: taken further, one contact alone may go to and fro for ever.
 */
export function furthest(further: number, n: number, most: number): number {
  return n < SWEEPS_PLAIN || n >= 0.9 * most ? 1 : further
}

/**
 * Sweeps over those that hit first, in the `last` round over all, until they stand still; the cluster grows to the neighbours that the
 * impact reaches.
 */
export function resolve(impacts: Impacts, scene: Scene, last: boolean): void {
  enlistFirst(impacts, scene, last)
  const { bodies, contacts } = scene
  const state = bodies.state
  const d = contacts.data
  // What dull chips leave unfinished the next sub-step would have swallowed anyway; lively ones would miss it.
  const share = 1 - scene.bounce * scene.bounce
  // Of unequal masses each sweep brings a small part, so that it seems to stand still.
  const unequal = scene.uneven > UNEVEN
  let further = unequal ? scene.relaxation : 1
  const slower = unequal ? Math.sqrt(scene.uneven) : 1
  const sweeps = Math.max(IMPACT_SWEEPS, Math.min(scene.uneven, SWEEPS_UNEVEN))
  for (let n = 0; n < sweeps; n++) {
    // One contact alone is brought to its exact answer, a crowd to what its sub-steps can tell apart.
    const exact = impacts.count === 1
    const still = exact ? 1e-11 : Math.max(IMPACT_TOLERANCE, share * IMPACT_SHARE * impacts.fastest) / slower
    const reach = exact ? 1 : furthest(further, n, sweeps)
    impacts.passOn = Math.max(IMPACT_SPREAD, share * IMPACT_SPREAD_SHARE * impacts.fastest)
    let most = 0
    for (let i = 0; i < impacts.count; i++) {
      const c = contacts.struck[i]
      hit(scene, c, reach)
      const change = d[c * CONTACT + CHANGE]
      if (change > most) most = change
      if (change > impacts.passOn) {
        spread(impacts, scene, contacts.pair[2 * c])
        spread(impacts, scene, contacts.pair[2 * c + 1])
      }
    }
    scene.work[HITS] += impacts.count
    if (most > RUNAWAY * impacts.fastest) further = 1
    if (most < still) break
  }
  keepEnergy(impacts, scene)
  for (let n = 0; n < impacts.bodyCount; n++) {
    const i = impacts.bodies[n]
    for (let axis = 0; axis < 3; axis++) {
      const s = i * STATE + axis
      state[s] -= (state[s + VX] - impacts.before[i * 3 + axis]) * impacts.when[i]
    }
    impacts.since[i] = impacts.first + impacts.when[i] / scene.h
  }
}

/** One contact of the cluster: normals to their goals, friction within its cone. Leaves the change of velocity, px/s. */
function hit(scene: Scene, c: number, further: number): void {
  const { friction } = scene
  const { data: d, pair } = scene.contacts
  const s = scene.bodies.state
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
  let load = 0
  let change = 0
  for (let p = k, n = 0; n < d[k + POINTS]; n++, p += SECOND) {
    if (d[p + GOAL] === -Infinity) continue
    const old = d[p + HIT]
    const now = Math.max(
      0,
      old + (further * (d[p + GOAL] - speed - d[p + NB] * spinB + d[p + NA] * spinA)) / d[p + K],
    )
    d[p + HIT] = now
    const by = now - old
    load += now
    normal += by
    speed += by * (ima + imb)
    spinA -= iia * d[p + NA] * by
    spinB += iib * d[p + NB] * by
    change = Math.max(change, Math.abs(by) * d[p + K])
  }
  const ta = d[k + TA]
  const tb = d[k + TB]
  const limit = friction * load
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

/** Takes up the contacts of body `i` that touch and now approach by `passOn`: they stop dead, they don't bounce. */
function spread(impacts: Impacts, scene: Scene, i: number): void {
  const { bodies, contacts } = scene
  const { data: d, pair } = contacts
  for (let edge = contacts.head[i]; edge >= 0; edge = contacts.next[edge]) {
    const c = edge >> 1
    const k = c * CONTACT
    if (d[k + POINTS] === 0 || contacts.mark[c] === impacts.phase) continue
    let struck = false
    for (let p = k, n = 0; n < d[k + POINTS]; n++, p += SECOND) {
      probe(scene, c, p)
      if (touch[RATE_NOW] < -impacts.passOn && isNear(impacts, scene, i, c, p)) struck = true
    }
    if (!struck || bodies.asleep[pair[2 * c]] + bodies.asleep[pair[2 * c + 1]] > 0) continue
    // What has been put off hits now, as it would have.
    if (contacts.mark[c] !== impacts.phase - 1) {
      d[k + SECOND + GOAL] = -Infinity
      for (let p = k, n = 0; n < d[k + POINTS]; n++, p += SECOND) {
        probe(scene, c, p)
        d[p + GOAL] = isNear(impacts, scene, i, c, p) ? 0 : -Infinity
      }
    }
    enlist(impacts, scene, c, impacts.when[i])
  }
}

/** Whether the point that `probe` looked at touches where it will be when body `i` is hit: what has parted again since it was hit in this sub-step is no neighbour any more. */
function isNear(impacts: Impacts, scene: Scene, i: number, c: number, p: number): boolean {
  return touch[GAP_NOW] + impacts.when[i] * rateBefore(impacts, scene, c, p) < IMPACT_NEAR * scene.h
}

/** px/s, rate at which the gap of the point of contact `c` with its record at `p` opened before the impact. */
function rateBefore(
  { mark, phase, before }: Impacts,
  { bodies, contacts }: Scene,
  c: number,
  p: number,
): number {
  const { data: d, pair } = contacts
  const k = c * CONTACT
  let rate = 0
  for (let side = 0; side < 2; side++) {
    const i = pair[2 * c + side]
    const struck = mark[i] === phase
    const velocity = struck ? before : bodies.state
    const v = struck ? i * 3 : i * STATE + VX
    const arm = d[p + (side > 0 ? NB : NA)]
    rate +=
      (side > 0 ? 1 : -1) * (d[k + NX] * velocity[v] + d[k + NY] * velocity[v + 1] + arm * velocity[v + 2])
  }
  return rate
}

/** An impact never gains energy: should unfinished sweeps or friction have made some, all impulses shrink alike. */
function keepEnergy(impacts: Impacts, scene: Scene): void {
  const h = scene.h
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
      const before = impacts.before[i * 3 + axis]
      const change = state[s + VX + axis] - before
      // Velocities change on the way to the impact: energy counts at its time.
      const gained = part * (motion[i * MOTION + PUSH_X + axis] + (axis === 1 ? scene.gravity * h : 0))
      linear += weight * (before + gained) * change
      square += weight * change * change
    }
  }
  // Kinetic energy after a share α of the impulses: E + α·linear + ½α²·square.
  if (linear + 0.5 * square <= 0) return
  const share = Math.max(0, (-2 * linear) / square)
  for (let n = 0; n < impacts.bodyCount; n++) {
    const i = impacts.bodies[n]
    const s = i * STATE
    for (let axis = 0; axis < 3; axis++) {
      const before = impacts.before[i * 3 + axis]
      state[s + VX + axis] = before + share * (state[s + VX + axis] - before)
    }
  }
}

import { isObstacleBody, isStatic } from './body'
import {
  ARM_AX,
  ARM_AY,
  ARM_BX,
  ARM_BY,
  COUNT,
  collide,
  DISTANCE,
  FEATURE,
  GAP,
  GAP_NOW,
  grazes,
  LEAD,
  MANIFOLD_NX,
  MANIFOLD_NY,
  manifold,
  POINT,
  RATE_NOW,
} from './manifold'
import { grow } from './math'
import {
  ANGLE,
  ARM_LAG,
  ARM_NA,
  ARM_NB,
  ARM_TA,
  ARM_TB,
  BASE_SEPARATION,
  type Bodies,
  CONTACT,
  CORE,
  COUPLING_K,
  type Contacts,
  FEATURE_ID,
  FIRST_CHIP,
  FROM_A,
  FROM_B,
  FROM_X,
  FROM_Y,
  INDEX,
  INV_DET,
  INV_INERTIA,
  INV_MASS,
  MANIFOLDS_MADE,
  MOTION,
  NORMAL_IMPULSE,
  NORMAL_K,
  NORMAL_X,
  NORMAL_Y,
  SECOND,
  SEPARATION,
  SHAPE,
  type Simulation,
  SPIN,
  STATE,
  TANGENT_IMPULSE,
  TANGENT_MASS,
  VX,
  VY,
  WARM_SPIN,
  WARM_X,
  WARM_Y,
  X,
  Y,
} from './state'

function link({ head, next }: Contacts, edge: number, body: number): void {
  if (body < FIRST_CHIP) return
  next[edge] = head[body]
  head[body] = edge
}

function unlink({ head, next }: Contacts, edge: number, body: number): void {
  if (body < FIRST_CHIP) return
  if (head[body] === edge) head[body] = next[edge]
  else {
    let before = head[body]
    while (next[before] !== edge) before = next[before]
    next[before] = next[edge]
  }
}

/**
 * A slot for the pair of bodies `low` and `high`. Body A of the contact is the lower, or the one that is
 * static.
 */
export function addContact(bodies: Bodies, contacts: Contacts, low: number, high: number): void {
  const turned = isStatic(bodies, high)
  const a = turned ? high : low
  const b = turned ? low : high
  let c = contacts.free
  if (c >= 0) contacts.free = contacts.next[2 * c]
  else {
    c = contacts.count++
    if (c >= contacts.points.length) grow(contacts)
  }
  contacts.pair[2 * c] = a
  contacts.pair[2 * c + 1] = b
  resetContact(contacts, c)
  link(contacts, 2 * c, a)
  link(contacts, 2 * c + 1, b)
}

export function removeContact(contacts: Contacts, c: number): void {
  unlink(contacts, 2 * c, contacts.pair[2 * c])
  unlink(contacts, 2 * c + 1, contacts.pair[2 * c + 1])
  contacts.pair[2 * c + 1] = 0
  contacts.next[2 * c] = contacts.free
  contacts.free = c
}

/** Makes contact `c` as if it had never been measured. */
export function resetContact({ data, due, points }: Contacts, c: number): void {
  data.fill(0, c * CONTACT, (c + 1) * CONTACT)
  points[c] = 0
  data[c * CONTACT + SEPARATION] = due[c] = -Infinity
}

/** Has the contacts of body `i` measured afresh, and its box as well if it is a chip. */
export function resetContacts(bodies: Bodies, contacts: Contacts, i: number): void {
  if (!isObstacleBody(bodies, i)) bodies.box[i * 4] = Infinity
  for (let edge = contacts.head[i]; edge >= 0; edge = contacts.next[edge]) resetContact(contacts, edge >> 1)
}

/** Has the contacts of body `i` checked in the next sub-step: its velocity was set from outside. */
export function checkContacts({ due, head, next }: Contacts, i: number): void {
  for (let edge = head[i]; edge >= 0; edge = next[edge]) due[edge >> 1] = -Infinity
}

/** Impulse along the normal of contact `c`, of both its points. */
export function normalImpulse({ data }: Contacts, c: number): number {
  return data[c * CONTACT + NORMAL_IMPULSE] + data[c * CONTACT + SECOND + NORMAL_IMPULSE]
}

/** Adds the impulses of contact `c`, times `sign`, to the warm start of its bodies. */
export function addWarmStart({ bodies, contacts }: Simulation, c: number, sign: number): void {
  const { state, motion } = bodies
  const d = contacts.data
  const k = c * CONTACT
  const n1 = sign * d[k + NORMAL_IMPULSE]
  const n2 = sign * d[k + SECOND + NORMAL_IMPULSE]
  const t = sign * d[k + TANGENT_IMPULSE]
  const x = d[k + NORMAL_X] * (n1 + n2) - d[k + NORMAL_Y] * t
  const y = d[k + NORMAL_Y] * (n1 + n2) + d[k + NORMAL_X] * t
  for (let side = 0; side < 2; side++) {
    const i = contacts.pair[2 * c + side] & INDEX
    const way = side > 0 ? 1 : -1
    const byMass = way * state[i * STATE + INV_MASS]
    const m = i * MOTION
    motion[m + WARM_X] += byMass * x
    motion[m + WARM_Y] += byMass * y
    motion[m + WARM_SPIN] +=
      way *
        state[i * STATE + INV_INERTIA] *
        (d[k + ARM_NA + side] * n1 + d[k + SECOND + ARM_NA + side] * n2 + d[k + ARM_TA + side] * t) +
      side * sign * d[k + ARM_LAG]
  }
}

/**
 * Hands the impulses of contact `c` on to the points that `collide` has found: an impulse stays with the
 * corner that made its point, and that of a point that is gone goes to the one that is left. Returns whether
 * the points are still the same.
 */
function matchImpulses(contacts: Contacts, c: number): boolean {
  const { data: d, points } = contacts
  const k = c * CONTACT
  const k2 = k + SECOND
  const had = points[c]
  const count = manifold[COUNT]
  points[c] = count
  if (count === 0) {
    d[k + NORMAL_IMPULSE] = d[k2 + NORMAL_IMPULSE] = d[k + TANGENT_IMPULSE] = 0
    return false
  }
  const load = normalImpulse(contacts, c)
  const corner1 = manifold[FEATURE]
  const corner2 = count > 1 ? manifold[POINT + FEATURE] : -1
  const stays = d[k + FEATURE_ID] === corner1
  const becomesSecond = d[k + FEATURE_ID] === corner2
  const swapped = becomesSecond || d[k2 + FEATURE_ID] === corner1
  // Of one point that is neither of two new ones, each gets half.
  let first = stays ? d[k + NORMAL_IMPULSE] : load / 2
  if (becomesSecond) first = 0
  if (had > 1) first = d[(swapped ? k2 : k) + NORMAL_IMPULSE]
  if (count === 1) first = load
  d[k + NORMAL_IMPULSE] = first
  d[k2 + NORMAL_IMPULSE] = load - first
  d[k + FEATURE_ID] = corner1
  d[k2 + FEATURE_ID] = corner2
  return had === count && stays
}

/** Torque on body B of the impulses of contact `c`, with the arms that it was measured with. */
function torqueOnB({ data: d }: Contacts, c: number): number {
  const k = c * CONTACT
  return (
    d[k + ARM_NB] * d[k + NORMAL_IMPULSE] +
    d[k + SECOND + ARM_NB] * d[k + SECOND + NORMAL_IMPULSE] +
    d[k + ARM_TB] * d[k + TANGENT_IMPULSE]
  )
}

/**
 * Measures contact `c` afresh at the present poses, as wide as `manifold[WIDEST]` and, at a wall,
 * `manifold[LEAD]` seconds ahead.
 */
export function updateContact(simulation: Simulation, c: number): void {
  const { bodies, contacts, work } = simulation
  const { state, motion } = bodies
  const { data: d, due } = contacts
  const a = contacts.pair[2 * c] & INDEX
  const b = contacts.pair[2 * c + 1] & INDEX
  const wall = isStatic(bodies, a)
  const angleA = state[a * STATE + ANGLE]
  const angleB = state[b * STATE + ANGLE]
  // The arms of a chip that rolls or topples are those at the end of the sub-step, where its velocity has to
  // be right.
  const turned = wall ? manifold[LEAD] * (state[b * STATE + SPIN] + 0.5 * motion[b * MOTION + WARM_SPIN]) : 0
  state[b * STATE + ANGLE] = angleB + turned
  collide(bodies, a, b)
  state[b * STATE + ANGLE] = angleB
  work[MANIFOLDS_MADE]++
  const k = c * CONTACT
  const k2 = k + SECOND
  const load = normalImpulse(contacts, c)
  if (a >= FIRST_CHIP && load === 0 && grazes(bodies, a, b)) manifold[COUNT] = 0
  const oldTorque = torqueOnB(contacts, c)
  if (load > 0 || d[k + ARM_LAG] !== 0) addWarmStart(simulation, c, -1)
  d[k + ARM_LAG] = 0
  const dx = state[b * STATE + X] - state[a * STATE + X]
  const dy = state[b * STATE + Y] - state[a * STATE + Y]
  d[k + SEPARATION] = manifold[DISTANCE]
  due[c] = -Infinity
  d[k + FROM_X] = dx
  d[k + FROM_Y] = dy
  d[k + FROM_A] = angleA
  d[k + FROM_B] = angleB
  const same = matchImpulses(contacts, c)
  const count = manifold[COUNT]
  if (count === 0) return

  const normalX = manifold[MANIFOLD_NX]
  const normalY = manifold[MANIFOLD_NY]
  const invInertiaA = state[a * STATE + INV_INERTIA]
  const invInertiaB = state[b * STATE + INV_INERTIA]
  const invMass = state[a * STATE + INV_MASS] + state[b * STATE + INV_MASS]
  d[k + NORMAL_X] = normalX
  d[k + NORMAL_Y] = normalY
  for (let n = 0; n < count; n++) {
    const m = n * POINT
    const p = k + n * SECOND
    const armA = manifold[m + ARM_AX] * normalY - manifold[m + ARM_AY] * normalX
    const armB = manifold[m + ARM_BX] * normalY - manifold[m + ARM_BY] * normalX
    d[p + ARM_NA] = armA
    d[p + ARM_NB] = armB
    d[p + BASE_SEPARATION] =
      manifold[m + GAP] - normalX * dx - normalY * dy - armB * (angleB + turned) + armA * angleA
    d[p + NORMAL_K] = invMass + invInertiaA * armA * armA + invInertiaB * armB * armB
  }
  let gap = manifold[GAP]
  let armA = manifold[ARM_AX] * normalX + manifold[ARM_AY] * normalY
  let armB = manifold[ARM_BX] * normalX + manifold[ARM_BY] * normalY
  if (count > 1) {
    // Friction acts where the load is. Without a load it acts at the nearer point: the other may be pixels
    // away.
    const share = load > 0 ? d[k2 + NORMAL_IMPULSE] / load : manifold[POINT + GAP] < gap ? 1 : 0
    gap += share * (manifold[POINT + GAP] - gap)
    armA += share * (manifold[POINT + ARM_AX] * normalX + manifold[POINT + ARM_AY] * normalY - armA)
    armB += share * (manifold[POINT + ARM_BX] * normalX + manifold[POINT + ARM_BY] * normalY - armB)
    const coupling =
      invMass + invInertiaA * d[k + ARM_NA] * d[k2 + ARM_NA] + invInertiaB * d[k + ARM_NB] * d[k2 + ARM_NB]
    const product = d[k + NORMAL_K] * d[k2 + NORMAL_K]
    const determinant = product - coupling * coupling
    d[k + COUPLING_K] = coupling
    d[k + INV_DET] = determinant > 0.001 * product ? 1 / determinant : 0
  }
  // Midway between the surfaces of two chips: friction across a gap would turn what it pushes.
  if (!wall) {
    armA += gap / 2
    armB -= gap / 2
  }
  d[k + ARM_TA] = armA
  d[k + ARM_TB] = armB
  d[k + TANGENT_MASS] = 1 / (invMass + invInertiaA * armA * armA + invInertiaB * armB * armB)
  if (load > 0) {
    // Over the sub-step the warm start acts with arms half way between the old ones and these.
    if (wall && same) d[k + ARM_LAG] = 0.5 * invInertiaB * (oldTorque - torqueOnB(contacts, c))
    addWarmStart(simulation, c, 1)
  }
}

/**
 * Leaves in `manifold` the separation (px) of the point at place `p` of contact `c`, and the rate (px/s) at
 * which it opens.
 */
export function separationAndRate({ bodies, contacts }: Simulation, c: number, p: number): void {
  const d = contacts.data
  const s = bodies.state
  const k = (c & INDEX) * CONTACT
  const a = (contacts.pair[2 * c] & INDEX) * STATE
  const b = (contacts.pair[2 * c + 1] & INDEX) * STATE
  const nx = d[k + NORMAL_X]
  const ny = d[k + NORMAL_Y]
  const na = d[p + ARM_NA]
  const nb = d[p + ARM_NB]
  manifold[GAP_NOW] =
    d[p + BASE_SEPARATION] +
    nx * (s[b + X] - s[a + X]) +
    ny * (s[b + Y] - s[a + Y]) +
    nb * s[b + ANGLE] -
    na * s[a + ANGLE]
  manifold[RATE_NOW] =
    nx * (s[b + VX] - s[a + VX]) + ny * (s[b + VY] - s[a + VY]) + nb * s[b + SPIN] - na * s[a + SPIN]
}

/** px, the smallest separation of the points of contact `c`. */
export function gapOf(simulation: Simulation, c: number): number {
  let gap = Infinity
  for (let p = c * CONTACT, m = simulation.contacts.points[c]; m > 0; m--, p += SECOND) {
    separationAndRate(simulation, c, p)
    gap = Math.min(gap, manifold[GAP_NOW])
  }
  return gap
}

/**
 * px/s, what gravity and the contacts that already push add over the sub-step to the relative velocity of the
 * bodies of contact `c`: along the normal, or `across` it, at the point whose arms are at place `arms`.
 * Gravity counts only where body A is static: of two bodies that fall it cancels.
 */
export function rateGain(
  { bodies, contacts, gravity, h }: Simulation,
  c: number,
  arms: number,
  across: boolean,
): number {
  const { motion } = bodies
  const { data: d, pair } = contacts
  const k = (c & INDEX) * CONTACT
  const bodyA = pair[2 * c] & INDEX
  const a = bodyA * MOTION
  const b = (pair[2 * c + 1] & INDEX) * MOTION
  const pulled = isStatic(bodies, bodyA) ? h : 0
  const x = motion[b + WARM_X] - motion[a + WARM_X] + gravity[X] * pulled
  const y = motion[b + WARM_Y] - motion[a + WARM_Y] + gravity[Y] * pulled
  const nx = d[k + NORMAL_X]
  const ny = d[k + NORMAL_Y]
  return (
    (across ? nx * y - ny * x : nx * x + ny * y) +
    d[arms + 1] * motion[b + WARM_SPIN] -
    d[arms] * motion[a + WARM_SPIN]
  )
}

/**
 * px, the most that points of the two bodies have moved against each other since contact `c` was measured.
 */
export function shiftOf({ bodies, contacts }: Simulation, c: number): number {
  const { state: s, shape } = bodies
  const d = contacts.data
  const k = c * CONTACT
  const a = contacts.pair[2 * c] & INDEX
  const b = contacts.pair[2 * c + 1] & INDEX
  return (
    Math.abs(s[b * STATE + X] - s[a * STATE + X] - d[k + FROM_X]) +
    Math.abs(s[b * STATE + Y] - s[a * STATE + Y] - d[k + FROM_Y]) +
    shape[a * SHAPE + CORE] * Math.abs(s[a * STATE + ANGLE] - d[k + FROM_A]) +
    shape[b * SHAPE + CORE] * Math.abs(s[b * STATE + ANGLE] - d[k + FROM_B])
  )
}

/** px, lower bound of the separation of contact `c` now, without measuring. */
export function separationBound(simulation: Simulation, c: number): number {
  return simulation.contacts.data[c * CONTACT + SEPARATION] - shiftOf(simulation, c)
}

/** px, separation of contact `c` that its bodies may close in `seconds`. */
export function closingDistance({ bodies, contacts }: Simulation, c: number, seconds: number): number {
  const { state: s, shape } = bodies
  const a = contacts.pair[2 * c] & INDEX
  const b = contacts.pair[2 * c + 1] & INDEX
  return (
    seconds *
    (Math.abs(s[b * STATE + VX] - s[a * STATE + VX]) +
      Math.abs(s[b * STATE + VY] - s[a * STATE + VY]) +
      shape[a * SHAPE + CORE] * Math.abs(s[a * STATE + SPIN]) +
      shape[b * SHAPE + CORE] * Math.abs(s[b * STATE + SPIN]))
  )
}

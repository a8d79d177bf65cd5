import { isObstacleBody, isStatic } from './body'
import { IMPACT_TOLERANCE, SLOW_CONTACT } from './constants'
import {
  ACROSS,
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
export function warmStart({ bodies, contacts }: Simulation, c: number, sign: number): void {
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
 * Whether bodies `a` and `b`, as `collide` found them, hit each other by so little that they slide past. The
 * corner of a box sags a little into the surface that it slides on: it would trip over the side of the next
 * box in a level row.
 */
function grazes({ state }: Bodies, a: number, b: number): boolean {
  const vx = state[b * STATE + VX] - state[a * STATE + VX]
  const vy = state[b * STATE + VY] - state[a * STATE + VY]
  const approach = -manifold[MANIFOLD_NX] * vx - manifold[MANIFOLD_NY] * vy
  const speed = Math.sqrt(vx * vx + vy * vy)
  // Slow bodies are pushed apart instead: a jam must not fall asleep while its chips overlap.
  return manifold[ACROSS] < IMPACT_TOLERANCE && speed > SLOW_CONTACT && approach > IMPACT_TOLERANCE * speed
}

/**
 * Measures contact `c` afresh at the present poses, as wide as `manifold[WIDEST]` and, at a wall,
 * `manifold[LEAD]` seconds ahead. Impulses stay with the points that made them; those of a point that is gone
 * go to the one that is left.
 */
export function updateContact(simulation: Simulation, c: number): void {
  const { bodies, contacts, work } = simulation
  const { state, motion } = bodies
  const { data: d, due, points } = contacts
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
  const had = points[c]
  const n1 = d[k + NORMAL_IMPULSE]
  const n2 = d[k2 + NORMAL_IMPULSE]
  const sum = n1 + n2
  if (a >= FIRST_CHIP && sum === 0 && grazes(bodies, a, b)) manifold[COUNT] = 0
  const torque = d[k + ARM_NB] * n1 + d[k2 + ARM_NB] * n2 + d[k + ARM_TB] * d[k + TANGENT_IMPULSE]
  if (sum > 0 || d[k + ARM_LAG] !== 0) warmStart(simulation, c, -1)
  d[k + ARM_LAG] = 0
  const dx = state[b * STATE + X] - state[a * STATE + X]
  const dy = state[b * STATE + Y] - state[a * STATE + Y]
  d[k + SEPARATION] = manifold[DISTANCE]
  due[c] = -Infinity
  d[k + FROM_X] = dx
  d[k + FROM_Y] = dy
  d[k + FROM_A] = angleA
  d[k + FROM_B] = angleB
  const count = manifold[COUNT]
  points[c] = count
  if (count === 0) {
    d[k + NORMAL_IMPULSE] = d[k2 + NORMAL_IMPULSE] = d[k + TANGENT_IMPULSE] = 0
    return
  }

  const f1 = manifold[FEATURE]
  const f2 = count > 1 ? manifold[POINT + FEATURE] : -1
  const same = d[k + FEATURE_ID] === f1
  const crossed = d[k + FEATURE_ID] === f2
  const swapped = crossed || d[k2 + FEATURE_ID] === f1
  const first = had > 1 ? (swapped ? n2 : n1) : crossed ? 0 : same ? n1 : sum / 2
  d[k + NORMAL_IMPULSE] = count === 1 ? sum : first
  d[k2 + NORMAL_IMPULSE] = sum - d[k + NORMAL_IMPULSE]
  d[k + FEATURE_ID] = f1
  d[k2 + FEATURE_ID] = f2

  const nx = manifold[MANIFOLD_NX]
  const ny = manifold[MANIFOLD_NY]
  const iia = state[a * STATE + INV_INERTIA]
  const iib = state[b * STATE + INV_INERTIA]
  const im = state[a * STATE + INV_MASS] + state[b * STATE + INV_MASS]
  d[k + NORMAL_X] = nx
  d[k + NORMAL_Y] = ny
  for (let n = 0; n < count; n++) {
    const m = n * POINT
    const p = k + n * SECOND
    const na = manifold[m + ARM_AX] * ny - manifold[m + ARM_AY] * nx
    const nb = manifold[m + ARM_BX] * ny - manifold[m + ARM_BY] * nx
    d[p + ARM_NA] = na
    d[p + ARM_NB] = nb
    d[p + BASE_SEPARATION] = manifold[m + GAP] - nx * dx - ny * dy - nb * (angleB + turned) + na * angleA
    d[p + NORMAL_K] = im + iia * na * na + iib * nb * nb
  }
  let gap = manifold[GAP]
  let ta = manifold[ARM_AX] * nx + manifold[ARM_AY] * ny
  let tb = manifold[ARM_BX] * nx + manifold[ARM_BY] * ny
  if (count > 1) {
    // Friction acts where the load is, or without any where the two are nearer: the other end may be pixels
    // away.
    const share = sum > 0 ? d[k2 + NORMAL_IMPULSE] / sum : manifold[POINT + GAP] < gap ? 1 : 0
    gap += share * (manifold[POINT + GAP] - gap)
    ta += share * (manifold[POINT + ARM_AX] * nx + manifold[POINT + ARM_AY] * ny - ta)
    tb += share * (manifold[POINT + ARM_BX] * nx + manifold[POINT + ARM_BY] * ny - tb)
    const k12 = im + iia * d[k + ARM_NA] * d[k2 + ARM_NA] + iib * d[k + ARM_NB] * d[k2 + ARM_NB]
    const kk = d[k + NORMAL_K] * d[k2 + NORMAL_K]
    const det = kk - k12 * k12
    d[k + COUPLING_K] = k12
    d[k + INV_DET] = det > 0.001 * kk ? 1 / det : 0
  }
  // Midway between the surfaces of two chips: friction across a gap would turn what it pushes.
  if (!wall) {
    ta += gap / 2
    tb -= gap / 2
  }
  d[k + ARM_TA] = ta
  d[k + ARM_TB] = tb
  d[k + TANGENT_MASS] = 1 / (im + iia * ta * ta + iib * tb * tb)
  if (sum > 0) {
    // Over the sub-step the warm start acts with arms half way between the old ones and these.
    if (wall && had === count && same) {
      const now =
        d[k + ARM_NB] * d[k + NORMAL_IMPULSE] +
        d[k2 + ARM_NB] * d[k2 + NORMAL_IMPULSE] +
        tb * d[k + TANGENT_IMPULSE]
      d[k + ARM_LAG] = 0.5 * iib * (torque - now)
    }
    warmStart(simulation, c, 1)
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

/**
 * px/s that field `axis` of the velocity of body B of contact `c` gains on that of body A over the sub-step,
 * by the contacts that already push and by gravity, which cancels out of two that fall.
 */
export function relativeGain({ bodies, contacts, gravity, h }: Simulation, c: number, axis: number): number {
  const a = contacts.pair[2 * c] & INDEX
  const { motion } = bodies
  const gain = motion[(contacts.pair[2 * c + 1] & INDEX) * MOTION + axis] - motion[a * MOTION + axis]
  return gain + (isStatic(bodies, a) ? gravity[axis] * h : 0)
}

/** px/s, `relativeGain` along the normal, at the point at place `p` of contact `c`. */
export function rateGain(simulation: Simulation, c: number, p: number): number {
  const { data: d, pair } = simulation.contacts
  const m = simulation.bodies.motion
  const k = (c & INDEX) * CONTACT
  const a = (pair[2 * c] & INDEX) * MOTION
  const b = (pair[2 * c + 1] & INDEX) * MOTION
  return (
    d[k + NORMAL_X] * relativeGain(simulation, c, X) +
    d[k + NORMAL_Y] * relativeGain(simulation, c, Y) +
    d[p + ARM_NB] * m[b + WARM_SPIN] -
    d[p + ARM_NA] * m[a + WARM_SPIN]
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

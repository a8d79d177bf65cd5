import {
  ANGLE,
  Bodies,
  CORE,
  grow,
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
  X,
  Y,
} from './body'
import {
  ACROSS,
  AX,
  AY,
  BX,
  BY,
  COUNT,
  collide,
  collideWall,
  DISTANCE,
  FEATURE,
  GAP,
  GAP_NOW,
  LEAD,
  NORMAL_X,
  NORMAL_Y,
  POINT,
  RATE_NOW,
  touch,
  type Walls,
} from './collide'
import { GRAZE, GRAZE_SLOPE } from './constants'
import type { Hold } from './grab'

/**
 * Pairs that may touch, and their manifolds: up to two points that share a normal. A pair keeps its slot, and its
 * impulses, for as long as the two stay near each other.
 *
 * The separation is linear in the poses between two measurements: gap = base + n·(x_B − x_A) + arm_B·θ_B − arm_A·θ_A.
 */

// Record of `data`: one manifold, in the order it is read: what asks whether it still serves, then what a sweep needs. Arms are
// torques of a unit impulse along the normal (N) or the tangent (T).
/** px, gap when it was measured, or a lower bound of it; relative position and both angles at that time. */
export const CLEAR = 0
export const FROM_X = 1
export const FROM_Y = 2
export const FROM_A = 3
export const FROM_B = 4
/** The furthest that a sweep takes its impulses. */
export const FURTHEST = 5
export const NX = 6
export const NY = 7
/** The record of point 1; that of point 2 lies `SECOND` places on, and is zero without one. */
export const NA = 8
export const NB = 9
/** Accumulated impulse of a sub-step. */
export const LOAD = 10
/** px/s at which the gap may close in the sub-step. */
export const CLOSING = 11
/** Inverse effective mass along the normal, and its inverse. */
export const K = 12
export const MASS = 13
/** px, gap at the origin of the poses. */
export const BASE = 14
export const SECOND = 7
/** Coupling of the two points, and 1 / det K, 0 where the two are nearly one. */
export const K12 = 22
export const INV_DET = 23
/** Points that carry a load lie on one line along the tangent, so that one row of friction serves both exactly. */
export const TA = 24
export const TB = 25
export const DRAG = 26
export const MASS_T = 27
/** 0: apart, no manifold; 1 or 2 points. */
export const POINTS = 28
/** px, sum of both bodies' travel up to which the record surely serves; −∞: to be looked at. */
export const DUE = 29
/** rad/s that the warm start of a wall gives body B beside what its arms say: half of what they changed. */
export const LAG = 30
/** Impact: wanted velocity along the normal of point 1 (−∞: none) and its impulse, of point 2 `SECOND` places on; of the tangent. */
export const GOAL = 31
export const HIT = 32
export const GOAL_T = 33
export const HIT_T = 34
/** px/s, last change of a normal velocity. */
export const CHANGE = 35
export const CONTACT = 40

/** Room for four contacts a body at first: a pile has three or four. */
export class Contacts {
  /** Slots ever used; free ones among them are chained through `next`. */
  count = 0
  free = -1
  /** Body A and body B of each slot; A is 0 for a wall, B is 0 for a free slot. */
  pair: Int32Array = new Int32Array(8)
  /** Features of both points. */
  feature: Int32Array = new Int32Array(8)
  /** 0 for two chips; 1 floor, 2 left wall, 3 right wall. */
  wall: Uint8Array = new Uint8Array(4)
  data: Float64Array = new Float64Array(4 * CONTACT)
  /** Lists of the contacts of each body: edge 2c is contact c seen from A, 2c + 1 from B; -1 ends a list. */
  head: Int32Array = new Int32Array(1).fill(-1)
  next: Int32Array = new Int32Array(8)
  /** Number of the impact phase in which the contact was taken up; while islands are made, whether it is theirs. */
  mark: Float64Array = new Float64Array(4)
  /** Room for lists of them, none of which holds one twice: those that matter in this step, in the order they were found and island by island, and only those that touch in the present sub-step. */
  near: Int32Array = new Int32Array(4)
  sorted: Int32Array = new Int32Array(4)
  live: Int32Array = new Int32Array(4)
  /** Those that will hit, in the order of their times, s; those of the cluster of impacts under way. */
  found: Int32Array = new Int32Array(4)
  times: Float64Array = new Float64Array(4)
  struck: Int32Array = new Int32Array(4)
}

/** What a world is made of, and what it is like there. Numbers that may be fractions begin as ones: a change would cost the compiled code. */
export class Scene {
  bodies = new Bodies()
  contacts = new Contacts()
  walls: Walls = { width: 0.5, height: 0.5 }
  /** px/s² downwards. */
  gravity = 0.5
  bounce = 0.5
  friction = 0.5
  /** Share by which it is more at rest. */
  stiction = 0.5
  /** px/s of approach below which nothing bounces. */
  threshold = 0.5
  /** s, length of a sub-step. */
  h = 0.5
  /** px/s, change of a velocity that the sweeps of the present island leave alone. */
  tolerance = 0.5
  /** Whether something in the present island is fast. */
  lively = false
  /** px of relative motion after which a touching pair of the present island is measured again. */
  loose = 0.5
  /** How far the sweeps of the present island take each impulse: 1 is where its contact is solved, more is beyond. */
  relaxation = 0.5
  /** Most sweeps of the present sub-step. */
  sweeps = 0
  /** Ratio of the heaviest to the lightest mass in the present island, whole so that it is never boxed. */
  uneven = 0
  holds: Hold[] = []
  /** What was done so far, by kind: for tests and tools, which set it back to 0 as they like. */
  work: Float64Array = new Float64Array(5)
}

/** Record of `work`: sub-steps, sweeps, contacts that they visited, impacts that theirs did, pairs measured. */
export const SUBSTEPS_TAKEN = 0
export const SWEPT = 1
export const VISITED = 2
export const HITS = 3
export const MEASURED = 4

function link({ head, next }: Contacts, edge: number, body: number): void {
  next[edge] = head[body]
  head[body] = edge
}

function unlink({ head, next }: Contacts, edge: number, body: number): void {
  if (head[body] === edge) head[body] = next[edge]
  else {
    let before = head[body]
    while (next[before] !== edge) before = next[before]
    next[before] = next[edge]
  }
}

/** Impulse that contact `c` carries across it, of both its points. */
export function loadOf({ data }: Contacts, c: number): number {
  return data[c * CONTACT + LOAD] + data[c * CONTACT + SECOND + LOAD]
}

/** Contact `c` is as if it had never been measured. */
export function forgetContact({ data }: Contacts, c: number): void {
  data.fill(0, c * CONTACT, (c + 1) * CONTACT)
  data[c * CONTACT + CLEAR] = data[c * CONTACT + DUE] = -Infinity
}

/** A slot for the pair of bodies `a` and `b`, or for body `b` and a wall (`a` is 0 then). */
export function addContact(contacts: Contacts, a: number, b: number, wall: number): number {
  let c = contacts.free
  if (c >= 0) contacts.free = contacts.next[2 * c]
  else {
    c = contacts.count++
    if (c >= contacts.wall.length) grow(contacts, 2)
  }
  contacts.pair[2 * c] = a
  contacts.pair[2 * c + 1] = b
  contacts.wall[c] = wall
  forgetContact(contacts, c)
  if (a > 0) link(contacts, 2 * c, a)
  link(contacts, 2 * c + 1, b)
  return c
}

export function removeContact(contacts: Contacts, c: number): void {
  const a = contacts.pair[2 * c]
  if (a > 0) unlink(contacts, 2 * c, a)
  unlink(contacts, 2 * c + 1, contacts.pair[2 * c + 1])
  contacts.pair[2 * c + 1] = 0
  contacts.next[2 * c] = contacts.free
  contacts.free = c
}

/** The impulses of contact `c`, times `sign`, added to what its bodies get as warm start. */
export function carry({ bodies, contacts }: Scene, c: number, sign: number): void {
  const d = contacts.data
  const k = c * CONTACT
  const l1 = sign * d[k + LOAD]
  const l2 = sign * d[k + SECOND + LOAD]
  const lt = sign * d[k + DRAG]
  const nx = d[k + NX]
  const ny = d[k + NY]
  const x = nx * (l1 + l2) - ny * lt
  const y = ny * (l1 + l2) + nx * lt
  const a = contacts.pair[2 * c] & INDEX
  const b = contacts.pair[2 * c + 1] & INDEX
  const { state, motion } = bodies
  const ima = state[a * STATE + INV_MASS]
  const imb = state[b * STATE + INV_MASS]
  const ma = a * MOTION
  const mb = b * MOTION
  motion[ma + PUSH_X] -= ima * x
  motion[ma + PUSH_Y] -= ima * y
  motion[ma + PUSH_SPIN] -=
    state[a * STATE + INV_INERTIA] * (d[k + NA] * l1 + d[k + SECOND + NA] * l2 + d[k + TA] * lt)
  motion[mb + PUSH_X] += imb * x
  motion[mb + PUSH_Y] += imb * y
  motion[mb + PUSH_SPIN] +=
    state[b * STATE + INV_INERTIA] * (d[k + NB] * l1 + d[k + SECOND + NB] * l2 + d[k + TB] * lt) +
    sign * d[k + LAG]
}

/**
 * Whether bodies `a` and `b`, as `collide` found them, hit each other by so little that they slide past. The corner of a box
 * sags a little into the surface that it slides on: it would trip over the side of the next box in a level row.
 */
function grazes({ state }: Bodies, a: number, b: number): boolean {
  const vx = state[b * STATE + VX] - state[a * STATE + VX]
  const vy = state[b * STATE + VY] - state[a * STATE + VY]
  const approach = -touch[NORMAL_X] * vx - touch[NORMAL_Y] * vy
  return touch[ACROSS] < GRAZE && approach > GRAZE_SLOPE * Math.sqrt(vx * vx + vy * vy)
}

/**
 * Measures contact `c` afresh at the present poses: arms, separations, masses. Impulses stay with the points that made
 * them; those of a point that is gone go to the one that is left. The gap, px, is left in `touch`.
 */
export function measure(scene: Scene, c: number): void {
  const { bodies, contacts } = scene
  const a = contacts.pair[2 * c] & INDEX
  const b = contacts.pair[2 * c + 1] & INDEX
  const { state, motion } = bodies
  const angleA = state[a * STATE + ANGLE]
  const angleB = state[b * STATE + ANGLE]
  const load1 = contacts.data[c * CONTACT + LOAD]
  const load2 = contacts.data[c * CONTACT + SECOND + LOAD]
  // The arms of a chip that rolls or topples are those at the end of the sub-step, where the velocity has to be right.
  const turned = a > 0 ? 0 : touch[LEAD] * (state[b * STATE + SPIN] + 0.5 * motion[b * MOTION + PUSH_SPIN])
  if (a > 0) {
    collide(bodies, a, b)
    if (load1 + load2 === 0 && grazes(bodies, a, b)) touch[COUNT] = 0
  } else {
    state[b * STATE + ANGLE] = angleB + turned
    collideWall(bodies, scene.walls, b, contacts.wall[c])
    state[b * STATE + ANGLE] = angleB
  }
  const d = contacts.data
  const k = c * CONTACT
  const had = d[k + POINTS]
  const loaded = load1 + load2 > 0
  const torque = d[k + NB] * load1 + d[k + SECOND + NB] * load2 + d[k + TB] * d[k + DRAG]
  if (loaded || d[k + LAG] !== 0) carry(scene, c, -1)
  d[k + LAG] = 0
  const dx = state[b * STATE + X] - state[a * STATE + X]
  const dy = state[b * STATE + Y] - state[a * STATE + Y]
  d[k + CLEAR] = touch[DISTANCE]
  d[k + FROM_X] = dx
  d[k + FROM_Y] = dy
  d[k + FROM_A] = angleA
  d[k + FROM_B] = angleB
  const count = touch[COUNT]
  d[k + POINTS] = count
  d[k + DUE] = -Infinity
  if (count === 0) {
    d[k + LOAD] = 0
    d[k + SECOND + LOAD] = 0
    d[k + DRAG] = 0
    return
  }

  // Impulses by feature. All is worked out before anything is chosen: an operation that runs for the first time only after
  // this has been compiled throws the compiled code away.
  const f1 = touch[FEATURE]
  const f2 = count > 1 ? touch[POINT + FEATURE] : -1
  const old1 = contacts.feature[2 * c]
  const old2 = contacts.feature[2 * c + 1]
  const half = load1 / 2
  const same = old1 === f1
  const cross = old1 === f2
  const swapped = cross || old2 === f1
  d[k + LOAD] =
    count === 1 ? load1 + load2 : had > 1 ? (swapped ? load2 : load1) : cross ? 0 : same ? load1 : half
  d[k + SECOND + LOAD] =
    count === 1 ? 0 : had > 1 ? (swapped ? load1 : load2) : cross ? load1 : same ? 0 : half
  contacts.feature[2 * c] = f1
  contacts.feature[2 * c + 1] = f2

  const nx = touch[NORMAL_X]
  const ny = touch[NORMAL_Y]
  const ima = state[a * STATE + INV_MASS]
  const imb = state[b * STATE + INV_MASS]
  const iia = state[a * STATE + INV_INERTIA]
  const iib = state[b * STATE + INV_INERTIA]
  const im = ima + imb
  const na1 = touch[AX] * ny - touch[AY] * nx
  const nb1 = touch[BX] * ny - touch[BY] * nx
  let gap = touch[GAP]
  let ta = touch[AX] * nx + touch[AY] * ny
  let tb = touch[BX] * nx + touch[BY] * ny
  const across = nx * dx + ny * dy
  d[k + NX] = nx
  d[k + NY] = ny
  d[k + NA] = na1
  d[k + NB] = nb1
  d[k + BASE] = touch[GAP] - across - nb1 * (angleB + turned) + na1 * angleA
  const k11 = im + iia * na1 * na1 + iib * nb1 * nb1
  d[k + K] = k11
  d[k + MASS] = 1 / k11
  if (count > 1) {
    const na2 = touch[POINT + AX] * ny - touch[POINT + AY] * nx
    const nb2 = touch[POINT + BX] * ny - touch[POINT + BY] * nx
    // Friction acts where the load is, and without any where the two are nearer: the other end may be pixels away.
    const whole = d[k + LOAD] + d[k + SECOND + LOAD]
    const share = whole > 0 ? d[k + SECOND + LOAD] / whole : touch[POINT + GAP] < gap ? 1 : 0
    ta += share * (touch[POINT + AX] * nx + touch[POINT + AY] * ny - ta)
    tb += share * (touch[POINT + BX] * nx + touch[POINT + BY] * ny - tb)
    gap += share * (touch[POINT + GAP] - gap)
    const k22 = im + iia * na2 * na2 + iib * nb2 * nb2
    const k12 = im + iia * na1 * na2 + iib * nb1 * nb2
    const det = k11 * k22 - k12 * k12
    d[k + SECOND + NA] = na2
    d[k + SECOND + NB] = nb2
    d[k + SECOND + BASE] = touch[POINT + GAP] - across - nb2 * (angleB + turned) + na2 * angleA
    d[k + SECOND + K] = k22
    d[k + SECOND + MASS] = 1 / k22
    d[k + K12] = k12
    d[k + INV_DET] = det > 0.001 * k11 * k22 ? 1 / det : 0
  }
  if (a > 0) {
    // Friction acts midway between the two surfaces: across a gap it would turn what it pushes.
    ta += gap / 2
    tb -= gap / 2
  }
  d[k + TA] = ta
  d[k + TB] = tb
  d[k + MASS_T] = 1 / (im + iia * ta * ta + iib * tb * tb)
  if (loaded) {
    // Over the sub-step the push acts with the arms half way between the old ones and these.
    if (a === 0 && had === count && same) {
      const now = nb1 * d[k + LOAD] + d[k + SECOND + NB] * d[k + SECOND + LOAD] + tb * d[k + DRAG]
      d[k + LAG] = 0.5 * iib * (torque - now)
    }
    carry(scene, c, 1)
  }
}

/** Leaves in `touch` the gap (px) of the point of contact `c` with its record at `p`, and the rate (px/s) at which it opens. */
export function probe({ bodies, contacts }: Scene, c: number, p: number): void {
  const d = contacts.data
  const k = (c & INDEX) * CONTACT
  const a = (contacts.pair[2 * c] & INDEX) * STATE
  const b = (contacts.pair[2 * c + 1] & INDEX) * STATE
  const s = bodies.state
  const nx = d[k + NX]
  const ny = d[k + NY]
  const na = d[p + NA]
  const nb = d[p + NB]
  touch[GAP_NOW] =
    d[p + BASE] +
    nx * (s[b + X] - s[a + X]) +
    ny * (s[b + Y] - s[a + Y]) +
    nb * s[b + ANGLE] -
    na * s[a + ANGLE]
  touch[RATE_NOW] =
    nx * (s[b + VX] - s[a + VX]) + ny * (s[b + VY] - s[a + VY]) + nb * s[b + SPIN] - na * s[a + SPIN]
}

/** px/s, change of that rate over the sub-step by gravity and by the contacts that already push. */
export function gainOf({ bodies, contacts, gravity, h }: Scene, c: number, p: number): number {
  const { data: d, pair } = contacts
  const m = bodies.motion
  const k = (c & INDEX) * CONTACT
  const a = (pair[2 * c] & INDEX) * MOTION
  const b = (pair[2 * c + 1] & INDEX) * MOTION
  return (
    d[k + NX] * (m[b + PUSH_X] - m[a + PUSH_X]) +
    d[k + NY] * (m[b + PUSH_Y] - m[a + PUSH_Y] + (a > 0 ? 0 : gravity * h)) +
    d[p + NB] * m[b + PUSH_SPIN] -
    d[p + NA] * m[a + PUSH_SPIN]
  )
}

/** px, lower bound of the present gap of contact `c`, without measuring: no point of the two has come nearer by more than this. */
export function gapBound({ bodies, contacts }: Scene, c: number): number {
  const s = bodies.state
  const d = contacts.data
  const a = contacts.pair[2 * c] & INDEX
  const b = contacts.pair[2 * c + 1] & INDEX
  const k = c * CONTACT
  const x = s[b * STATE + X] - s[a * STATE + X] - d[k + FROM_X]
  const y = s[b * STATE + Y] - s[a * STATE + Y] - d[k + FROM_Y]
  const turnA = s[a * STATE + ANGLE] - d[k + FROM_A]
  const turnB = s[b * STATE + ANGLE] - d[k + FROM_B]
  return (
    d[k + CLEAR] -
    (Math.abs(x) +
      Math.abs(y) +
      bodies.shape[a * SHAPE + CORE] * Math.abs(turnA) +
      bodies.shape[b * SHAPE + CORE] * Math.abs(turnB))
  )
}

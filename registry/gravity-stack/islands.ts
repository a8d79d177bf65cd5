import {
  ANGLE,
  type Bodies,
  EXTENT,
  grown,
  MOTION,
  NEXT,
  SHAPE,
  SPIN,
  STATE,
  VX,
  VY,
  WAY,
  X,
  Y,
} from './body'
import { touch, type Walls } from './collide'
import { MARGIN, REST_DISTANCE, REST_TIME, STEP } from './constants'
import { CONTACT, type Contacts, LOAD1, LOAD2, measure, POINTS, REACH } from './contacts'

/**
 * Who may touch whom within the step. Bodies that may are one island and are solved together; a body alone in the air
 * needs no solving at all. Later, who carries whom: such a group falls asleep together once all of it is at rest.
 */
export interface Islands {
  parent: Int32Array
  /** px that a body, and then anything in its island, may go within the step. */
  reach: Float64Array
  /** Contacts that matter in this step. */
  near: Int32Array
  nearCount: number
  /** Bodies and contacts island by island: island n has bodies[bodyStart[n]..bodyStart[n + 1]). */
  count: number
  bodies: Int32Array
  bodyStart: Int32Array
  contacts: Int32Array
  contactStart: Int32Array
  /** Number of the island by root. */
  number: Int32Array
}

export function createIslands(): Islands {
  return {
    parent: new Int32Array(0),
    reach: new Float64Array(0),
    near: new Int32Array(64),
    nearCount: 0,
    count: 0,
    bodies: new Int32Array(0),
    bodyStart: new Int32Array(0),
    contacts: new Int32Array(64),
    contactStart: new Int32Array(0),
    number: new Int32Array(0),
  }
}

export function reserveIslands(islands: Islands, bodies: number): void {
  if (islands.parent.length >= bodies) return
  islands.parent = grown(islands.parent, bodies)
  islands.reach = grown(islands.reach, bodies)
  islands.bodies = grown(islands.bodies, bodies)
  islands.bodyStart = grown(islands.bodyStart, bodies + 1)
  islands.contactStart = grown(islands.contactStart, bodies + 1)
  islands.number = grown(islands.number, bodies)
}

/** Root of the island of body `i`. */
export function find(parent: Int32Array, i: number): number {
  while (parent[i] !== i) {
    parent[i] = parent[parent[i]]
    i = parent[i]
  }
  return i
}

function unite(parent: Int32Array, reach: Float64Array, i: number, j: number): void {
  const a = find(parent, i)
  const b = find(parent, j)
  if (a === b) return
  // The lower slot is the root, so that the order of islands does not depend on the order of contacts.
  const root = Math.min(a, b)
  const leaf = Math.max(a, b)
  parent[leaf] = root
  if (reach[leaf] > reach[root]) reach[root] = reach[leaf]
}

/** px, bound of the present gap of contact `c`. */
function gapBound(bodies: Bodies, contacts: Contacts, c: number): number {
  const m = bodies.motion
  return (
    contacts.data[c * CONTACT + REACH] -
    m[contacts.pair[2 * c] * MOTION + WAY] -
    m[contacts.pair[2 * c + 1] * MOTION + WAY]
  )
}

/** Whether contact `c` may close within the step when its bodies go `reach` px; it is measured if need be. */
function mayTouch(bodies: Bodies, contacts: Contacts, walls: Walls, c: number, reach: number): boolean {
  if (contacts.data[c * CONTACT + POINTS] > 0) return true
  if (gapBound(bodies, contacts, c) > reach + MARGIN) return false
  touch.margin = MARGIN
  measure(bodies, contacts, walls, c)
  return touch.gap <= reach + MARGIN
}

/**
 * Islands of the `count` bodies listed in `awake`. `wake` is asked to wake a sleeper that is about to be hit; it appends
 * to the list and returns its new length.
 */
export function findIslands(
  islands: Islands,
  bodies: Bodies,
  contacts: Contacts,
  walls: Walls,
  gravity: number,
  awake: Int32Array,
  count: number,
): void {
  const { parent, reach } = islands
  const { state, motion, shape } = bodies
  const fall = 0.5 * Math.abs(gravity) * STEP * STEP
  for (let n = 0; n < count; n++) {
    const i = awake[n]
    const s = i * STATE
    parent[i] = i
    const go =
      (Math.abs(state[s + VX]) +
        Math.abs(state[s + VY]) +
        shape[i * SHAPE + EXTENT] * Math.abs(state[s + SPIN])) *
        STEP +
      fall
    reach[i] = go
    motion[i * MOTION + NEXT] = go
  }
  islands.nearCount = 0
  gather(islands, bodies, contacts, walls, awake, count, false)
  // A fast body hands its speed on: whatever it may touch may go as far, and touch others in turn.
  gather(islands, bodies, contacts, walls, awake, count, true)

  // Bodies, then contacts, sorted by island.
  const { number, bodyStart, contactStart, near, nearCount } = islands
  let islandCount = 0
  for (let n = 0; n < count; n++) {
    const i = awake[n]
    if (find(parent, i) === i) {
      number[i] = islandCount++
      bodyStart[islandCount] = 0
      contactStart[islandCount] = 0
    }
  }
  islands.count = islandCount
  bodyStart[0] = 0
  contactStart[0] = 0
  for (let n = 0; n < count; n++) bodyStart[number[find(parent, awake[n])] + 1]++
  for (let n = 0; n < nearCount; n++) contactStart[number[find(parent, contacts.pair[2 * near[n] + 1])] + 1]++
  for (let n = 0; n < islandCount; n++) {
    bodyStart[n + 1] += bodyStart[n]
    contactStart[n + 1] += contactStart[n]
  }
  if (islands.contacts.length < nearCount) islands.contacts = new Int32Array(islands.near.length)
  // Filled from the ends, so that the starts need no second array; backwards, so that the order stays.
  for (let n = count - 1; n >= 0; n--) {
    const island = number[find(parent, awake[n])]
    islands.bodies[--bodyStart[island + 1]] = awake[n]
  }
  for (let n = nearCount - 1; n >= 0; n--) {
    const island = number[find(parent, contacts.pair[2 * near[n] + 1])]
    islands.contacts[--contactStart[island + 1]] = near[n]
  }
  // Each start now stands one place to the right.
  for (let n = 0; n < islandCount; n++) {
    bodyStart[n] = bodyStart[n + 1]
    contactStart[n] = contactStart[n + 1]
  }
  bodyStart[islandCount] = count
  contactStart[islandCount] = nearCount
}

function gather(
  islands: Islands,
  bodies: Bodies,
  contacts: Contacts,
  walls: Walls,
  awake: Int32Array,
  count: number,
  again: boolean,
): void {
  const { parent, reach } = islands
  const { pair } = contacts
  for (let n = 0; n < count; n++) {
    const i = awake[n]
    let mine = reach[i]
    if (again) {
      const root = reach[find(parent, i)]
      if (root <= mine + 1) continue
      mine = root
    }
    for (let edge = contacts.head[i]; edge >= 0; edge = contacts.next[edge]) {
      const c = edge >> 1
      const j = pair[edge ^ 1]
      if (j > 0 && bodies.asleep[j] === 1) continue
      const theirs = j === 0 ? 0 : again ? reach[find(parent, j)] : reach[j]
      // Every pair once a round: from A, from the wall's only side, and in the second round only what the first left out.
      if (contacts.mark[c] === -1) continue
      if (!mayTouch(bodies, contacts, walls, c, mine + theirs)) continue
      contacts.mark[c] = -1
      if (islands.nearCount >= islands.near.length) islands.near = grown(islands.near, islands.nearCount * 2)
      islands.near[islands.nearCount++] = c
      if (j > 0) unite(parent, reach, i, j)
    }
  }
  if (again) for (let n = 0; n < islands.nearCount; n++) contacts.mark[islands.near[n]] = 0
}

/**
 * Counts how long each awake body has kept its place, then puts to sleep every group that carries each other and of
 * which all have done so for `REST_TIME`. Returns the bodies that stay awake, at the front of `awake`.
 */
export function rest(
  islands: Islands,
  bodies: Bodies,
  contacts: Contacts,
  held: Uint8Array,
  awake: Int32Array,
  count: number,
): number {
  const { state, shape } = bodies
  const { parent } = islands
  const still = bodies.rest
  let ready = false
  for (let n = 0; n < count; n++) {
    const i = awake[n]
    const s = i * STATE
    const r = i * 4
    const off =
      Math.abs(state[s + X] - still[r]) +
      Math.abs(state[s + Y] - still[r + 1]) +
      shape[i * SHAPE + EXTENT] * Math.abs(state[s + ANGLE] - still[r + 2])
    if (off > REST_DISTANCE || held[i] > 0) {
      still[r] = state[s + X]
      still[r + 1] = state[s + Y]
      still[r + 2] = state[s + ANGLE]
      still[r + 3] = 0
    } else {
      still[r + 3] += STEP
      if (still[r + 3] >= REST_TIME) ready = true
    }
  }
  if (!ready) return count

  // `reach` is free by now: it holds the shortest rest of each group, negative so that `unite` keeps the least.
  const least = islands.reach
  for (let n = 0; n < count; n++) {
    const i = awake[n]
    parent[i] = i
    least[i] = -still[i * 4 + 3]
  }
  for (let n = 0; n < islands.nearCount; n++) {
    const c = islands.near[n]
    const a = contacts.pair[2 * c]
    const b = contacts.pair[2 * c + 1]
    if (a > 0 && contacts.data[c * CONTACT + LOAD1] + contacts.data[c * CONTACT + LOAD2] > 0)
      unite(parent, least, a, b)
  }
  let left = 0
  for (let n = 0; n < count; n++) {
    const i = awake[n]
    if (-least[find(parent, i)] < REST_TIME) awake[left++] = i
    else {
      bodies.asleep[i] = 1
      state.fill(0, i * STATE + VX, i * STATE + SPIN + 1)
    }
  }
  return left
}

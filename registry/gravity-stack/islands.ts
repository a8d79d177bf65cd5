import { ANGLE, CORE, EXTENT, INDEX, MOTION, SHAPE, SPIN, STATE, speedOf, TRAVEL, VX, VY, X, Y } from './body'
import { DISTANCE, touch, WIDEST } from './collide'
import { DEEP, FOLLOW, LOOSE, MARGIN, REST_DISTANCE, REST_TIME, SLOP, STEP } from './constants'
import {
  CLEAR,
  CONTACT,
  DUE,
  FROM_X,
  gapBound,
  loadOf,
  MEASURED,
  measure,
  POINTS,
  type Scene,
} from './contacts'
import { pull } from './grab'

/**
 * Who may touch whom within the step. Bodies that may are one island and are solved together; a body alone in the air
 * needs no solving at all. Later, who carries whom: such a group falls asleep together once all of it is at rest.
 */
export class Islands {
  parent: Int32Array = new Int32Array(1)
  /** px by which the fastest approach in an island may close a gap within the step. */
  reach: Float64Array = new Float64Array(1)
  /** px, that of its island when each body was last asked whom it may be knocked into. */
  asked: Float64Array = new Float64Array(1)
  /** Contacts that matter in this step. */
  nearCount = 0
  /** Bodies and contacts island by island: island n has bodies[bodyStart[n]..bodyStart[n + 1]). */
  count = 0
  bodies: Int32Array = new Int32Array(1)
  bodyStart: Int32Array = new Int32Array(2)
  contactStart: Int32Array = new Int32Array(2)
  /** Sleepers that something may be knocked into in this step. */
  struck: Int32Array = new Int32Array(1)
  struckCount = 0
  /** Number of the island of each body. */
  number: Int32Array = new Int32Array(1)
}

/** Root of the island of body `i`. */
function find(parent: Int32Array, i: number): number {
  while (parent[i] !== i) {
    parent[i] = parent[parent[i]]
    i = parent[i]
  }
  return i
}

/** Makes one island of two by their roots; returns the new root. */
function unite({ parent, reach }: Islands, a: number, b: number): number {
  // The lower slot is the root, so that the order of islands does not depend on the order of contacts.
  const root = Math.min(a, b)
  const leaf = Math.max(a, b)
  parent[leaf] = root
  if (reach[leaf] > reach[root]) reach[root] = reach[leaf]
  return root
}

/** Islands of the bodies that are awake. Where `struck` lists any, they are to be woken, and the islands found again. */
export function findIslands(islands: Islands, scene: Scene): void {
  const { asked, parent, reach } = islands
  const { awake, awakeCount: count } = scene.bodies
  const { mark, near, pair, sorted } = scene.contacts
  for (let n = 0; n < count; n++) {
    parent[awake[n]] = awake[n]
    reach[awake[n]] = asked[awake[n]] = 0
  }
  for (const hold of scene.holds) reach[hold.body] = Math.max(reach[hold.body], pull(scene, hold))
  islands.nearCount = 0
  islands.struckCount = 0
  gather(islands, scene, false)
  // A body that hits or is hit may go another way than it came: whatever it may then touch is of its island as well, and
  // what that may touch in its turn.
  let grows = true
  while (grows) grows = gather(islands, scene, true)
  for (let n = 0; n < islands.nearCount; n++) mark[near[n]] = 0

  // Bodies, then contacts, sorted by island.
  const { number, bodyStart, contactStart, nearCount } = islands
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
  for (let n = 0; n < count; n++) {
    const i = awake[n]
    number[i] = number[find(parent, i)]
    bodyStart[number[i] + 1]++
  }
  for (let n = 0; n < nearCount; n++) contactStart[number[pair[2 * near[n] + 1]] + 1]++
  for (let n = 0; n < islandCount; n++) {
    bodyStart[n + 1] += bodyStart[n]
    contactStart[n + 1] += contactStart[n]
  }
  // Filled from the ends, so that the starts need no second array; backwards, so that the order stays.
  for (let n = count - 1; n >= 0; n--) {
    islands.bodies[--bodyStart[number[awake[n]] + 1]] = awake[n]
  }
  for (let n = nearCount - 1; n >= 0; n--) {
    sorted[--contactStart[number[pair[2 * near[n] + 1]] + 1]] = near[n]
  }
  // Each start now stands one place to the right.
  for (let n = 0; n < islandCount; n++) {
    bodyStart[n] = bodyStart[n + 1]
    contactStart[n] = contactStart[n + 1]
  }
  bodyStart[islandCount] = count
  contactStart[islandCount] = nearCount
}

/**
 * Adds the contacts that may close within the step to `near` and unites their bodies; returns whether any were apart. In
 * rounds after the first (`again`) a body may go as far as the fastest approach in its island.
 */
function gather(islands: Islands, scene: Scene, again: boolean): boolean {
  let grew = false
  const { bodies, contacts, gravity } = scene
  const { asked, parent, reach } = islands
  const { data: d, head, mark, near, next, pair } = contacts
  const { state: s, motion, shape, asleep, awake, awakeCount: count } = bodies
  const fall = MARGIN + 0.5 * Math.abs(gravity) * STEP * STEP
  for (let n = 0; n < count; n++) {
    const i = awake[n] & INDEX
    const mine = again ? reach[find(parent, i)] : 0
    if (again) {
      // Where its island's has not grown since, the others' own turns tell.
      if (mine < 1 || mine === asked[i]) continue
      asked[i] = mine
    }
    const a = i * STATE
    const vx = s[a + VX]
    const vy = s[a + VY]
    const coreA = shape[i * SHAPE + CORE]
    const turning = coreA * Math.abs(s[a + SPIN])
    for (let edge = head[i]; edge >= 0; edge = next[edge]) {
      const j = pair[edge ^ 1] & INDEX
      // The first round sees every pair once: from A, or from the chip at a wall.
      if (!again && j > 0 && (edge & 1) === 1) continue
      const c = (edge >> 1) & INDEX
      if (again ? mark[c] === -1 : asleep[j] === 1) continue
      const k = c * CONTACT
      const b = j * STATE
      const coreB = shape[j * SHAPE + CORE]
      const go =
        STEP * (Math.abs(s[b + VX] - vx) + Math.abs(s[b + VY] - vy) + turning + coreB * Math.abs(s[b + SPIN]))
      if (d[k + POINTS] === 0) {
        const root = again && asleep[j] === 0 ? find(parent, j) : 0
        const may = fall + go + mine + (root > 0 && root !== find(parent, i) ? reach[root] : 0)
        const travel = motion[i * MOTION + TRAVEL] + motion[j * MOTION + TRAVEL]
        if (d[k + DUE] - travel > may) continue
        const bound = gapBound(scene, c)
        if (bound > may) {
          d[k + DUE] = travel + bound
          continue
        }
        // Measured again only where that bound has grown loose, and for the gap alone.
        if (!(d[k + CLEAR] - bound < LOOSE)) {
          touch[WIDEST] = -Infinity
          measure(scene, c)
          scene.work[MEASURED]++
          d[k + DUE] = travel + touch[DISTANCE]
          if (touch[DISTANCE] > may) continue
        }
      }
      if (asleep[j] === 1) {
        if (islands.struckCount < islands.struck.length) islands.struck[islands.struckCount++] = j
        continue
      }
      mark[c] = -1
      near[islands.nearCount++] = c
      let root = find(parent, i)
      const other = j > 0 ? find(parent, j) : root
      if (other !== root) {
        root = unite(islands, root, other)
        grew = true
      }
      if (go > reach[root]) reach[root] = go
    }
  }
  return grew
}

/**
 * Counts how long each awake body has kept its place, then puts to sleep every group that carries each other and of
 * which all have done so for `REST_TIME`.
 */
export function rest(islands: Islands, scene: Scene): void {
  const { bodies, contacts, gravity } = scene
  const { state, shape, held, awake, awakeCount: count } = bodies
  const { parent } = islands
  const still = bodies.rest
  const grasped = scene.holds.length > 0
  let ready = grasped
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
      // Else creep too slow to be seen would keep some chip of a large pile's clock from running out.
      for (let axis = 0; axis < 3; axis++) still[r + axis] += FOLLOW * (state[s + axis] - still[r + axis])
      still[r + 3] += STEP
      if (still[r + 3] >= REST_TIME) {
        // Struck a moment ago it has hardly gone anywhere yet.
        if (moving(scene, i)) still[r + 3] = 0
        else ready = true
      }
      // What is to lie as it does is looked at from near once more: geometry may lag.
      else if (Math.abs(still[r + 3] - 0.5 * REST_TIME) < 0.5 * STEP) {
        for (let edge = contacts.head[i]; edge >= 0; edge = contacts.next[edge]) {
          contacts.data[(edge >> 1) * CONTACT + DUE] = -Infinity
          contacts.data[(edge >> 1) * CONTACT + FROM_X] = Infinity
        }
      }
    }
  }
  if (!ready) return

  // `reach` is free by now: it holds the shortest rest of each group, negative so that `unite` keeps the least. Nothing
  // rests on nothing, unless it floats.
  const least = islands.reach
  for (let n = 0; n < count; n++) {
    parent[awake[n]] = awake[n]
    least[awake[n]] = gravity === 0 ? -still[awake[n] * 4 + 3] : 0
  }
  for (let again = 0; again < 2; again++) {
    for (let n = 0; n < islands.nearCount; n++) {
      const c = contacts.near[n]
      const a = contacts.pair[2 * c]
      const b = contacts.pair[2 * c + 1]
      if (loadOf(contacts, c) === 0) continue
      if (again === 0) {
        least[a] = -still[a * 4 + 3]
        least[b] = -still[b * 4 + 3]
      } else if (a > 0) unite(islands, find(parent, a), find(parent, b))
    }
  }
  // What a blow in this very step has lifted would hang there.
  for (let n = 0; n < islands.nearCount; n++) {
    const c = contacts.near[n]
    const b = contacts.pair[2 * c + 1]
    if (loadOf(contacts, c) === 0) continue
    if (!rested(islands, b)) continue
    // The last measurement may be some tenths of a pixel old.
    touch[WIDEST] = MARGIN
    measure(scene, c)
    scene.work[MEASURED]++
    if (touch[DISTANCE] > DEEP + SLOP) least[find(parent, b)] = 0
  }
  bodies.awakeCount = 0
  for (let n = 0; n < count; n++) {
    const i = awake[n]
    if (rested(islands, i)) {
      bodies.asleep[i] = 1
      state.fill(0, i * STATE + VX, i * STATE + SPIN + 1)
    } else {
      // The hand that keeps it awake may go, and what leans on the chip in it would hang there.
      if (grasped) still[i * 4 + 3] = -least[find(parent, i)]
      awake[bodies.awakeCount++] = i
    }
  }
}

/** Whether body `i` is faster than creep, and than friction would stop within the distance that rest allows. */
function moving({ bodies, friction, gravity }: Scene, i: number): boolean {
  const speed = speedOf(bodies, i)
  return speed * speed > Math.max(1, 2 * friction * Math.abs(gravity) * REST_DISTANCE)
}

/** Whether the whole group of body `i` has kept its place for long enough, once `reach` holds how long. */
function rested({ parent, reach }: Islands, i: number): boolean {
  return -reach[find(parent, i)] >= REST_TIME
}

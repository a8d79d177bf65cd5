import { type Bodies, CORE, extents, halfExtents, SHAPE, SPIN, STATE, VX, VY, X, Y } from './body'
import { collide, DISTANCE, NORMAL_X, NORMAL_Y, touch, WIDEST } from './collide'
import { MARGIN, SKIN, SKIN_SHARE, STEP, WALL_SKIN } from './constants'
import { addContact, type Contacts, removeContact, type Scene } from './contacts'
import { keepInside } from './solver'

/**
 * Broad phase: boxes larger than the chips by a skin and the way ahead, sorted along x. Nothing is done until a chip
 * leaves its box; at rest that is never.
 */
export class Pairs {
  /** Left, top, right, bottom of each body's enlarged box, px. */
  box: Float64Array = new Float64Array(4)
  /** Bodies by the left edge of their box. */
  order: Int32Array = new Int32Array(1)
  sorted = 0
  /** 1 for a body that left its box in this step, or was kept back at its end. */
  moved: Uint8Array = new Uint8Array(1)
  /** Last body for which this one was marked as a partner. */
  partner: Int32Array = new Int32Array(1)
  /** Contact with each wall (floor, left, right) of each body, -1 without. */
  wallContact: Int32Array = new Int32Array(3)
}

/** Makes body `i` known to the broad phase; its box is made in the next `updatePairs`. */
export function enterPairs(pairs: Pairs, contacts: Contacts, i: number): void {
  contacts.head[i] = -1
  pairs.wallContact.fill(-1, i * 3, i * 3 + 3)
  pairs.box[i * 4] = Infinity
  pairs.order[pairs.sorted++] = i
}

export function leavePairs(pairs: Pairs, contacts: Contacts, i: number): void {
  const at = pairs.order.indexOf(i)
  pairs.order.copyWithin(at, at + 1, pairs.sorted--)
  while (contacts.head[i] >= 0) removeContact(contacts, contacts.head[i] >> 1)
}

/** Whether body `i` will leave its box within the step; if so the box is made anew around the way ahead. */
function outgrown(bodies: Bodies, pairs: Pairs, gravity: number, i: number): boolean {
  const { state, shape } = bodies
  const s = i * STATE
  // A chip that spins reaches further before the step is over.
  halfExtents(bodies, i, 0, STEP * shape[i * SHAPE + CORE] * Math.abs(state[s + SPIN]))
  const ex = extents[X]
  const ey = extents[Y]
  const goX = state[s + VX] * STEP
  const goY = state[s + VY] * STEP
  const fall = 0.5 * gravity * STEP * STEP
  const left = state[s + X] - ex + Math.min(goX, 0)
  const right = state[s + X] + ex + Math.max(goX, 0)
  const top = state[s + Y] - ey + Math.min(goY, goY + fall, 0)
  const bottom = state[s + Y] + ey + Math.max(goY, goY + fall, 0)
  const box = pairs.box
  const k = i * 4
  if (left >= box[k] && top >= box[k + 1] && right <= box[k + 2] && bottom <= box[k + 3]) return false
  // What it hits on the way may turn it aside.
  const skin = SKIN + SKIN_SHARE * (Math.abs(goX) + Math.abs(goY))
  box[k] = left - skin + Math.min(goX, 0)
  box[k + 1] = top - skin + Math.min(goY, 0)
  box[k + 2] = right + skin + Math.max(goX, 0)
  box[k + 3] = bottom + skin + Math.max(goY, 0)
  return true
}

/** Brings the pair list up to date with the boxes of the bodies that are awake. */
export function updatePairs({ bodies, contacts, walls, gravity }: Scene, pairs: Pairs): void {
  const { awake, awakeCount: count } = bodies
  const { box, order, moved, partner, wallContact } = pairs
  let any = false
  for (let a = 0; a < count; a++) {
    const i = awake[a]
    moved[i] = 0
    if (!outgrown(bodies, pairs, gravity, i)) continue
    moved[i] = 1
    any = true
    const k = i * 4
    for (let w = 0; w < 3; w++) {
      const near =
        w === 0
          ? box[k + 3] > walls.height - WALL_SKIN
          : w === 1
            ? box[k] < WALL_SKIN
            : box[k + 2] > walls.width - WALL_SKIN
      const have = wallContact[i * 3 + w]
      if (near && have < 0) wallContact[i * 3 + w] = addContact(contacts, 0, i, w + 1)
      else if (!near && have >= 0) {
        removeContact(contacts, have)
        wallContact[i * 3 + w] = -1
      }
    }
  }
  if (!any) return

  // Pairs whose boxes have parted.
  for (let a = 0; a < count; a++) {
    const i = awake[a]
    if (moved[i] === 0) continue
    let edge = contacts.head[i]
    while (edge >= 0) {
      const after = contacts.next[edge]
      const j = contacts.pair[edge ^ 1]
      if (j > 0 && !overlap(box, i * 4, j * 4)) removeContact(contacts, edge >> 1)
      edge = after
    }
  }

  // Insertion sort: the order hardly changes from one step to the next.
  const n = pairs.sorted
  for (let a = 1; a < n; a++) {
    const i = order[a]
    const left = box[i * 4]
    let b = a - 1
    while (b >= 0 && box[order[b] * 4] > left) {
      order[b + 1] = order[b]
      b--
    }
    order[b + 1] = i
  }
  for (let a = 0; a < n; a++) {
    const i = order[a]
    const right = box[i * 4 + 2]
    const movedI = moved[i]
    let marked = false
    for (let b = a + 1; b < n; b++) {
      const j = order[b]
      if (box[j * 4] > right) break
      if (movedI === 0 && moved[j] === 0) continue
      if (box[i * 4 + 1] > box[j * 4 + 3] || box[j * 4 + 1] > box[i * 4 + 3]) continue
      if (!marked) {
        marked = true
        markPartners(partner, contacts, i, i)
      }
      if (partner[j] !== i) addContact(contacts, Math.min(i, j), Math.max(i, j), 0)
    }
    // The marks of one body must not outlive it.
    if (marked) markPartners(partner, contacts, i, 0)
  }
  for (let a = 0; a < count; a++) moved[awake[a]] = 0
}

/**
 * A chip that is knocked away, or pulled by a hand, may go farther within the step than its box foresaw. Past the edge of its box it goes
 * only as far as the way is free of those that it has no contact with: its velocity stays, and the next step sees it come. What has come
 * into it from behind, or into one struck into a wall, stays behind it, if its island's fastest point had the `speed` for it, px/s.
 */
export function keepBack(scene: Scene, pairs: Pairs, i: number, speed: number): void {
  const { bodies, contacts } = scene
  const { box, order, partner } = pairs
  const { before, state } = bodies
  const k = i * 4
  const s = i * STATE
  halfExtents(bodies, i, 0, 0)
  const ex = extents[X]
  const ey = extents[Y]
  const x = state[s + X]
  const y = state[s + Y]
  // What is slower knocks nothing out of its box: in a jam all is pushed, and what is pushed back has nowhere to go.
  const fast = speed * STEP > SKIN
  let backX = between(x, box[k] + ex, box[k + 2] - ex)
  let backY = between(y, box[k + 1] + ey, box[k + 3] - ey)
  if (fast) {
    // Turned meanwhile it may reach over the edge where it came from: behind that is what it has bounced off.
    backX = between(before[i * 3], Math.min(x, backX), Math.max(x, backX))
    backY = between(before[i * 3 + 1], Math.min(y, backY), Math.max(y, backY))
  }
  let share = 1
  if (backX !== x || backY !== y) {
    state[s + X] = backX
    state[s + Y] = backY
    const goX = x - backX
    const goY = y - backY
    touch[WIDEST] = Infinity
    markPartners(partner, contacts, i, i)
    for (let b = 0; b < pairs.sorted; b++) {
      const j = order[b]
      if (j === i || partner[j] === i) continue
      halfExtents(bodies, j, 0, 0)
      // Neither where it is nor on the way back.
      if (Math.abs(2 * state[j * STATE + X] - x - backX) > Math.abs(goX) + 2 * (ex + extents[X])) continue
      if (Math.abs(2 * state[j * STATE + Y] - y - backY) > Math.abs(goY) + 2 * (ey + extents[Y])) continue
      // As far as the line between the two lets it go, which is never into it.
      collide(bodies, i, j)
      const toward = touch[NORMAL_X] * goX + touch[NORMAL_Y] * goY
      if (toward > 0) share = Math.min(share, Math.max(0, touch[DISTANCE]) / toward)
    }
    state[s + X] = backX + share * goX
    state[s + Y] = backY + share * goY
    markPartners(partner, contacts, i, 0)
  }
  keepInside(scene, i)
  const dx = state[s + X] - x
  const dy = state[s + Y] - y
  if (fast && (share < 1 || Math.abs(dx) + Math.abs(dy) > MARGIN)) keepBehind(scene, pairs, i, dx, dy)
}

/** `at`, no less than `low` and no more than `high`. */
function between(at: number, low: number, high: number): number {
  return Math.max(Math.min(at, high), low)
}

/** Body `i` was put back by `dx` and `dy`: what is in it now goes back as well, each body once a step, and no further than the two came nearer. */
function keepBehind(scene: Scene, pairs: Pairs, i: number, dx: number, dy: number): void {
  const { bodies, contacts } = scene
  const { asleep, before, state } = bodies
  const s = i * STATE
  pairs.moved[i] = 1
  for (let edge = contacts.head[i]; edge >= 0; edge = contacts.next[edge]) {
    const j = contacts.pair[edge ^ 1]
    const t = j * STATE
    if (j === 0 || pairs.moved[j] + asleep[j] > 0) continue
    // Which side it came from shows where `i` had got to: put back, that may be past its middle.
    state[s + X] -= dx
    state[s + Y] -= dy
    touch[WIDEST] = Infinity
    collide(bodies, i, j)
    state[s + X] += dx
    state[s + Y] += dy
    const nx = touch[NORMAL_X]
    const ny = touch[NORMAL_Y]
    let back = nx * dx + ny * dy - touch[DISTANCE]
    // What they overlapped by when the step began stays.
    const mine = state.slice(s, s + 3)
    const its = state.slice(t, t + 3)
    for (const k of [i, j]) state.set(before.subarray(k * 3, k * 3 + 3), k * STATE)
    collide(bodies, i, j)
    state.set(mine, s)
    state.set(its, t)
    back += Math.min(0, touch[DISTANCE])
    if (!(back > 0)) continue
    state[t + X] += back * nx
    state[t + Y] += back * ny
    keepInside(scene, j)
    keepBehind(scene, pairs, j, back * nx, back * ny)
  }
}

/** Marks all that body `i` has a contact with, or takes the marks away. */
function markPartners(partner: Int32Array, contacts: Contacts, i: number, mark: number): void {
  for (let edge = contacts.head[i]; edge >= 0; edge = contacts.next[edge])
    partner[contacts.pair[edge ^ 1]] = mark
}

function overlap(box: Float64Array, i: number, j: number): boolean {
  return box[i] <= box[j + 2] && box[j] <= box[i + 2] && box[i + 1] <= box[j + 3] && box[j + 1] <= box[i + 3]
}

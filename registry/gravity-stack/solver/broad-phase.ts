import { extents, halfExtents, isStatic } from './body'
import { AABB_MARGIN, STEP } from './constants'
import { addContact, removeContact } from './contact'
import { type Bodies, CEILING, CORE, FIRST_CHIP, SHAPE, type Simulation, SPIN, STATE, VX } from './state'

/**
 * Broad phase: boxes larger than the chips by a margin and the way ahead, sorted along x. Nothing is done
 * until a chip leaves its box; at rest that is never.
 */

/** Makes the box of body `i` anew around its way ahead if the body may leave it within the step. */
function updateBox(bodies: Bodies, gravity: Float64Array, i: number): void {
  const { state, shape, box, leftBox } = bodies
  const s = i * STATE
  const k = i * 4
  // A chip that spins reaches further before the step is over.
  halfExtents(bodies, i, 0, STEP * shape[i * SHAPE + CORE] * Math.abs(state[s + SPIN]))
  for (let axis = 0; axis < 2; axis++) {
    const go = state[s + VX + axis] * STEP
    const fall = 0.5 * gravity[axis] * STEP * STEP
    const low = state[s + axis] - extents[axis] + Math.min(go, go + fall, 0)
    const high = state[s + axis] + extents[axis] + Math.max(go, go + fall, 0)
    if (low < box[k + axis] || high > box[k + 2 + axis]) leftBox[i] = 1
  }
  for (let axis = 0; leftBox[i] > 0 && axis < 2; axis++) {
    const go = 2 * state[s + VX + axis] * STEP
    const fall = 0.5 * gravity[axis] * STEP * STEP
    const margin = AABB_MARGIN + extents[axis]
    box[k + axis] = state[s + axis] - margin + Math.min(go, go + fall, 0)
    box[k + 2 + axis] = state[s + axis] + margin + Math.max(go, go + fall, 0)
  }
}

/** Brings contacts up to date with the boxes of what is awake; returns whether any body had left its box. */
export function updatePairs({ bodies, contacts, gravity }: Simulation): boolean {
  const { awake, awakeCount, box, leftBox, inside, knocked, leaving, order, orderCount, partner } = bodies
  const { head, next, pair } = contacts
  for (let n = 0; n < awakeCount; n++) if (knocked[awake[n]] > 0) updateBox(bodies, gravity, awake[n])
  knocked.fill(0)
  if (!leftBox.includes(1)) return false

  for (let n = 0; n < awakeCount; n++) {
    const i = awake[n]
    for (let edge = leftBox[i] > 0 ? head[i] : -1; edge >= 0; ) {
      const after = next[edge]
      if (!overlap(box, i * 4, pair[edge ^ 1] * 4)) removeContact(contacts, edge >> 1)
      edge = after
    }
  }

  // Insertion sort: the order hardly changes from one step to the next.
  for (let n = 1; n < orderCount; n++) {
    const i = order[n]
    let m = n - 1
    for (; m >= 0 && box[order[m] * 4] > box[i * 4]; m--) order[m + 1] = order[m]
    order[m + 1] = i
  }

  partner.fill(0)
  let leavers = 0
  for (let n = 0; n < orderCount; n++) if (leftBox[order[n]] > 0) leaving[leavers++] = order[n]
  let passed = 0
  for (let n = 0; n < orderCount; n++) {
    const i = order[n]
    // What is still in its box can have new partners only among what has left its own.
    const leaves = leftBox[i] > 0
    if (leaves) passed++
    const others = leaves ? order : leaving
    const count = leaves ? orderCount : leavers
    let marked = -1
    for (let m = leaves ? n + 1 : passed; m < count; m++) {
      const j = others[m]
      if (box[j * 4] > box[i * 4 + 2]) break
      if (!overlap(box, i * 4, j * 4) || (isStatic(bodies, i) && isStatic(bodies, j))) continue
      // A chip that has not entered the stage yet passes through the ceiling.
      if ((i === CEILING && !inside[j]) || (j === CEILING && !inside[i])) continue
      // A wall keeps no list of its own: then the chip marks all that it has a contact with.
      const lister = i < FIRST_CHIP ? j : i
      if (marked !== lister)
        for (let edge = head[lister]; edge >= 0; edge = next[edge]) partner[pair[edge ^ 1]] = lister
      marked = lister
      if (partner[i + j - lister] !== lister) addContact(bodies, contacts, Math.min(i, j), Math.max(i, j))
    }
  }
  leftBox.fill(0)
  return true
}

export function overlap(box: Float64Array, i: number, j: number): boolean {
  return box[i] <= box[j + 2] && box[j] <= box[i + 2] && box[i + 1] <= box[j + 3] && box[j + 1] <= box[i + 3]
}

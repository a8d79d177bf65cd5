import { isStatic, speedOf } from './body'
import {
  DEEP_OVERLAP,
  LINEAR_SLOP,
  REST_DISTANCE,
  REST_FOLLOW,
  REST_TIME,
  SLOW_CONTACT,
  SPECULATIVE_DISTANCE,
  STEP,
} from './constants'
import { gapOf, normalImpulse, separationAndRate, separationBound, updateContact } from './contact'
import { findGroup, joinGroups } from './islands'
import { GAP_NOW, LEAD, manifold, RATE_NOW, WIDEST } from './manifold'
import {
  ANGLE,
  type Bodies,
  CONTACT,
  EXTENT,
  MOTION,
  SECOND,
  SEPARATION,
  SHAPE,
  type Simulation,
  SPIN,
  STATE,
  STRUCK_AT,
  VX,
  WARM_X,
  WARM_Y,
  X,
} from './state'

/**
 * Counts how long each awake body has kept its place, then puts groups to sleep of which all have done so
 * long enough.
 */
export function updateSleep(simulation: Simulation): void {
  const { bodies, contacts, pull } = simulation
  const { state, motion, shape, awake, asleep, parent, groupRest, rest, supported } = bodies
  const count = bodies.awakeCount
  for (let n = 0; n < count; n++) {
    const i = awake[n]
    const s = i * STATE
    const r = i * 4
    const off =
      Math.abs(state[s + X] - rest[r]) +
      Math.abs(state[s + X + 1] - rest[r + 1]) +
      shape[i * SHAPE + EXTENT] * Math.abs(state[s + ANGLE] - rest[r + 2])
    const moves = off > REST_DISTANCE || speedOf(bodies, i) > SLOW_CONTACT
    // The place of rest follows the body slowly: else invisible creep would keep a large pile awake.
    for (let axis = 0; axis < 3; axis++)
      rest[r + axis] += (moves ? 1 : REST_FOLLOW) * (state[s + axis] - rest[r + axis])
    // What is balanced on one point has to keep its place for twice as long: it may be about to topple.
    rest[r + 3] = moves ? 0 : rest[r + 3] + (STEP * (1 + supported[i])) / 2
    parent[i] = i
    // A body that no contact pushes counts as at rest only where there is no gravity.
    const m = i * MOTION
    const pushed = Math.abs(motion[m + WARM_X]) + Math.abs(motion[m + WARM_Y]) > 0
    groupRest[i] = pushed || pull === 0 ? rest[r + 3] : -1
  }
  for (let n = 0; n < contacts.nearCount; n++) {
    const c = contacts.near[n]
    // Contacts with a smaller gap open and close while a pile settles. Such bodies fall asleep together.
    if (normalImpulse(contacts, c) === 0 && gapOf(simulation, c) > DEEP_OVERLAP) continue
    const a = contacts.pair[2 * c]
    const b = contacts.pair[2 * c + 1]
    if (!isStatic(bodies, a)) joinGroups(bodies, a, b)
  }
  // The manifolds of a group that is to sleep may lag, so they are measured once more. An overlap keeps the
  // group awake to be corrected, for four times `REST_TIME` at most: chips that do not fit would never sleep.
  for (let n = 0; n < contacts.nearCount; n++) {
    const c = contacts.near[n]
    if (contacts.points[c] === 0) continue
    const root = findGroup(parent, contacts.pair[2 * c + 1])
    if (groupRest[root] < REST_TIME || groupRest[root] > 4 * REST_TIME) continue
    manifold[WIDEST] = SPECULATIVE_DISTANCE
    manifold[LEAD] = 0
    updateContact(simulation, c)
    if (contacts.data[c * CONTACT + SEPARATION] < -2 * DEEP_OVERLAP) groupRest[root] = 0
  }
  bodies.awakeCount = 0
  for (let n = 0; n < count; n++) {
    const i = awake[n]
    if (groupRest[findGroup(parent, i)] >= REST_TIME) {
      asleep[i] = 1
      state.fill(0, i * STATE + VX, i * STATE + SPIN + 1)
      bodies.before.set(state.subarray(i * STATE + X, i * STATE + ANGLE + 1), i * 3)
    } else awake[bodies.awakeCount++] = i
  }
}

/** Wakes body `i` and everything that carries it or is carried by it, at any remove. */
export function wake({ bodies, contacts }: Simulation, i: number): void {
  bodies.rest[i * 4 + 3] = 0
  if (bodies.asleep[i] === 0) return
  wakeAlone(bodies, i)
  for (let n = bodies.awakeCount - 1; n < bodies.awakeCount; n++) {
    for (let edge = contacts.head[bodies.awake[n]]; edge >= 0; edge = contacts.next[edge]) {
      const j = contacts.pair[edge ^ 1]
      if (bodies.asleep[j] === 1 && normalImpulse(contacts, edge >> 1) > 0) wakeAlone(bodies, j)
    }
  }
}

export function wakeAlone(bodies: Bodies, i: number): void {
  bodies.asleep[i] = 0
  bodies.rest[i * 4 + 3] = 0
  bodies.needsDrawing[i] = 1
  bodies.motion[i * MOTION + STRUCK_AT] = 0
  bodies.awake[bodies.awakeCount++] = i
}

/** Body `i` is changed from outside: wakes it and all that touch it, whether they carry anything or not. */
export function disturb(simulation: Simulation, i: number): void {
  const { head, next, pair, points } = simulation.contacts
  simulation.revision++
  wake(simulation, i)
  for (let edge = head[i]; edge >= 0; edge = next[edge])
    if (points[edge >> 1] > 0) wake(simulation, pair[edge ^ 1])
}

export function anyAsleep({ bodies }: Simulation): boolean {
  return bodies.asleep.includes(1)
}

/**
 * Wakes the sleepers that something awake is about to hit. One that merely lies against them wakes nobody.
 */
export function wakeStruck(simulation: Simulation): void {
  const { bodies, contacts } = simulation
  const { awake, asleep } = bodies
  const { head, next, pair, points } = contacts
  for (let n = 0; n < bodies.awakeCount; n++) {
    const way = SPECULATIVE_DISTANCE + speedOf(bodies, awake[n]) * STEP
    for (let edge = head[awake[n]]; edge >= 0; edge = next[edge]) {
      const c = edge >> 1
      const j = pair[edge ^ 1]
      if (asleep[j] === 0 || separationBound(simulation, c) > way) continue
      manifold[WIDEST] = way
      manifold[LEAD] = 0
      updateContact(simulation, c)
      for (let p = c * CONTACT, m = points[c]; m > 0; m--, p += SECOND) {
        separationAndRate(simulation, c, p)
        if (manifold[GAP_NOW] < -4 * LINEAR_SLOP || manifold[RATE_NOW] < -SLOW_CONTACT) wake(simulation, j)
      }
    }
  }
}

/** Lists the contacts of what is awake, sleepers that are about to be hit included. */
export function gatherContacts(simulation: Simulation): void {
  if (anyAsleep(simulation)) wakeStruck(simulation)
  const { bodies, contacts } = simulation
  const { awake, asleep } = bodies
  const { head, near, next, pair } = contacts
  let count = 0
  for (let n = 0; n < bodies.awakeCount; n++)
    for (let edge = head[awake[n]]; edge >= 0; edge = next[edge])
      if (edge & 1 && asleep[pair[edge ^ 1]] === 0) near[count++] = edge >> 1
  contacts.nearCount = count
}

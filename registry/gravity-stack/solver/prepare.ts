import { isStatic } from './body'
import {
  LINEAR_SLOP,
  LOADED_CLOSING,
  LOOKAHEAD,
  RECYCLE_DISTANCE,
  SPECULATIVE_DISTANCE,
  WALL_RECYCLE_DISTANCE,
} from './constants'
import { closingDistance, separationAndRate, shiftOf, updateContact } from './contact'
import { DISTANCE, GAP_NOW, LEAD, manifold, WIDEST } from './manifold'
import { correctEarly } from './position-correction'
import { queueImpact } from './restitution'
import {
  CONTACT,
  HORIZON,
  INDEX,
  MOTION,
  NORMAL_IMPULSE,
  SECOND,
  SEPARATION,
  type Simulation,
  TRAVEL,
  VELOCITY_BIAS,
} from './state'

/** Measures again what has moved, before a sub-step, and queues what will hit in it. */
export function updateContacts(simulation: Simulation): void {
  const { bodies, contacts, h, pull, threshold } = simulation
  const { due, near, nearCount, pair, points } = contacts
  const { motion, moved } = bodies
  const enough = SPECULATIVE_DISTANCE + LOOKAHEAD * h * (threshold - pull * h)
  for (let n = 0; n < nearCount; n++) {
    const c = near[n] & INDEX
    const a = pair[2 * c] & INDEX
    const b = pair[2 * c + 1] & INDEX
    const touching = points[c] > 0
    if (touching) {
      if (due[c] > -Infinity && (moved[a] | moved[b]) === 0) continue
    } else if (motion[a * MOTION + HORIZON] + motion[b * MOTION + HORIZON] + SPECULATIVE_DISTANCE < due[c])
      continue
    const way = SPECULATIVE_DISTANCE + closingDistance(simulation, c, LOOKAHEAD * h)
    const travel = motion[a * MOTION + TRAVEL] + motion[b * MOTION + TRAVEL]
    if (!touching || travel > due[c]) {
      const serves = isStatic(bodies, a) ? WALL_RECYCLE_DISTANCE : RECYCLE_DISTANCE
      // `shiftOf` counts relative motion only: bodies that travel together need no new manifold.
      const spare = (touching ? serves : contacts.data[c * CONTACT + SEPARATION]) - shiftOf(simulation, c)
      due[c] = travel + spare
      if (!(spare >= (touching ? 0 : way))) {
        manifold[WIDEST] = way
        manifold[LEAD] = h
        updateContact(simulation, c)
        due[c] = travel + (points[c] > 0 ? serves : manifold[DISTANCE])
      }
    }
    if (points[c] > 0 && way > enough) queueImpact(simulation, c)
  }
}

/**
 * Lists the contacts that touch, and sets how fast each of those that have moved may close its gap in the
 * sub-step.
 */
export function prepareContacts(simulation: Simulation): void {
  const { bodies, contacts, h } = simulation
  const { data: d, near, nearCount, pair, points, live } = contacts
  const { moved } = bodies
  let count = 0
  for (let n = 0; n < nearCount; n++) {
    const c = near[n]
    if (points[c] === 0) continue
    live[count++] = c
    if ((moved[pair[2 * c]] | moved[pair[2 * c + 1]]) === 0) continue
    for (let p = c * CONTACT, m = points[c]; m > 0; m--, p += SECOND) {
      separationAndRate(simulation, c, p)
      const gap = manifold[GAP_NOW]
      // A loaded contact may close only a part of its gap, or it would chatter.
      d[p + VELOCITY_BIAS] = gap > 0 ? ((d[p + NORMAL_IMPULSE] > 0 ? LOADED_CLOSING : 1) * gap) / h : 0
      if (gap < -LINEAR_SLOP) correctEarly(simulation, c, p)
    }
  }
  contacts.liveCount = count
}

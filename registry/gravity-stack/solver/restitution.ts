import { isStatic } from './body'
import {
  BLOW_SPEED,
  IMPACT_ITERATIONS,
  IMPACT_TOLERANCE,
  LEAST_TOLERANCE,
  LOOKAHEAD,
  SPECULATIVE_DISTANCE,
} from './constants'
import {
  closingDistance,
  normalImpulse,
  rateGain,
  separationAndRate,
  separationBound,
  updateContact,
} from './contact'
import { iterate } from './contact-solver'
import { GAP_NOW, LEAD, manifold, RATE_NOW, WIDEST } from './manifold'
import { gatherContacts, wake } from './sleep'
import {
  ARM_NA,
  ARM_TA,
  CONTACT,
  IMPACTS_SOLVED,
  INV_INERTIA,
  INV_MASS,
  MOTION,
  NORMAL_IMPULSE,
  SECOND,
  type Simulation,
  STATE,
  STRUCK_AT,
  TANGENT_BIAS,
  TANGENT_IMPULSE,
  VELOCITY_BIAS,
  VX,
} from './state'

/**
 * Restitution: impacts one contact at a time, in the order of their times inside the sub-step. The velocity
 * changes at the start of the sub-step, so the pose goes back by the change times the time. That makes each
 * impact exact, at any step. Then the contacts of both bodies are tested for impacts again.
 *
 * In a pile the contact solver takes most of the change away again, and a pose that had gone back would stay
 * where nothing moved it. There an impact happens where the bodies are, at the start of the sub-step (D-025).
 */

/** s from the start of the sub-step at which the contact that `foreseeImpact` looked at will hit. */
const ahead: Float64Array = new Float64Array(1)
/** px/s at which a point without an impact may close its gap: any. */
const FREE = 1e9

/**
 * Whether a point of contact `c` will hit within the sub-step hard enough to bounce. Its velocity bias is
 * then what makes it leave as it should, from the velocity at the start of the sub-step.
 */
function foreseeImpact(simulation: Simulation, c: number): boolean {
  const { bodies, contacts, bounce, h, pull, threshold } = simulation
  const { motion } = bodies
  const { data: d, pair, points } = contacts
  const k = c * CONTACT
  // What comes after an earlier impact of this sub-step.
  const from = Math.max(
    motion[pair[2 * c] * MOTION + STRUCK_AT],
    motion[pair[2 * c + 1] * MOTION + STRUCK_AT],
  )
  let soonest = Infinity
  for (let p = k, n = points[c]; n > 0; n--, p += SECOND) {
    d[p + VELOCITY_BIAS] = d[p + NORMAL_IMPULSE] > 0 ? 0 : FREE
    separationAndRate(simulation, c, p)
    const startRate = manifold[RATE_NOW]
    // A stronger push is left over from a blow, and the solver will take it back.
    const acceleration = Math.max(rateGain(simulation, c, p + ARM_NA, false), -BLOW_SPEED - pull * h) / h
    const rate = startRate + acceleration * from
    const gap = Math.max(0, manifold[GAP_NOW] + 0.5 * (startRate + rate) * from)
    const rest = h - from
    const hitSquared = rate * rate - 2 * acceleration * gap
    // The point opens, closes too late, or hits too softly to bounce.
    if (rate > 0 || gap + (rate + 0.5 * acceleration * rest) * rest >= 0) continue
    if (!(hitSquared > threshold * threshold)) continue
    const hit = Math.sqrt(hitSquared)
    const time = from + Math.min(rest, (2 * gap) / (hit - rate))
    // The end that hits first turns the chip, so the other end is tested again after that impact.
    if (time > soonest + IMPACT_TOLERANCE / hit) continue
    if (time < soonest - IMPACT_TOLERANCE / hit) d[k + VELOCITY_BIAS] = d[k + NORMAL_IMPULSE] > 0 ? 0 : FREE
    // A bounce so low that it would land again within the sub-step is left to rest.
    const restitution = bounce * hit > 0.5 * Math.abs(acceleration) * (h - time) ? bounce : 0
    d[p + VELOCITY_BIAS] = -restitution * hit - hit - startRate
    soonest = Math.min(soonest, time)
  }
  ahead[0] = soonest
  return soonest < Infinity
}

/** Queues contact `c` if it will hit; returns whether it will. */
export function queueImpact(simulation: Simulation, c: number): boolean {
  const { contacts } = simulation
  const { queue, queueTime } = contacts
  if (contacts.queueCount >= queue.length || !foreseeImpact(simulation, c)) return false
  let n = contacts.queueCount++
  for (; n > contacts.queueFirst && queueTime[n - 1] > ahead[0]; n--) {
    queue[n] = queue[n - 1]
    queueTime[n] = queueTime[n - 1]
  }
  queue[n] = c
  queueTime[n] = ahead[0]
  return true
}

/**
 * Change, over the sub-step, of field `axis` of body `i`'s velocity by gravity and by the contacts that
 * already push.
 */
function gainOf({ bodies, gravity, h }: Simulation, i: number, axis: number): number {
  return isStatic(bodies, i) ? 0 : bodies.motion[i * MOTION + axis] + (axis < 2 ? gravity[axis] * h : 0)
}

/** Poses of two bodies while they are measured where they will be, and velocities of two before an impact. */
const kept: Float64Array = new Float64Array(12)

/** Measures contact `c` at the poses that its bodies will have at `time`, the time of an impact. */
function measureAt(simulation: Simulation, c: number, time: number): void {
  const { bodies, contacts, h } = simulation
  const { state } = bodies
  for (let n = 0; n < 6; n++) {
    const i = contacts.pair[2 * c + (n > 2 ? 1 : 0)]
    const s = i * STATE + (n % 3)
    kept[n] = state[s]
    state[s] += time * (state[s + VX] + (0.5 * time * gainOf(simulation, i, n % 3)) / h)
  }
  manifold[WIDEST] = SPECULATIVE_DISTANCE + closingDistance(simulation, c, LOOKAHEAD * h)
  manifold[LEAD] = 0
  updateContact(simulation, c)
  for (let n = 0; n < 6; n++) state[contacts.pair[2 * c + (n > 2 ? 1 : 0)] * STATE + (n % 3)] = kept[n]
}

/** Whether body `i` is in no pile: apart from contact `c`, no contact with another chip pushes it. */
function isFree({ bodies, contacts }: Simulation, i: number, c: number): boolean {
  const { head, next, pair } = contacts
  for (let edge = isStatic(bodies, i) ? -1 : head[i]; edge >= 0; edge = next[edge]) {
    const other = edge >> 1
    if (other !== c && normalImpulse(contacts, other) > 0 && !isStatic(bodies, pair[edge ^ 1])) return false
  }
  return true
}

/** Solves the impact of contact `c` if it still will hit, and queues what it sends its bodies into. */
function solveImpact(simulation: Simulation, c: number): void {
  const { bodies, contacts, h, impactRegime } = simulation
  const { data: d, head, live, next, pair, points } = contacts
  const { asleep, changed, knocked, moved, state, motion } = bodies
  const k = c * CONTACT
  const a = pair[2 * c]
  const b = pair[2 * c + 1]
  const free = isFree(simulation, a, c) && isFree(simulation, b, c)
  // In a pile each contact has one impact at most in a sub-step.
  if (!free && contacts.queue.indexOf(c) < contacts.queueFirst - 1) return
  if (!foreseeImpact(simulation, c)) return
  // Measured again at the time of impact until that time stands still.
  let time = -1
  for (let n = 0; free && n < 6 && Math.abs(ahead[0] - time) > 1e-13; n++) {
    time = ahead[0]
    measureAt(simulation, c, time)
    if (!foreseeImpact(simulation, c)) return
  }
  time = ahead[0]
  // In a pile the bodies are struck where they are, at the start of the sub-step.
  const at = free ? time : 0
  // Slip at the time of impact is what it is at the start, and what gravity and contacts add until then.
  d[k + TANGENT_BIAS] = (-rateGain(simulation, c, k + ARM_TA, true) * time) / h
  // The impulses of an impact are its own: those of the contact wait meanwhile.
  const normal1 = d[k + NORMAL_IMPULSE]
  const normal2 = d[k + SECOND + NORMAL_IMPULSE]
  const tangent = d[k + TANGENT_IMPULSE]
  d[k + NORMAL_IMPULSE] = d[k + SECOND + NORMAL_IMPULSE] = d[k + TANGENT_IMPULSE] = 0
  for (let n = 0; n < 6; n++) kept[6 + n] = state[(n > 2 ? b : a) * STATE + VX + (n % 3)]
  // Two bodies in no pile are solved exactly, others to `LEAST_TOLERANCE`.
  impactRegime.tolerance = free ? 1e-11 : LEAST_TOLERANCE
  changed[a] = changed[b] = 0
  live[0] = c
  for (let n = 0; n < IMPACT_ITERATIONS && iterate(simulation, impactRegime, 1, n) > n; n++);
  simulation.work[IMPACTS_SOLVED]++
  d[k + NORMAL_IMPULSE] = normal1
  d[k + SECOND + NORMAL_IMPULSE] = normal2
  d[k + TANGENT_IMPULSE] = tangent
  d[k + TANGENT_BIAS] = 0

  // A share of the impulse changes the energy by share · linear + share² · square / 2. Where restitution and
  // friction together ask for more energy than there was, the share is less than all.
  let linear = 0
  let square = 0
  for (let n = 0; n < 6; n++) {
    const i = n > 2 ? b : a
    const s = i * STATE + VX + (n % 3)
    const mass = isStatic(bodies, i) ? 0 : 1 / state[i * STATE + (n % 3 > 1 ? INV_INERTIA : INV_MASS)]
    const change = state[s] - kept[6 + n]
    linear += mass * change * (kept[6 + n] + (time * gainOf(simulation, i, n % 3)) / h)
    square += mass * change * change
  }
  const share = -2 * linear < square ? (-2 * linear) / square : 1
  for (let n = 0; n < 6; n++) {
    const i = n > 2 ? b : a
    const s = i * STATE + (n % 3)
    const change = share * (state[s + VX] - kept[6 + n])
    state[s + VX] = kept[6 + n] + change
    state[s] -= change * at
    // A static body never counts as moved: `trackTravel` would not clear that again.
    if (isStatic(bodies, i)) continue
    moved[i] = knocked[i] = 1
    motion[i * MOTION + STRUCK_AT] = at
  }

  // The other end may hit too. Only a later hit counts, or a chip would rattle from end to end for ever.
  if (foreseeImpact(simulation, c) && ahead[0] > time + IMPACT_TOLERANCE * h) queueImpact(simulation, c)
  // What the two will hit in turn.
  for (let side = 0; side < 2; side++) {
    const i = pair[2 * c + side]
    for (let edge = isStatic(bodies, i) ? -1 : head[i]; edge >= 0; edge = next[edge]) {
      const other = edge >> 1
      if (other === c) continue
      const way = SPECULATIVE_DISTANCE + closingDistance(simulation, other, LOOKAHEAD * h)
      if (separationBound(simulation, other) > way) continue
      if (points[other] === 0) measureAt(simulation, other, at)
      // A sleeper about to be hit wakes now: in the next sub-step the two would already overlap.
      if (queueImpact(simulation, other) && asleep[pair[edge ^ 1]] > 0) wake(simulation, pair[edge ^ 1])
    }
  }
}

/** Solves the impacts of the sub-step, each at its time. */
export function solveImpacts(simulation: Simulation): void {
  const { bodies, contacts } = simulation
  const { awakeCount } = bodies
  for (let n = 0; n < contacts.queueCount; n++) {
    contacts.queueFirst = n + 1
    solveImpact(simulation, contacts.queue[n])
  }
  if (bodies.awakeCount > awakeCount) gatherContacts(simulation)
  contacts.queueCount = contacts.queueFirst = 0
}

import { updatePairs } from './broad-phase'
import { CORRECTIONS, ROOM_VISITS, SPECULATIVE_DISTANCE } from './constants'
import { updateContact } from './contact'
import { LEAD, manifold, WIDEST } from './manifold'
import { correctPositions, keepInside, liftWedged } from './position-correction'
import { gatherContacts } from './sleep'
import { FIRST_CHIP, type Simulation, STATE } from './state'

/** Corrections in a row: more would push along normals that no longer hold. */
const PASSES = CORRECTIONS / 4

/**
 * Walls have moved, or chips have grown: what is in them now is moved aside, and what lies there in turn. No
 * velocity changes, so that nothing is thrown. After a jump it takes some steps.
 */
export function makeRoom(simulation: Simulation): void {
  const { contacts } = simulation
  if (simulation.cramped > 0) simulation.cramped--
  for (let visits = ROOM_VISITS; simulation.cramped > 0 && visits > 0; ) {
    simulation.bodies.knocked.fill(1)
    updatePairs(simulation)
    gatherContacts(simulation)
    const { live, near, nearCount } = contacts
    for (let n = 0; n < nearCount; n++) {
      live[n] = near[n]
      manifold[WIDEST] = SPECULATIVE_DISTANCE
      manifold[LEAD] = 0
      updateContact(simulation, near[n])
    }
    contacts.liveCount = nearCount
    let passes = 0
    while (passes < PASSES && correctPositions(simulation)) passes++
    visits -= (passes + 1) * nearCount
    // A row between two walls that come nearer has room only upwards.
    if (passes === PASSES) liftWedged(simulation)
    if (passes === 0) simulation.cramped = 0
  }
}

/** Makes room without a step: no time passes, and nothing else moves. */
export function makeRoomAtOnce(simulation: Simulation): void {
  const { state, before, count } = simulation.bodies
  simulation.revision++
  const shift = (sign: number) => {
    for (let i = FIRST_CHIP; i < count; i++)
      for (let axis = 0; axis < 3; axis++) before[i * 3 + axis] += sign * state[i * STATE + axis]
  }
  // What is drawn lies between two poses: both move by as much.
  shift(-1)
  makeRoom(simulation)
  keepInside(simulation)
  shift(1)
}

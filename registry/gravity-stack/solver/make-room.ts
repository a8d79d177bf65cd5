import { updatePairs } from './broad-phase'
import { CORRECTIONS, ROOM_VISITS, SPECULATIVE_DISTANCE } from './constants'
import { updateContact } from './contact'
import { LEAD, manifold, WIDEST } from './manifold'
import { correctPositions, keepInside, liftWedged } from './position-correction'
import { gatherContacts } from './sleep'
import { FIRST_CHIP, type Simulation, STATE } from './state'

/** Correction passes per measurement: after more, the measured normals no longer hold. */
const PASSES = CORRECTIONS / 4

/**
 * Separates bodies that overlap since walls moved or chips grew, over several steps if need be. Velocities do
 * not change, so nothing is thrown.
 */
export function makeRoom(simulation: Simulation): void {
  const { contacts } = simulation
  if (simulation.roomSteps > 0) simulation.roomSteps--
  for (let visits = ROOM_VISITS; simulation.roomSteps > 0 && visits > 0; ) {
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
    while (passes < PASSES && correctPositions(simulation, passes)) passes++
    visits -= (passes + 1) * nearCount
    // Chips side by side between two walls that come nearer have room only above them.
    if (passes === PASSES) liftWedged(simulation)
    if (passes === 0) simulation.roomSteps = 0
  }
}

/** Makes room without a step: no time passes, and bodies that overlap nothing stay in place. */
export function makeRoomAtOnce(simulation: Simulation): void {
  const { state, before, count } = simulation.bodies
  simulation.revision++
  const shift = (sign: number) => {
    for (let i = FIRST_CHIP; i < count; i++)
      for (let axis = 0; axis < 3; axis++) before[i * 3 + axis] += sign * state[i * STATE + axis]
  }
  // A body is drawn between its last two poses, so both are shifted by the same displacement.
  shift(-1)
  makeRoom(simulation)
  keepInside(simulation)
  shift(1)
}

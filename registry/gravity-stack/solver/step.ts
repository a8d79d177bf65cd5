import { updatePairs } from './broad-phase'
import { BALANCED_HEIGHT, ITERATIONS, SPECULATIVE_DISTANCE, UNEVEN_VISITS } from './constants'
import { addWarmStart, normalImpulse } from './contact'
import { iterate } from './contact-solver'
import { integratePositions, integrateVelocities, trackTravel } from './integrate'
import { makeRoom } from './make-room'
import { addJointWarmStart, prepareJoint, solveJoint } from './mouse-joint'
import { correctOverlaps, keepInside } from './position-correction'
import { prepareContacts, updateContacts } from './prepare'
import { chooseRegime } from './regime'
import { solveImpacts } from './restitution'
import { anyAsleep, gatherContacts, updateSleep } from './sleep'
import {
  ANGLE,
  ARM_LAG,
  ARM_TA,
  CONTACT,
  CORE,
  ITERATIONS_TAKEN,
  MOTION,
  NORMAL_IMPULSE,
  RADIUS,
  SECOND,
  SHAPE,
  type Simulation,
  STATE,
  SUBSTEPS_TAKEN,
  WARM_SPIN,
  WARM_X,
  X,
} from './state'

/**
 * One step of all that is awake. What runs in a step is outside of the world that calls it: functions made
 * anew for every world would be compiled anew as well.
 */
export function step(simulation: Simulation): void {
  const { substeps } = simulation
  rememberPoses(simulation)
  makeRoom(simulation)
  updatePairs(simulation)
  gatherContacts(simulation)
  chooseRegime(simulation)
  collectWarmStart(simulation)
  for (let n = 0; n < substeps; n++) {
    // A body struck in the last sub-step may have left its box, or be about to hit a sleeper.
    if (n > 0 && (updatePairs(simulation) || anyAsleep(simulation))) gatherContacts(simulation)
    if (substep(simulation)) break
  }
  correctOverlaps(simulation)
  keepInside(simulation)
  if (simulation.sleeps) updateSleep(simulation)
}

/** One sub-step; returns whether all is in balance, so that the others of the step would only repeat it. */
function substep(simulation: Simulation): boolean {
  const { joints, regime, work } = simulation
  trackTravel(simulation)
  updateContacts(simulation)
  solveImpacts(simulation)
  prepareContacts(simulation)
  for (const joint of joints) prepareJoint(simulation, joint)
  integrateVelocities(simulation)
  const converged = solveContacts(simulation)
  work[SUBSTEPS_TAKEN]++
  return integratePositions(simulation) && (converged || regime.resting) && joints.length === 0
}

/** Iterates until no contact changes a velocity, or as often as it may; returns whether it converged. */
function solveContacts(simulation: Simulation): boolean {
  const { bodies, contacts, joints, regime, work } = simulation
  const count = contacts.liveCount
  const most = Math.max(ITERATIONS, Math.min(regime.massRatio, UNEVEN_VISITS / count))
  for (let n = 0; n < most; n++) {
    const turn = n * count
    for (const joint of joints) {
      solveJoint(simulation, joint)
      bodies.changed[joint.body] = turn
    }
    work[ITERATIONS_TAKEN]++
    if (iterate(simulation, regime, count, turn) === turn) return true
  }
  return false
}

/** Keeps where everything was, for drawing between steps. */
function rememberPoses({ bodies }: Simulation): void {
  const { state, before, awake, awakeCount, knocked } = bodies
  knocked.fill(1)
  for (let n = 0; n < awakeCount; n++)
    for (let axis = X; axis <= ANGLE; axis++) before[awake[n] * 3 + axis] = state[awake[n] * STATE + axis]
}

/**
 * Sums up the impulses of the last step by body, as what each may expect in a sub-step, and notes how it is
 * supported.
 */
function collectWarmStart(simulation: Simulation): void {
  const { bodies, contacts, joints } = simulation
  const { data: d, near, nearCount, pair, points } = contacts
  const { shape, supported } = bodies
  supported.fill(0)
  for (let n = 0; n < bodies.awakeCount; n++) {
    const m = bodies.awake[n] * MOTION
    bodies.motion.fill(0, m + WARM_X, m + WARM_SPIN + 1)
  }
  for (let n = 0; n < nearCount; n++) {
    const c = near[n]
    const k = c * CONTACT
    if (points[c] === 0) continue
    d[k + ARM_LAG] = 0
    if (normalImpulse(contacts, c) === 0) continue
    addWarmStart(simulation, c, 1)
    for (let side = 0; side < 2; side++) {
      const i = pair[2 * c + side]
      const s = i * SHAPE
      const high = shape[s + RADIUS] + BALANCED_HEIGHT * shape[s + CORE] + SPECULATIVE_DISTANCE
      // A body that is nearly round has no end to stand on.
      const round = shape[s + CORE] < (1 - BALANCED_HEIGHT) * shape[s + RADIUS]
      const both = d[k + NORMAL_IMPULSE] * d[k + SECOND + NORMAL_IMPULSE] > 0
      if (both || round || Math.abs(d[k + ARM_TA + side]) <= high) supported[i] = 1
    }
  }
  for (const joint of joints) addJointWarmStart(bodies, joint)
}

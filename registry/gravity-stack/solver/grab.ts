import { isObstacleBody } from './body'
import { checkContacts } from './contact'
import { updateEntry } from './entry'
import { FAR, type Grab, within } from './input'
import { createJoint, movePointer, throwBody } from './mouse-joint'
import { disturb } from './sleep'
import { type Simulation, STATE, X, Y } from './state'

/** Takes hold of body `i` at the point (x, y) of the stage, px; of one that is gone nothing comes. */
export function grab(simulation: Simulation, i: number, x: number, y: number): Grab {
  const { bodies, contacts, joints } = simulation
  const s = i * STATE
  const joint = createJoint(
    bodies,
    i,
    within(x, -FAR, FAR, bodies.state[s + X]),
    within(y, -FAR, FAR, bodies.state[s + Y]),
  )
  if (bodies.alive[i] && !isObstacleBody(bodies, i)) {
    disturb(simulation, i)
    bodies.held[i]++
    // A chip that is grabbed while it enters the stage is static no longer.
    updateEntry(simulation, i)
    joints.push(joint)
  }
  return {
    moveTo(toX, toY, seconds) {
      const when = within(seconds, -1e12, 1e12, 0)
      movePointer(joint, within(toX, -FAR, FAR, joint.x), within(toY, -FAR, FAR, joint.y), when)
    },
    release() {
      const n = joints.indexOf(joint)
      if (n < 0) return
      simulation.revision++
      joints.splice(n, 1)
      bodies.held[i]--
      throwBody(simulation, joint)
      checkContacts(contacts, i)
    },
  }
}

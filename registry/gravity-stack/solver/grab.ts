import { checkContacts } from './contact'
import { updateEntry } from './entry'
import { FAR, type Grab, within } from './input'
import { createJoint, movePointer, throwBody } from './mouse-joint'
import { disturb } from './sleep'
import type { Simulation } from './state'

/** Takes hold of body `i` at the point (x, y) of the stage, px. */
export function grab(simulation: Simulation, i: number, x: number, y: number): Grab {
  const { bodies, contacts, joints } = simulation
  const joint = createJoint(bodies, i, x, y)
  disturb(simulation, i)
  bodies.held[i]++
  // A chip that is grabbed while it enters the stage is static no longer.
  updateEntry(simulation, i)
  joints.push(joint)
  return {
    moveTo(toX, toY, seconds) {
      // In a stage that has just been hidden the place of a pointer is no finite number.
      movePointer(joint, within(toX, -FAR, FAR, joint.x), within(toY, -FAR, FAR, joint.y), seconds)
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

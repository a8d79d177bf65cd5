import { extents, halfExtents, isStatic, setShape } from './body'
import { ENTRY_SPEED } from './constants'
import { removeContact, resetContact } from './contact'
import { HX, HY, RADIUS, SHAPE, type Simulation, STATE, VX, X, Y } from './state'

/**
 * Notes whether body `i` is in the stage: the ceiling acts only on bodies that are. Chips come in from above.
 * Where gravity pulls aside or up, a chip comes in as a kinematic body, without inverse mass, at
 * `ENTRY_SPEED`, until it is in the stage or in a hand. It shoves aside what lies in the way.
 */
export function updateEntry({ bodies, ceiling, contacts, gravity, height }: Simulation, i: number): void {
  const { box, density, held, inside, shape, state } = bodies
  const s = i * STATE
  halfExtents(bodies, i, 0, 0)
  // What is higher than the stage is in when it stands on the floor.
  inside[i] = state[s + Y] < Math.min(extents[Y], height - extents[Y] - 1) ? 0 : 1
  const drawn = inside[i] + held[i] === 0 && gravity[Y] < Math.abs(gravity[X])
  if (drawn) {
    // Body B of a contact is never static.
    while (!isStatic(bodies, i) && contacts.head[i] >= 0) removeContact(contacts, contacts.head[i] >> 1)
    state.set([0, ENTRY_SPEED, 0, 0, 0], s + VX)
  } else if (isStatic(bodies, i)) {
    const k = i * SHAPE
    const radius = shape[k + RADIUS]
    setShape(bodies, i, 2 * (shape[k + HX] + radius), 2 * (shape[k + HY] + radius), radius, density[i])
    for (let edge = contacts.head[i]; edge >= 0; edge = contacts.next[edge]) resetContact(contacts, edge >> 1)
  }
  // Its contact with the ceiling begins.
  if (ceiling && inside[i]) box[i * 4] = Infinity
}

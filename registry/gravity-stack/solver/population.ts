import { capSpeed, extents, halfExtents, isObstacleBody, setPose, setShape } from './body'
import { overlap } from './broad-phase'
import { MAX_SPEED, REST_TIME, STEP } from './constants'
import { removeContact, resetContacts } from './contact'
import { updateEntry } from './entry'
import { type BodyOptions, type Motion, sizeOf } from './input'
import { grow } from './math'
import { disturb, wake, wakeAlone } from './sleep'
import { ANGLE, FIRST_CHIP, INV_MASS, type Simulation, SPIN, STATE, VX, VY, X, Y } from './state'

/** Adds a body and returns its id. */
export function addBody(simulation: Simulation, body: BodyOptions): number {
  const { bodies, contacts, freeSlots } = simulation
  const { width, height, radius, density = 1 } = body
  const i = freeSlots.pop() ?? bodies.count++
  if (bodies.alive.length < bodies.count) grow(bodies)
  // `head` has an entry a body. `addContact` grows the rest when contacts need it.
  while (contacts.head.length < bodies.count) grow(contacts)
  bodies.density[i] = density
  setShape(bodies, i, sizeOf(width), sizeOf(height), radius, density)
  bodies.state.fill(0, i * STATE, i * STATE + INV_MASS)
  setMotion(simulation, i, body)
  bodies.alive[i] = bodies.inside[i] = 1
  bodies.held[i] = bodies.asleep[i] = 0
  contacts.head[i] = -1
  bodies.order[bodies.orderCount++] = i
  if (!isObstacleBody(bodies, i)) wakeAlone(bodies, i)
  refreshBody(simulation, i)
  return i
}

/** Takes body `i` out; what leaned on it wakes. */
export function removeBody(simulation: Simulation, i: number): void {
  const { bodies, contacts, joints } = simulation
  disturb(simulation, i)
  for (let n = joints.length - 1; n >= 0; n--) if (joints[n]!.body === i) joints.splice(n, 1)
  while (contacts.head[i] >= 0) removeContact(contacts, contacts.head[i] >> 1)
  bodies.orderCount = without(bodies.order, i, bodies.orderCount)
  bodies.awakeCount = without(bodies.awake, i, bodies.awakeCount)
  bodies.alive[i] = bodies.needsDrawing[i] = 0
  simulation.freeSlots.push(i)
}

/** Moves body `i` to where and as fast as is given; what leaned on it wakes. */
export function placeBody(simulation: Simulation, i: number, motion: Motion): void {
  disturb(simulation, i)
  setMotion(simulation, i, motion)
  refreshBody(simulation, i)
}

/** Gives body `i` a new size (px) in place; what it touches wakes. */
export function reshapeBody(simulation: Simulation, i: number, shape: Shape): void {
  const { bodies } = simulation
  disturb(simulation, i)
  setShape(bodies, i, sizeOf(shape.width), sizeOf(shape.height), shape.radius, bodies.density[i])
  refreshBody(simulation, i)
  simulation.roomSteps = REST_TIME / STEP
}

export type Shape = Pick<BodyOptions, 'width' | 'height' | 'radius'>

/** Sets pose and velocity of body `i`; what `motion` leaves out stays as it is. */
function setMotion({ bodies }: Simulation, i: number, motion: Motion): void {
  const { state } = bodies
  const s = i * STATE
  const { x = state[s + X], y = state[s + Y], angle = state[s + ANGLE] } = motion
  const { vx = state[s + VX], vy = state[s + VY], spin = state[s + SPIN] } = motion
  setPose(bodies, i, x, y, angle)
  state.set([vx, vy, spin], s + VX)
  capSpeed(state, s, MAX_SPEED)
}

/**
 * Brings up to date what depends on pose and shape of body `i`, which has come, moved or changed its shape.
 * What is near an obstacle wakes, and room is made for the obstacle.
 */
function refreshBody(simulation: Simulation, i: number): void {
  const { bodies, contacts } = simulation
  const { box, leftBox, state } = bodies
  resetContacts(bodies, contacts, i)
  if (!isObstacleBody(bodies, i)) {
    updateEntry(simulation, i)
    return
  }
  halfExtents(bodies, i, 0, 0)
  for (let side = 0; side < 4; side++)
    box[i * 4 + side] = state[i * STATE + (side % 2)] + (side > 1 ? 1 : -1) * extents[side % 2]
  leftBox[i] = 1
  for (let j = FIRST_CHIP; j < bodies.count; j++) if (overlap(box, i * 4, j * 4)) wake(simulation, j)
  simulation.revision++
  simulation.roomSteps = REST_TIME / STEP
}

/** Takes `i` out of the first `count` of a list; returns how many are left. */
function without(list: Int32Array, i: number, count: number): number {
  const at = list.indexOf(i)
  if (at < 0) return count
  list.copyWithin(at, at + 1, count)
  return count - 1
}

import { setPose, setShape } from './body'
import { resetContacts } from './contact'
import { updateEntry } from './entry'
import { FAR, type Vector, type WorldOptions, within } from './input'
import { wake } from './sleep'
import {
  CEILING,
  CONTACT,
  FIRST_CHIP,
  NORMAL_IMPULSE,
  PUSHER,
  SECOND,
  type Simulation,
  TANGENT_IMPULSE,
  X,
  Y,
} from './state'

/** px, how thick walls are. */
const THICK = 1000

/** Adds floor, walls and ceiling to a new world. */
export function addWalls({ bodies }: Simulation): void {
  for (let i = 0; i < PUSHER; i++) {
    bodies.order[bodies.orderCount++] = i
    const upright = i % CEILING > 0
    setShape(bodies, i, upright ? THICK : FAR, upright ? FAR : THICK, 0, Infinity)
  }
}

/** Puts floor and walls where a stage of this size (px) has them. */
export function enclose(simulation: Simulation, width: number, height: number): void {
  const { bodies, contacts } = simulation
  simulation.width = width
  simulation.height = height
  const far = FAR / 2
  const thick = THICK / 2
  setPose(bodies, 0, width / 2, height + thick, 0)
  setPose(bodies, 1, -thick, 0, 0)
  setPose(bodies, 2, width + thick, 0, 0)
  setPose(bodies, CEILING, width / 2, -thick, 0)
  bodies.box.set([-far, height, far, far, -far, -far, 0, far, width, -far, far, far, 0, -far, far, 0])
  setCeiling(simulation, simulation.ceiling)
  for (let i = FIRST_CHIP; i < bodies.count; i++) resetContacts(bodies, contacts, i)
}

/** Closes or opens the top. An open ceiling is where nothing comes near it. */
function setCeiling(simulation: Simulation, closed: boolean): void {
  simulation.ceiling = closed
  simulation.bodies.box[CEILING * 4] = closed ? -FAR : Infinity
}

/** Sets gravity, px/s²: downwards, or to the right and downwards. A part that is left out stays as it is. */
function setGravity(simulation: Simulation, given: number | Vector | undefined): void {
  const { gravity } = simulation
  const [x, y] = typeof given === 'number' ? [0, given] : [given?.x, given?.y]
  gravity[X] = within(x, -1e5, 1e5, gravity[X])
  gravity[Y] = within(y, -1e5, 1e5, gravity[Y])
  simulation.pull = Math.sqrt(gravity[X] * gravity[X] + gravity[Y] * gravity[Y])
}

/** What of a world may be changed while it lives. */
export type Change = Omit<WorldOptions, 'width' | 'height'>

/** Changes gravity, ceiling, bounce or friction; wakes everything. */
export function configure(simulation: Simulation, change: Change): void {
  const { bodies, contacts, gravity, pull } = simulation
  const [oldX, oldY] = gravity
  setGravity(simulation, change.gravity)
  simulation.friction = within(change.friction, 0, 100, simulation.friction)
  // Impulses scale with the new weight at once, or a resting pile would hop.
  const share = within((gravity[X] * oldX! + gravity[Y] * oldY!) / (pull * pull), 0, 1000, 1)
  for (let k = 0; k < contacts.count * CONTACT; k += CONTACT) {
    contacts.data[k + NORMAL_IMPULSE] *= share
    contacts.data[k + SECOND + NORMAL_IMPULSE] *= share
    contacts.data[k + TANGENT_IMPULSE] *= simulation.friction > 0 ? share : 0
  }
  simulation.revision++
  simulation.bounce = within(change.bounce, 0, 1, simulation.bounce)
  setCeiling(simulation, change.ceiling ?? simulation.ceiling)
  wakeAll(simulation)
  for (let n = 0; n < bodies.awakeCount; n++) updateEntry(simulation, bodies.awake[n])
}

/** Wakes every chip. */
export function wakeAll(simulation: Simulation): void {
  for (let i = FIRST_CHIP; i < simulation.bodies.count; i++) {
    wake(simulation, i)
  }
}

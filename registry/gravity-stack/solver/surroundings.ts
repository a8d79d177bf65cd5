import { setPose, setShape } from './body'
import { resetContacts } from './contact'
import { updateEntry } from './entry'
import { FAR, type Vector, within } from './input'
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

/** Adds floor, walls and an open ceiling to a new world. The box of an open ceiling is at infinity. */
export function addWalls({ bodies }: Simulation): void {
  for (let i = 0; i < PUSHER; i++) {
    bodies.order[bodies.orderCount++] = i
    const upright = i % CEILING > 0
    setShape(bodies, i, upright ? THICK : FAR, upright ? FAR : THICK, 0, Infinity)
  }
  bodies.box.set([Infinity, -FAR, FAR, 0], CEILING * 4)
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
  bodies.box.set([-far, height, far, far, -far, -far, 0, far, width, -far, far, far])
  for (let i = FIRST_CHIP; i < bodies.count; i++) resetContacts(bodies, contacts, i)
}

/** What of a world may be changed while it lives. */
export interface Surroundings {
  /** px/s², to the right and downwards. */
  gravity: Vector
  /** Whether there is a ceiling at y = 0 as well, for what has once been wholly below it. */
  ceiling: boolean
  /** Restitution, 0..1. */
  bounce: number
  /** Coulomb coefficient, 0 or more. */
  friction: number
}

/** Sets gravity, ceiling, bounce and friction; wakes everything. */
export function configure(
  simulation: Simulation,
  { gravity: { x, y }, ceiling, bounce, friction }: Surroundings,
): void {
  const { bodies, contacts, gravity, pull } = simulation
  // Impulses scale with the new weight at once, or a resting pile would hop.
  const share = within((x * gravity[X] + y * gravity[Y]) / (pull * pull), 0, 1000, 1)
  for (let k = 0; k < contacts.count * CONTACT; k += CONTACT) {
    contacts.data[k + NORMAL_IMPULSE] *= share
    contacts.data[k + SECOND + NORMAL_IMPULSE] *= share
    contacts.data[k + TANGENT_IMPULSE] *= friction > 0 ? share : 0
  }
  gravity.set([x, y])
  simulation.pull = Math.sqrt(x * x + y * y)
  simulation.friction = friction
  simulation.bounce = bounce
  simulation.revision++
  simulation.ceiling = ceiling
  bodies.box[CEILING * 4] = ceiling ? -FAR : Infinity
  wakeAll(simulation)
  for (let n = 0; n < bodies.awakeCount; n++) updateEntry(simulation, bodies.awake[n])
}

/** Wakes every chip. */
export function wakeAll(simulation: Simulation): void {
  for (let i = FIRST_CHIP; i < simulation.bodies.count; i++) {
    wake(simulation, i)
  }
}

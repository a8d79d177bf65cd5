import {
  CONTACTS_VISITED,
  FIRST_CHIP,
  IMPACTS_SOLVED,
  INV_INERTIA,
  INV_MASS,
  ITERATIONS_TAKEN,
  MANIFOLDS_MADE,
  STATE,
  SUBSTEPS_TAKEN,
} from './solver/state'
import { createWorld as createBareWorld, type WorldOptions } from './solver/world'

export type { BodyOptions, Grab, Motion, Reading, WorldOptions } from './solver/world'

export type World = ReturnType<typeof createWorld>

/**
 * A world as the stage has it, and what only tests and tools ask of one: it stays out of the file that people
 * copy.
 */
export function createWorld(options: WorldOptions) {
  const world = createBareWorld(options)
  const { bodies, contacts, work } = world.scene
  const { step } = world
  let acted = false

  const tools = {
    step(seconds: number): void {
      work.fill(0)
      acted = bodies.awakeCount > 0
      step(seconds)
    },

    /** What the world did in the last call of its `step`; `awake` is of its last step. */
    get stats() {
      let pairs = 0
      let touching = 0
      let points = 0
      for (let c = 0; c < contacts.count; c++) {
        if (contacts.pair[2 * c + 1] === 0) continue
        pairs++
        const here = contacts.points[c]
        if (here > 0) touching++
        points += here
      }
      return {
        awake: acted ? bodies.awakeCount : 0,
        substeps: work[SUBSTEPS_TAKEN],
        sweeps: work[ITERATIONS_TAKEN],
        pairs,
        /** Pairs measured. */
        narrow: work[MANIFOLDS_MADE],
        contacts: touching,
        points,
        /** Impacts solved. */
        hits: work[IMPACTS_SOLVED],
        /** Visits of contacts by the iterations over velocities. */
        rows: work[CONTACTS_VISITED],
      }
    },

    /** Mass and moment of inertia of body `id`, in units of density·px² and density·px⁴. */
    mass(id: number): { mass: number; inertia: number } {
      return {
        mass: 1 / bodies.state[id * STATE + INV_MASS],
        inertia: 1 / bodies.state[id * STATE + INV_INERTIA],
      }
    },

    /** Digest of every pose and velocity, bit for bit (FNV-1a). */
    hash(): string {
      let hash = 0x811c9dc5
      for (let i = FIRST_CHIP; i < bodies.count; i++) {
        if (bodies.alive[i] === 0) continue
        const words = new Uint32Array(bodies.state.slice(i * STATE, i * STATE + 6).buffer)
        for (const word of words) hash = Math.imul(hash ^ word, 0x01000193)
      }
      return (hash >>> 0).toString(16).padStart(8, '0')
    },
  }
  return Object.defineProperties(world, Object.getOwnPropertyDescriptors(tools)) as typeof world &
    typeof tools
}

import { ANGULAR_DAMPING, BOUNCE_THRESHOLD, LINEAR_DAMPING, STEP, SUBSTEPS } from './solver/constants'
import { type WorldOptions as StageOptions, within } from './solver/input'
import { dampingOver } from './solver/math'
import {
  ARM_NB,
  ARM_TB,
  CONTACT,
  CONTACTS_VISITED,
  FIRST_CHIP,
  IMPACTS_SOLVED,
  INV_INERTIA,
  INV_MASS,
  ITERATIONS_TAKEN,
  MANIFOLDS_MADE,
  NORMAL_IMPULSE,
  NORMAL_X,
  NORMAL_Y,
  SECOND,
  STATE,
  SUBSTEPS_TAKEN,
  TANGENT_IMPULSE,
  X,
  Y,
} from './solver/state'
import { createWorld as createBareWorld } from './solver/world'

export type { BodyOptions, Grab, Motion, Reading } from './solver/input'

export type World = ReturnType<typeof createWorld>

export interface WorldOptions extends StageOptions {
  /** 1/s, drag of the air on velocity and on spin. */
  linearDamping?: number
  angularDamping?: number
  /** px/s of approach below which nothing bounces. */
  bounceThreshold?: number
  /** `false` keeps every body awake, for measuring. */
  sleep?: boolean
  /** Most sub-steps of a step of 1/60 s, 1..64; a world that rests takes one. 6 if left out. */
  substeps?: number
}

/** The largest damping (1/s) for which `dampingOver` is exact at a whole step. */
export const MAX_DAMPING = 0.5 / STEP

/** A pair of bodies that touch, by their ids. */
export interface Contact {
  a: number
  b: number
  /** px, where they touch, and density · px³/s², the mean force on `b` over the last step. */
  points: { x: number; y: number; forceX: number; forceY: number }[]
}

/**
 * A world as the stage has it, and what only tests and tools ask of one: it stays out of the file that people
 * copy.
 */
export function createWorld(options: WorldOptions) {
  const world = createBareWorld(options)
  const { scene } = world
  const { bodies, contacts, work } = scene
  scene.substeps = Math.round(within(options.substeps, 1, 64, SUBSTEPS))
  scene.h = STEP / scene.substeps
  scene.air = dampingOver(within(options.linearDamping, 0, MAX_DAMPING, LINEAR_DAMPING), scene.h)
  scene.spinAir = dampingOver(within(options.angularDamping, 0, MAX_DAMPING, ANGULAR_DAMPING), scene.h)
  scene.threshold = within(options.bounceThreshold, 0, 1e6, BOUNCE_THRESHOLD)
  scene.sleeps = options.sleep !== false
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

    /** The ids of all bodies that can move. */
    get ids(): number[] {
      const ids: number[] = []
      for (let id = FIRST_CHIP; id < bodies.count; id++)
        if (bodies.alive[id] && bodies.density[id] < Infinity) ids.push(id)
      return ids
    },

    /** All contacts as the last step has left them. Floor, walls and obstacles are bodies too. */
    contacts(): Contact[] {
      const { data, pair, points } = contacts
      const found: Contact[] = []
      for (let c = 0; c < contacts.count; c++) {
        const [a, b] = [pair[2 * c], pair[2 * c + 1]]
        if (b === 0 || points[c] === 0) continue
        const k = c * CONTACT
        const [nx, ny] = [data[k + NORMAL_X], data[k + NORMAL_Y]]
        const normalImpulse = data[k + NORMAL_IMPULSE] + data[k + NORMAL_IMPULSE + SECOND]
        const at = Array.from({ length: points[c] }, (_, point) => {
          const record = k + point * SECOND
          // From the centre of `b`, the point lies `ARM_TB` along the normal and `ARM_NB` across it.
          const along = data[k + ARM_TB]
          const across = data[record + ARM_NB]
          const normal = data[record + NORMAL_IMPULSE] / world.scene.h
          // Friction acts on both points together, and more where they are pressed more.
          const tangent = normalImpulse > 0 ? (data[k + TANGENT_IMPULSE] * normal) / normalImpulse : 0
          return {
            x: bodies.state[b * STATE + X] + along * nx + across * ny,
            y: bodies.state[b * STATE + Y] + along * ny - across * nx,
            forceX: nx * normal - ny * tangent,
            forceY: ny * normal + nx * tangent,
          }
        })
        found.push({ a, b, points: at })
      }
      return found
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

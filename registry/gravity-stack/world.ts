import { isObstacleBody } from './solver/body'
import {
  ANGULAR_DAMPING,
  BOUNCE,
  BOUNCE_THRESHOLD,
  FRICTION,
  GRAVITY,
  LINEAR_DAMPING,
  STEP,
  SUBSTEPS,
} from './solver/constants'
import {
  type BodyOptions as CompleteOptions,
  FAR,
  type Grab,
  type Motion,
  sizeOf,
  type Vector,
  within,
} from './solver/input'
import { dampingOver } from './solver/math'
import {
  ANGLE,
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
  SPIN,
  STATE,
  SUBSTEPS_TAKEN,
  TANGENT_IMPULSE,
  VX,
  VY,
  X,
  Y,
} from './solver/state'
import type { Surroundings } from './solver/surroundings'
import { createWorld as createBareWorld } from './solver/world'

export type { Grab, Motion } from './solver/input'

export interface BodyOptions extends Omit<CompleteOptions, 'radius'> {
  /** px, corner radius; 0 if left out. */
  radius?: number
}

export type World = ReturnType<typeof createWorld>

/** What of a world may be changed while it lives: a part that is left out, or makes no sense, stays. */
export interface Change extends Partial<Omit<Surroundings, 'gravity'>> {
  /** px/s² downwards, or to the right and downwards. */
  gravity?: number | Partial<Vector> | undefined
}

export interface WorldOptions extends Change {
  /** px, size of the stage: floor at y = height, walls at x = 0 and x = width. */
  width: number
  height: number
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

/** Pose and velocity of a body: px, radians, px/s, rad/s. */
export interface Reading {
  x: number
  y: number
  angle: number
  vx: number
  vy: number
  spin: number
  asleep: boolean
}

/** A pair of bodies that touch, by their ids. */
export interface Contact {
  a: number
  b: number
  /** px, where they touch, and density · px³/s², the mean force on `b` over the last step. */
  points: { x: number; y: number; forceX: number; forceY: number }[]
}

const finite = (value: unknown, otherwise: number) =>
  within(value, -Number.MAX_VALUE, Number.MAX_VALUE, otherwise)

/** Pose and velocity as `motion` gives them; the rest stays at what it is `now`. */
const checkedMotion = (motion: Motion, now: Omit<Reading, 'asleep'>) => ({
  x: within(motion.x, -FAR, FAR, now.x),
  y: within(motion.y, -FAR, FAR, now.y),
  angle: within(motion.angle, -FAR, FAR, now.angle),
  vx: finite(motion.vx, now.vx),
  vy: finite(motion.vy, now.vy),
  spin: within(motion.spin, -1000, 1000, now.spin),
})
const atRest = { x: 0, y: 0, angle: 0, vx: 0, vy: 0, spin: 0 }

/**
 * A world as the stage has it, and what only tests and tools ask of one: it stays out of the file that people
 * copy. The stage checks what it is given; here values that are not finite count as left out, sizes as 1 px,
 * and bodies that are gone are left alone.
 */
export function createWorld(options: WorldOptions) {
  const world = createBareWorld({ width: sizeOf(options.width), height: sizeOf(options.height) })
  const { scene } = world
  const { bodies, contacts } = scene
  scene.substeps = Math.round(within(options.substeps, 1, 64, SUBSTEPS))
  scene.h = STEP / scene.substeps
  scene.air = dampingOver(within(options.linearDamping, 0, MAX_DAMPING, LINEAR_DAMPING), scene.h)
  scene.spinAir = dampingOver(within(options.angularDamping, 0, MAX_DAMPING, ANGULAR_DAMPING), scene.h)
  scene.threshold = within(options.bounceThreshold, 0, 1e6, BOUNCE_THRESHOLD)
  scene.sleeps = options.sleep !== false
  const { add, configure, grab, place, reshape, resize, step } = world
  let acted = false

  /** Sets what `change` gives, and leaves the rest at what it is `now`. */
  function change({ gravity, ceiling, bounce, friction }: Change, now: Surroundings) {
    const { x, y } = typeof gravity === 'number' ? { x: 0, y: gravity } : (gravity ?? now.gravity)
    configure({
      gravity: { x: within(x, -1e5, 1e5, now.gravity.x), y: within(y, -1e5, 1e5, now.gravity.y) },
      ceiling: ceiling ?? now.ceiling,
      bounce: within(bounce, 0, 1, now.bounce),
      friction: within(friction, 0, 100, now.friction),
    })
  }
  change(options, { gravity: { x: 0, y: GRAVITY }, ceiling: false, bounce: BOUNCE, friction: FRICTION })

  const tools = {
    add({ density, radius, ...body }: BodyOptions): number {
      const dense = density! > 0 ? density : 1
      return add({
        ...body,
        ...checkedMotion(body, atRest),
        radius: finite(radius, 0),
        density: density === Infinity ? Infinity : within(dense, 1e-6, 1e6, 1),
      })
    },

    place(id: number, motion: Motion): void {
      if (bodies.alive[id]) place(id, checkedMotion(motion, tools.read(id)))
    },

    reshape(id: number, shape: Pick<BodyOptions, 'width' | 'height' | 'radius'>): void {
      if (bodies.alive[id]) reshape(id, { ...shape, radius: finite(shape.radius, 0) })
    },

    resize(width: number, height: number): void {
      resize(sizeOf(width), sizeOf(height))
    },

    configure(given: Change): void {
      change(given, { ...scene, gravity: world.gravity })
    },

    /** Pose and velocity of body `id`. */
    read(id: number): Reading {
      const { asleep, state } = bodies
      const s = id * STATE
      return {
        x: state[s + X],
        y: state[s + Y],
        angle: state[s + ANGLE],
        vx: state[s + VX],
        vy: state[s + VY],
        spin: state[s + SPIN],
        asleep: asleep[id] > 0,
      }
    },

    /** Grabbing a body that is gone, or an obstacle, does nothing. */
    grab(id: number, x: number, y: number): Grab {
      if (!bodies.alive[id] || isObstacleBody(bodies, id)) return { moveTo() {}, release() {} }
      const at = tools.read(id)
      const { moveTo, release } = grab(id, within(x, -FAR, FAR, at.x), within(y, -FAR, FAR, at.y))
      return { moveTo: (toX, toY, seconds) => moveTo(toX, toY, within(seconds, -1e12, 1e12, 0)), release }
    },

    step(seconds: number): void {
      scene.work.fill(0)
      acted = bodies.awakeCount > 0
      step(seconds)
    },

    /**
     * What the world did in the last call of its `step`; `awake` is of its last step, and pairs, contacts and
     * points are those that it left. The keys stay: `bench/accuracy/bounds.json` is kept by them, and
     * `npm run accept` reads them from older solvers.
     */
    get stats() {
      const { work } = scene
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
        /** Bodies awake. */
        awake: acted ? bodies.awakeCount : 0,
        substeps: work[SUBSTEPS_TAKEN],
        /** Iterations of the contact solver. */
        sweeps: work[ITERATIONS_TAKEN],
        /** Pairs that the broad phase keeps, which may touch. */
        pairs,
        /** Manifolds made: pairs measured by the narrow phase. */
        narrow: work[MANIFOLDS_MADE],
        /** Pairs that touch, and points in which they do. */
        contacts: touching,
        points,
        /** Impacts solved. */
        hits: work[IMPACTS_SOLVED],
        /** Visits of contacts by the iterations, those over impacts included. */
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
  return Object.defineProperties(world, Object.getOwnPropertyDescriptors(tools)) as Omit<
    typeof world,
    keyof typeof tools
  > &
    typeof tools
}

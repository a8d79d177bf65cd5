import { capSpeed, extents, halfExtents, setPose, setShape } from './body'
import { overlap } from './broad-phase'
import {
  ANGULAR_DAMPING,
  BOUNCE,
  BOUNCE_THRESHOLD,
  FRICTION,
  GRAVITY,
  LINEAR_DAMPING,
  MAX_SPEED,
  STEP,
  SUBSTEPS,
  WEDGED_STEPS,
} from './constants'
import { removeContact, resetContact } from './contact'
import { updateEntry } from './entry'
import { makeRoom } from './make-room'
import { dampingOver, grow, MAX_DAMPING } from './math'
import { createJoint, movePointer, throwBody } from './mouse-joint'
import { keepInside } from './position-correction'
import { pushBodies } from './push'
import { wake, wakeAlone, wakeTouching } from './sleep'
import {
  ANGLE,
  CEILING,
  CONTACT,
  FIRST_CHIP,
  INV_MASS,
  NORMAL_IMPULSE,
  PUSHER,
  SECOND,
  Simulation,
  SPIN,
  STATE,
  TANGENT_IMPULSE,
  VX,
  VY,
  X,
  Y,
} from './state'
import { step } from './step'

export interface Vector {
  x: number
  y: number
}

export interface WorldOptions {
  /** px, size of the stage: floor at y = height, walls at x = 0 and x = width. */
  width: number
  height: number
  /** px/s² downwards, or to the right and downwards. */
  gravity?: number | Vector | undefined
  /** Whether there is a ceiling at y = 0 as well, for what has once been wholly below it. */
  ceiling?: boolean | undefined
  /** Restitution, 0..1. */
  bounce?: number
  /** Coulomb coefficient, 0 or more. */
  friction?: number
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

export interface BodyOptions {
  /** px, outer size and corner radius. */
  width: number
  height: number
  radius?: number
  /** px, centre; radians clockwise on screen. */
  x: number
  y: number
  angle?: number
  /** px/s and rad/s. */
  vx?: number
  vy?: number
  spin?: number
  /** Mass a px². */
  density?: number
}

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

export type Motion = Partial<Pick<BodyOptions, 'x' | 'y' | 'angle' | 'vx' | 'vy' | 'spin'>>

export interface Grab {
  /** Where the pointer is, px, and when it was there, s on any clock. */
  moveTo(x: number, y: number, seconds: number): void
  /**
   * Lets go: the body leaves with the pointer's velocity if it kept up with one that moved just now, else, or
   * if that is slow, with its own; at most `MAX_TOSS`. A body that another grab still holds is not thrown.
   */
  release(): void
}

export type World = ReturnType<typeof createWorld>

/**
 * A world of rounded boxes in a stage. Same calls, same bits, in every JavaScript engine.
 * Values that are not finite count as left out (sizes as 1 px), so that nothing is ever lost.
 */
export function createWorld(options: WorldOptions) {
  const substeps = Math.round(within(options.substeps, 1, 64, SUBSTEPS))
  const scene = new Simulation()
  const { bodies, contacts, impactRegime, joints } = scene
  scene.substeps = substeps
  scene.left = 0
  scene.h = STEP / substeps
  scene.air = dampingOver(within(options.linearDamping, 0, MAX_DAMPING, LINEAR_DAMPING), scene.h)
  scene.spinAir = dampingOver(within(options.angularDamping, 0, MAX_DAMPING, ANGULAR_DAMPING), scene.h)
  impactRegime.relaxation = 1
  scene.gravity[Y] = GRAVITY
  setGravity(options.gravity)
  scene.bounce = within(options.bounce, 0, 1, BOUNCE)
  scene.friction = within(options.friction, 0, 100, FRICTION)
  scene.threshold = within(options.bounceThreshold, 0, 1e6, BOUNCE_THRESHOLD)
  scene.sleeps = options.sleep !== false
  // Floor and walls.
  for (let i = 0; i < PUSHER; i++) {
    bodies.order[bodies.orderCount++] = i
    const upright = i % CEILING > 0
    setShape(bodies, i, upright ? THICK : FAR, upright ? FAR : THICK, 0, Infinity)
  }
  scene.ceiling = options.ceiling === true
  enclose(size(options.width), size(options.height))

  return {
    /**
     * Adds a body and returns its id. Infinite density makes an obstacle: static, and what is in it moves
     * aside.
     */
    add(body: BodyOptions): number {
      const { density } = body
      const i = scene.freeSlots.pop() ?? bodies.count++
      if (bodies.alive.length < bodies.count) grow(bodies)
      // Lists of contacts are by body, contacts by need.
      while (contacts.head.length < bodies.count) grow(contacts)
      const obstacle = density === Infinity
      bodies.density[i] = obstacle ? Infinity : within(density! > 0 ? density : 1, 1e-6, 1e6, 1)
      setShape(bodies, i, size(body.width), size(body.height), finite(body.radius), bodies.density[i])
      bodies.state.fill(0, i * STATE, i * STATE + INV_MASS)
      put(i, body)
      bodies.alive[i] = bodies.inside[i] = 1
      bodies.held[i] = bodies.asleep[i] = 0
      contacts.head[i] = -1
      bodies.order[bodies.orderCount++] = i
      if (obstacle) bodies.staticCount++
      else wakeAlone(bodies, i)
      changed(i)
      return i
    },

    /** Takes body `id` out; what leaned on it wakes. */
    remove(id: number): void {
      if (!bodies.alive[id]) return
      scene.revision++
      wakeTouching(scene, id)
      if (isObstacle(id)) bodies.staticCount--
      for (let n = joints.length - 1; n >= 0; n--) if (joints[n]!.body === id) joints.splice(n, 1)
      while (contacts.head[id] >= 0) removeContact(contacts, contacts.head[id] >> 1)
      bodies.orderCount = without(bodies.order, id, bodies.orderCount)
      bodies.awakeCount = without(bodies.awake, id, bodies.awakeCount)
      bodies.alive[id] = 0
      scene.freeSlots.push(id)
    },

    /** Moves body `id` to where and as fast as is given; what leaned on it wakes. */
    place(id: number, motion: Motion): void {
      if (!bodies.alive[id]) return
      scene.revision++
      wakeTouching(scene, id)
      put(id, motion)
      changed(id)
    },

    /** Gives body `id` a new size (px) in place; what it touches wakes. */
    reshape(id: number, shape: { width: number; height: number; radius?: number }): void {
      if (!bodies.alive[id]) return
      scene.revision++
      wakeTouching(scene, id)
      setShape(bodies, id, size(shape.width), size(shape.height), finite(shape.radius), bodies.density[id])
      changed(id)
      scene.cramped = WEDGED_STEPS
    },

    /** Moves floor and right wall; wakes everything. */
    resize(width: number, height: number): void {
      if (size(width) !== scene.width || size(height) !== scene.height) {
        scene.revision++
        enclose(size(width), size(height))
        wakeAll()
        scene.cramped = WEDGED_STEPS
      }
    },

    /**
     * Parts what moved walls or grown chips have pressed together, without a step: no time passes, and
     * nothing else moves.
     */
    makeRoom(): void {
      scene.revision++
      const { state, before } = bodies
      const shift = (sign: number) => {
        for (let i = FIRST_CHIP; i < bodies.count; i++)
          for (let axis = 0; axis < 3; axis++) before[i * 3 + axis] += sign * state[i * STATE + axis]
      }
      // What is drawn lies between two poses: both move by as much.
      shift(-1)
      makeRoom(scene)
      keepInside(scene)
      shift(1)
    },

    /** Changes gravity (px/s²), ceiling, bounce or friction; wakes everything. */
    configure(change: Partial<Pick<WorldOptions, 'gravity' | 'ceiling' | 'bounce' | 'friction'>>): void {
      const { gravity, pull } = scene
      const [oldX, oldY] = gravity
      setGravity(change.gravity)
      scene.friction = within(change.friction, 0, 100, scene.friction)
      // What rests weighs as much more or less at once: else a pile hops.
      const share = within((gravity[X] * oldX! + gravity[Y] * oldY!) / (pull * pull), 0, 1000, 1)
      for (let k = 0; k < contacts.count * CONTACT; k += CONTACT) {
        contacts.data[k + NORMAL_IMPULSE] *= share
        contacts.data[k + SECOND + NORMAL_IMPULSE] *= share
        contacts.data[k + TANGENT_IMPULSE] *= scene.friction > 0 ? share : 0
      }
      scene.revision++
      scene.bounce = within(change.bounce, 0, 1, scene.bounce)
      scene.ceiling = change.ceiling ?? scene.ceiling
      encloseTop()
      wakeAll()
      for (let n = 0; n < bodies.awakeCount; n++) updateEntry(scene, bodies.awake[n])
    },

    /** Pushes what is in the way of a disc that goes from one place to another; see `pushBodies`. */
    push(radius: number, x: number, y: number, goX: number, goY: number, seconds: number): void {
      pushBodies(scene, radius, x, y, goX, goY, seconds)
    },

    /** Lets `seconds` pass in fixed steps, an hour at most; what is left over is simulated next time. */
    step(seconds: number): void {
      scene.left += within(seconds, 0, 3600, 0)
      // A thousandth of a step of grace, so that a step handed in as a rounded number of seconds is not put
      // off.
      while (scene.left >= STEP * 0.999) {
        scene.left -= STEP
        if (bodies.awakeCount > 0) step(scene)
      }
    },

    /** Takes hold of body `id` at the point (x, y) of the stage; of one that is gone nothing comes. */
    grab(id: number, x: number, y: number): Grab {
      const joint = createJoint(
        bodies,
        id,
        within(x, -FAR, FAR, bodies.state[id * STATE + X]),
        within(y, -FAR, FAR, bodies.state[id * STATE + Y]),
      )
      if (bodies.alive[id] && !isObstacle(id)) {
        scene.revision++
        wakeTouching(scene, id)
        bodies.held[id]++
        // What is taken as it comes in has a mass from now on.
        updateEntry(scene, id)
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
          scene.revision++
          joints.splice(n, 1)
          bodies.held[id]--
          throwBody(scene, joint)
          // It has a new velocity and has not moved: what it is flicked into is looked at all the same.
          for (let edge = contacts.head[id]; edge >= 0; edge = contacts.next[edge])
            contacts.due[edge >> 1] = -Infinity
        },
      }
    },

    /**
     * Becomes the same as `other`, bit for bit, without what is held there: equal steps then keep both equal.
     */
    follow(other: { scene: Simulation }): void {
      copy(other.scene, scene)
      bodies.held.fill(0)
    },

    /**
     * Whether `other` still goes the way it went when this world followed it: only time and new bodies came
     * since.
     */
    follows(other: { scene: Simulation }): boolean {
      return scene.revision === other.scene.revision
    },

    /** s, time handed in and not simulated yet. */
    get left(): number {
      return scene.left
    },

    /** Pose and velocity of body `id`. */
    read(id: number): Reading {
      const { state } = bodies
      const s = id * STATE
      return {
        x: state[s + X],
        y: state[s + Y],
        angle: state[s + ANGLE],
        vx: state[s + VX],
        vy: state[s + VY],
        spin: state[s + SPIN],
        asleep: bodies.asleep[id] > 0,
      }
    },

    /** What the world is made of. */
    scene,

    /** Visits every body that has moved since the last call, with the pose to draw: px, px, rad. */
    eachMoved(visit: (id: number, x: number, y: number, angle: number, asleep: boolean) => void): void {
      const share = within(scene.left / STEP, 0, 1, 0)
      const { state, before, undrawn } = bodies
      for (let i = FIRST_CHIP; i < bodies.count; i++) {
        if (undrawn[i] === 0 || bodies.alive[i] === 0) continue
        const asleep = bodies.asleep[i] > 0
        undrawn[i] = asleep ? 0 : 1
        const coordinate = (axis: number) => {
          const now = state[i * STATE + axis]
          const then = before[i * 3 + axis]
          return asleep ? now : then + share * (now - then)
        }
        visit(i, coordinate(X), coordinate(Y), coordinate(ANGLE), asleep)
      }
    },

    /** True when nothing is awake. */
    get resting(): boolean {
      return bodies.awakeCount === 0
    },
  }

  /** Puts body `i` where and as fast as `motion` says; what that leaves out stays as it is. */
  function put(i: number, motion: Motion): void {
    const { state } = bodies
    const s = i * STATE
    setPose(
      bodies,
      i,
      within(motion.x, -FAR, FAR, state[s + X]),
      within(motion.y, -FAR, FAR, state[s + Y]),
      within(motion.angle, -FAR, FAR, state[s + ANGLE]),
    )
    state[s + VX] = finite(motion.vx, state[s + VX])
    state[s + VY] = finite(motion.vy, state[s + VY])
    state[s + SPIN] = within(motion.spin, -1000, 1000, state[s + SPIN])
    capSpeed(state, s, MAX_SPEED)
  }

  /** Puts floor and walls where they belong. */
  function enclose(width: number, height: number): void {
    scene.width = width
    scene.height = height
    const far = FAR / 2
    const thick = THICK / 2
    setPose(bodies, 0, width / 2, height + thick, 0)
    setPose(bodies, 1, -thick, 0, 0)
    setPose(bodies, 2, width + thick, 0, 0)
    setPose(bodies, CEILING, width / 2, -thick, 0)
    bodies.box.set([-far, height, far, far, -far, -far, 0, far, width, -far, far, far, 0, -far, far, 0])
    encloseTop()
    for (let i = FIRST_CHIP; i < bodies.count; i++) forget(i)
  }

  /** An open ceiling is where nothing comes near it. */
  function encloseTop(): void {
    bodies.box[CEILING * 4] = scene.ceiling ? -FAR : Infinity
  }

  function setGravity(given: number | Vector | undefined): void {
    const { gravity } = scene
    const [x, y] = typeof given === 'number' ? [0, given] : [given?.x, given?.y]
    gravity[X] = within(x, -1e5, 1e5, gravity[X])
    gravity[Y] = within(y, -1e5, 1e5, gravity[Y])
    scene.pull = Math.sqrt(gravity[X] * gravity[X] + gravity[Y] * gravity[Y])
  }

  function isObstacle(i: number): boolean {
    return bodies.density[i] === Infinity
  }

  function wakeAll(): void {
    for (let i = FIRST_CHIP; i < bodies.count; i++) {
      wake(scene, i)
    }
  }

  /** Body `i` has come, or was moved or changed by hand. */
  function changed(i: number): void {
    const { box, boxed, state } = bodies
    forget(i)
    if (!isObstacle(i)) {
      updateEntry(scene, i)
      return
    }
    // What is near an obstacle wakes, and what is in it moves aside.
    halfExtents(bodies, i, 0, 0)
    for (let side = 0; side < 4; side++)
      box[i * 4 + side] = state[i * STATE + (side % 2)] + (side > 1 ? 1 : -1) * extents[side % 2]
    boxed[i] = 1
    for (let j = FIRST_CHIP; j < bodies.count; j++) if (overlap(box, i * 4, j * 4)) wake(scene, j)
    scene.revision++
    scene.cramped = WEDGED_STEPS
  }

  /** The contacts of body `i` are made anew, and the box of a chip. */
  function forget(i: number): void {
    if (!isObstacle(i)) bodies.box[i * 4] = Infinity
    for (let edge = contacts.head[i]; edge >= 0; edge = contacts.next[edge]) resetContact(contacts, edge >> 1)
  }
}

/**
 * Makes every number and array inside `to` what it is inside `from`. Joints stay apart: whoever grabbed
 * shares them.
 */
function copy(from: object, to: object): void {
  const target = to as Record<string, unknown>
  for (const [name, value] of Object.entries(from)) {
    if (name === 'joints') continue
    const own = target[name]
    if (typeof value !== 'object') target[name] = value
    else if (Array.isArray(value)) target[name] = [...value]
    else if (!ArrayBuffer.isView(value)) copy(value as object, own as object)
    else if ((own as Float64Array).length === (value as Float64Array).length)
      (own as Float64Array).set(value as Float64Array)
    else target[name] = (value as Float64Array).slice()
  }
}

/** px, how thick walls are. */
const THICK = 1000
/**
 * px (and rad), the farthest that anything lies from the stage's corner: beyond it poses lose their
 * precision.
 */
const FAR = 1e6

function finite(value: number | undefined, otherwise = 0): number {
  return typeof value === 'number' && value - value === 0 ? value : otherwise
}

/** `value` brought between `least` and `most`; `otherwise` if it is not a finite number. */
function within(value: number | undefined, least: number, most: number, otherwise: number): number {
  return Math.max(least, Math.min(most, finite(value, otherwise)))
}

/** Takes `i` out of the first `count` of a list; returns how many are left. */
function without(list: Int32Array, i: number, count: number): number {
  const at = list.indexOf(i)
  if (at < 0) return count
  list.copyWithin(at, at + 1, count)
  return count - 1
}

/** px; a size below 1 px, or none, counts as 1 px. */
function size(value: number): number {
  return within(value, 1, FAR, 0)
}

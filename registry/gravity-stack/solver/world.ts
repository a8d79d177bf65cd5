import {
  ANGULAR_DAMPING,
  BOUNCE,
  BOUNCE_THRESHOLD,
  FRICTION,
  GRAVITY,
  LINEAR_DAMPING,
  REST_TIME,
  STEP,
  SUBSTEPS,
} from './constants'
import { copy } from './copy'
import { grab } from './grab'
import {
  type BodyOptions,
  type Grab,
  type Motion,
  type Reading,
  sizeOf,
  type WorldOptions,
  within,
} from './input'
import { makeRoomAtOnce } from './make-room'
import { dampingOver } from './math'
import { addBody, placeBody, removeBody, reshapeBody, type Shape } from './population'
import { pushBodies } from './push'
import { ANGLE, FIRST_CHIP, Simulation, SPIN, STATE, VX, VY, X, Y } from './state'
import { step } from './step'
import { addWalls, type Change, configure, enclose, wakeAll } from './surroundings'

export type World = ReturnType<typeof createWorld>

/**
 * A world of rounded boxes in a stage. Same calls, same bits, in every JavaScript engine.
 * Values that are not finite count as left out (sizes as 1 px), so that nothing is ever lost.
 */
export function createWorld(options: WorldOptions) {
  const scene = new Simulation()
  const { bodies } = scene
  scene.substeps = SUBSTEPS
  scene.left = 0
  scene.h = STEP / SUBSTEPS
  scene.air = dampingOver(LINEAR_DAMPING, scene.h)
  scene.spinAir = dampingOver(ANGULAR_DAMPING, scene.h)
  scene.impactRegime.relaxation = 1
  scene.gravity[Y] = GRAVITY
  scene.bounce = BOUNCE
  scene.friction = FRICTION
  scene.threshold = BOUNCE_THRESHOLD
  addWalls(scene)
  enclose(scene, sizeOf(options.width), sizeOf(options.height))
  configure(scene, options)

  return {
    /**
     * Adds a body and returns its id. Infinite density makes an obstacle: static, and what is in it moves
     * aside.
     */
    add(body: BodyOptions): number {
      return addBody(scene, body)
    },

    /** Takes body `id` out; what leaned on it wakes. */
    remove(id: number): void {
      if (bodies.alive[id]) removeBody(scene, id)
    },

    /** Moves body `id` to where and as fast as is given; what leaned on it wakes. */
    place(id: number, motion: Motion): void {
      if (bodies.alive[id]) placeBody(scene, id, motion)
    },

    /** Gives body `id` a new size (px) in place; what it touches wakes. */
    reshape(id: number, shape: Shape): void {
      if (bodies.alive[id]) reshapeBody(scene, id, shape)
    },

    /** Moves floor and right wall; wakes everything. */
    resize(width: number, height: number): void {
      if (sizeOf(width) !== scene.width || sizeOf(height) !== scene.height) {
        scene.revision++
        enclose(scene, sizeOf(width), sizeOf(height))
        wakeAll(scene)
        scene.cramped = REST_TIME / STEP
      }
    },

    /**
     * Parts what moved walls or grown chips have pressed together, without a step: no time passes, and
     * nothing else moves.
     */
    makeRoom(): void {
      makeRoomAtOnce(scene)
    },

    /** Changes gravity (px/s²), ceiling, bounce or friction; wakes everything. */
    configure(change: Change): void {
      configure(scene, change)
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
      return grab(scene, id, x, y)
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
      const { state, before, undrawn } = bodies
      // Share of the step that is not simulated yet: what moves is drawn so much behind.
      const behind = 1 - within(scene.left / STEP, 0, 1, 0)
      for (let i = FIRST_CHIP; i < bodies.count; i++) {
        if (undrawn[i] === 0) continue
        const asleep = bodies.asleep[i] > 0
        undrawn[i] = asleep ? 0 : 1
        const s = i * STATE
        const b = i * 3
        const x = state[s + X] - behind * (state[s + X] - before[b])
        const y = state[s + Y] - behind * (state[s + Y] - before[b + 1])
        const angle = state[s + ANGLE] - behind * (state[s + ANGLE] - before[b + 2])
        visit(i, x, y, angle, asleep)
      }
    },

    /** True when nothing is awake. */
    get resting(): boolean {
      return bodies.awakeCount === 0
    },
  }
}

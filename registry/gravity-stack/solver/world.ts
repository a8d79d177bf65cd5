import { isObstacleBody } from './body'
import { ANGULAR_DAMPING, BOUNCE_THRESHOLD, LINEAR_DAMPING, REST_TIME, STEP, SUBSTEPS } from './constants'
import { copy } from './copy'
import { grab } from './grab'
import { type Box, type Vector, within } from './input'
import { makeRoomAtOnce } from './make-room'
import { dampingOver } from './math'
import { addBody, placeBody, removeBody, reshapeBody } from './population'
import { pushBodies } from './push'
import { ANGLE, FIRST_CHIP, Simulation, STATE, VY, X, Y } from './state'
import { step } from './step'
import { addWalls, configure, enclose, wakeAll } from './surroundings'

export type World = ReturnType<typeof createWorld>

/**
 * A world of rounded boxes in a stage, for `configure` to set its gravity. Same calls, same bits, in every
 * JavaScript engine.
 */
export function createWorld({ width, height }: { width: number; height: number }) {
  const scene = new Simulation()
  const { bodies } = scene
  scene.substeps = SUBSTEPS
  scene.left = 0
  scene.h = STEP / SUBSTEPS
  scene.air = dampingOver(LINEAR_DAMPING, scene.h)
  scene.spinAir = dampingOver(ANGULAR_DAMPING, scene.h)
  scene.impactRegime.relaxation = 1
  scene.threshold = BOUNCE_THRESHOLD
  addWalls(scene)
  enclose(scene, width, height)

  return {
    /**
     * Adds a body and returns its id. Infinite density makes an obstacle: static, and what is in it moves
     * aside.
     */
    add: addBody.bind(null, scene),

    /** Takes body `id` out; what leaned on it wakes. */
    remove(id: number): void {
      if (bodies.alive[id]) removeBody(scene, id)
    },

    /** Moves body `id` to where and as fast as is given; what leaned on it wakes. */
    place: placeBody.bind(null, scene),

    /** Gives body `id` a new size (px) in place; what it touches wakes. */
    reshape: reshapeBody.bind(null, scene),

    /** Moves floor and right wall; wakes everything. */
    resize(width: number, height: number): void {
      if (width !== scene.width || height !== scene.height) {
        scene.revision++
        enclose(scene, width, height)
        wakeAll(scene)
        scene.roomSteps = REST_TIME / STEP
      }
    },

    /**
     * Parts what moved walls or grown chips have pressed together, without a step: no time passes, and
     * nothing else moves.
     */
    makeRoom: makeRoomAtOnce.bind(null, scene),

    /** Sets gravity, ceiling, bounce and friction; wakes everything. */
    configure: configure.bind(null, scene),

    /** Pushes what is in the way of a disc that goes from one place to another; see `pushBodies`. */
    push: pushBodies.bind(null, scene),

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

    /** Takes hold of body `id` at the point (x, y) of the stage. */
    grab: grab.bind(null, scene),

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

    /** Pose of body `id`: px, px, rad; and px/s, how fast it goes down. */
    read(id: number) {
      const { state } = bodies
      const s = id * STATE
      return { x: state[s + X], y: state[s + Y], angle: state[s + ANGLE], vy: state[s + VY] }
    },

    /** px/s², to the right and downwards. */
    get gravity(): Vector {
      return { x: scene.gravity[X], y: scene.gravity[Y] }
    },

    /** The box around each obstacle. */
    obstacleBoxes(): Box[] {
      const boxes: Box[] = []
      for (let i = FIRST_CHIP; i < bodies.count; i++)
        if (bodies.alive[i] && isObstacleBody(bodies, i))
          boxes.push(Array.from(bodies.box.subarray(4 * i, 4 * i + 4)) as Box)
      return boxes
    },

    /** What the world is made of. */
    scene,

    /**
     * Visits every awake body, and each once more after it fell asleep, with the pose to draw: px, px, rad.
     */
    eachMoved(visit: (id: number, x: number, y: number, angle: number, asleep: boolean) => void): void {
      const { state, before, needsDrawing } = bodies
      // Share of the step that is not simulated yet: what moves is drawn so much behind.
      const behind = 1 - scene.left / STEP
      const drawn = (i: number, axis: number) => {
        const now = state[i * STATE + axis]
        return now - behind * (now - before[i * 3 + axis])
      }
      for (let i = FIRST_CHIP; i < bodies.count; i++) {
        if (needsDrawing[i] === 0) continue
        const asleep = bodies.asleep[i] > 0
        needsDrawing[i] = asleep ? 0 : 1
        visit(i, drawn(i, X), drawn(i, Y), drawn(i, ANGLE), asleep)
      }
    },

    /** True when nothing is awake. */
    get resting(): boolean {
      return bodies.awakeCount === 0
    },
  }
}

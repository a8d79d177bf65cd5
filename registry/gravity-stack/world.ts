import {
  type Air,
  ANGLE,
  air,
  EXTENT,
  grown,
  INV_INERTIA,
  INV_MASS,
  MAX_DAMPING,
  MOTION,
  PUSH_SPIN,
  PUSH_X,
  PUSH_Y,
  reserveBodies,
  SHAPE,
  SPIN,
  STATE,
  setPose,
  setShape,
  tally,
  VX,
  VY,
  X,
  Y,
} from './body'
import { COUNT, GAP_NOW, RATE_NOW, touch, WIDEST } from './collide'
import {
  AHEAD,
  ANGULAR_DAMPING,
  BALANCE,
  BOUNCE,
  BOUNCE_THRESHOLD,
  CREEP,
  CROWDED,
  FRICTION,
  GRAVITY,
  IMPACT_SPREAD,
  JAMMED,
  LINEAR_DAMPING,
  LIVELY,
  LIVELY_BOUNCE,
  MARGIN,
  PARTINGS,
  PATIENCE,
  RELAXATION,
  ROUNDS,
  SLOP,
  STEP,
  SUBSTEPS,
  SWEEP_BUDGET,
  SWEEPS,
  SWEEPS_LEAST,
  SWEEPS_LIVELY,
  SWEEPS_UNEVEN,
  TOLERANCE_LEAST,
  TOLERANCE_MOST,
  TOLERANCE_SHARE,
  TOLERANCE_STILL,
  UNEVEN,
} from './constants'
import {
  CLEAR,
  CONTACT,
  carry,
  DRAG,
  DUE,
  gapBound,
  LAG,
  LOAD,
  measure,
  POINTS,
  probe,
  RATE,
  reserveHeads,
  Scene,
  SECOND,
} from './contacts'
import { carryHold, createHold, type Hold, prepareHold, recordHold, solveHold, throwVelocity } from './grab'
import { clearImpacts, Impacts, reserveImpacts } from './impacts'
import { find, findIslands, Islands, reserveIslands, rest } from './islands'
import { enterPairs, keepInBox, leavePairs, Pairs, reservePairs, updatePairs } from './pairs'
import { capSpeed, deepest, keepInside, kick, lift, move, prepare, separate, sweep } from './solver'

export interface WorldOptions {
  /** px, size of the stage: floor at y = height, walls at x = 0 and x = width, no ceiling. */
  width: number
  height: number
  /** px/s² downwards. */
  gravity?: number
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
  /** Sub-steps a step of 1/60 s, 1..64. Left out, each island takes what it needs. */
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

export type Motion = Partial<Pick<BodyOptions, 'x' | 'y' | 'angle' | 'vx' | 'vy' | 'spin'>>

export interface Reading {
  x: number
  y: number
  angle: number
  vx: number
  vy: number
  spin: number
  asleep: boolean
}

export interface Grab {
  /** Where the pointer is, px, and when it was there, s on any clock. */
  moveTo(x: number, y: number, seconds: number): void
  /** Lets go: the body leaves with the pointer's velocity if it kept up, else with its own; at most `MAX_TOSS`. */
  release(): void
}

/** What the last call of `step` did, for tests and tools. */
export interface Stats {
  /** Steps in which something was awake; others are not taken. */
  steps: number
  awake: number
  pairs: number
  narrow: number
  contacts: number
  points: number
  islands: number
  substeps: number
  sweeps: number
  /** Contacts visited by the sweeps over impacts. */
  hits: number
  rows: number
}

export type World = ReturnType<typeof createWorld>

/**
 * A world of rounded boxes in a stage. Same calls, same bits, in every JavaScript engine.
 * Values that are not finite count as left out (sizes as 1 px), so that nothing is ever lost.
 */
export function createWorld(options: WorldOptions) {
  const scene = new Scene()
  const { bodies, contacts, walls } = scene
  const pairs = new Pairs()
  const islands = new Islands()
  const impacts = new Impacts()
  const substeps = Math.round(within(options.substeps, 1, 64, SUBSTEPS))
  const h = STEP / substeps
  const ahead = AHEAD * h
  walls.width = size(options.width)
  walls.height = size(options.height)
  scene.gravity = within(options.gravity, -1e5, 1e5, GRAVITY)
  scene.bounce = within(options.bounce, 0, 1, BOUNCE)
  scene.friction = within(options.friction, 0, 100, FRICTION)
  scene.threshold = within(options.bounceThreshold, 0, 1e6, BOUNCE_THRESHOLD)
  scene.h = h
  const sleeps = options.sleep !== false
  const damping = within(options.linearDamping, 0, MAX_DAMPING, LINEAR_DAMPING)
  const spinDamping = within(options.angularDamping, 0, MAX_DAMPING, ANGULAR_DAMPING)
  const airs = new Map<number, { linear: Air; spin: Air }>()
  const holds: Hold[] = []
  const freeSlots: number[] = []
  const stats: Stats = {
    steps: 0,
    awake: 0,
    pairs: 0,
    narrow: 0,
    contacts: 0,
    points: 0,
    islands: 0,
    substeps: 0,
    sweeps: 0,
    hits: 0,
    rows: 0,
  }
  const pose: Float64Array = new Float64Array(3)
  /** Of the present island, before and after its step. */
  const energies: Float64Array = new Float64Array(4)
  let densities: Float64Array = new Float64Array(0)
  /** Steps in which partings have left the island of a body in a jam, since it last woke. */
  let jams: Int32Array = new Int32Array(0)
  let awake: Int32Array = new Int32Array(0)
  let awakeCount = 0
  let population = 0
  let held: Uint8Array = new Uint8Array(0)
  let undrawn: Uint8Array = new Uint8Array(0)
  /** s, time handed in and not simulated yet. */
  let left = 0
  /** Ratio of the heaviest to the lightest mass in the present island, whole so that it is never boxed, up to SWEEPS_UNEVEN. */
  let uneven = 0
  /** Number of the present sweep. */
  let round = 0

  function reserve(slots: number): void {
    reserveBodies(bodies, slots)
    const capacity = bodies.alive.length
    if (awake.length >= capacity) return
    reserveHeads(contacts, capacity)
    reservePairs(pairs, capacity)
    reserveIslands(islands, capacity)
    reserveImpacts(impacts, capacity)
    awake = grown(awake, capacity)
    held = grown(held, capacity)
    undrawn = grown(undrawn, capacity)
    densities = grown(densities, capacity)
    jams = grown(jams, capacity)
  }

  function airFor(substeps: number): { linear: Air; spin: Air } {
    let found = airs.get(substeps)
    if (!found) {
      found = { linear: air(damping, STEP / substeps), spin: air(spinDamping, STEP / substeps) }
      airs.set(substeps, found)
    }
    return found
  }

  // Waking -----------------------------------------------------------------------------------------------------------

  /** Wakes body `i` and everything that carries it or is carried by it, at any remove. */
  function wake(i: number): void {
    if (bodies.asleep[i] === 0) return
    rouse(i)
    for (let n = awakeCount - 1; n < awakeCount; n++) {
      for (let edge = contacts.head[awake[n]]; edge >= 0; edge = contacts.next[edge]) {
        const j = contacts.pair[edge ^ 1]
        const k = (edge >> 1) * CONTACT
        if (j > 0 && bodies.asleep[j] === 1 && contacts.data[k + LOAD] + contacts.data[k + SECOND + LOAD] > 0)
          rouse(j)
      }
    }
  }

  function rouse(i: number): void {
    bodies.asleep[i] = 0
    bodies.rest[i * 4 + 3] = 0
    jams[i] = 0
    undrawn[i] = 1
    awake[awakeCount++] = i
    bodies.before.set(bodies.state.subarray(i * STATE + X, i * STATE + ANGLE + 1), i * 3)
  }

  /** Wakes body `i` and all that touch it, whether they carry anything or not. */
  function disturb(i: number): void {
    wake(i)
    bodies.rest[i * 4 + 3] = 0
    for (let edge = contacts.head[i]; edge >= 0; edge = contacts.next[edge]) {
      const j = contacts.pair[edge ^ 1]
      if (j > 0 && contacts.data[(edge >> 1) * CONTACT + POINTS] > 0) wake(j)
    }
  }

  /** Wakes the sleepers that an awake body is about to hit. One that merely lies against them wakes nobody. */
  function wakeStruck(): void {
    const { state } = bodies
    for (let n = 0; n < awakeCount; n++) {
      const i = awake[n]
      for (let edge = contacts.head[i]; edge >= 0; edge = contacts.next[edge]) {
        const j = contacts.pair[edge ^ 1]
        if (j === 0 || bodies.asleep[j] === 0) continue
        const c = edge >> 1
        const s = i * STATE
        const speed =
          Math.abs(state[s + VX]) +
          Math.abs(state[s + VY]) +
          bodies.shape[i * SHAPE + EXTENT] * Math.abs(state[s + SPIN])
        const go = speed * STEP + 0.5 * Math.abs(scene.gravity) * STEP * STEP
        if (gapBound(bodies, contacts, c) > go + MARGIN) continue
        touch[WIDEST] = go + MARGIN
        measure(bodies, contacts, walls, c)
        contacts.measured++
        for (let p = c * CONTACT, n = touch[COUNT]; n > 0; n--, p += SECOND) {
          probe(bodies, contacts, c, p)
          if (touch[GAP_NOW] < -4 * SLOP || touch[RATE_NOW] < -IMPACT_SPREAD) wake(j)
        }
      }
    }
  }

  // The step ---------------------------------------------------------------------------------------------------------

  function stepOnce(): void {
    const { state, before } = bodies
    for (let n = 0; n < awakeCount; n++) {
      const i = awake[n]
      undrawn[i] = 1
      before[i * 3] = state[i * STATE + X]
      before[i * 3 + 1] = state[i * STATE + Y]
      before[i * 3 + 2] = state[i * STATE + ANGLE]
    }
    tally(bodies, awake, 0, awakeCount, ahead)
    updatePairs(bodies, pairs, contacts, walls, scene.gravity, awake, awakeCount)
    if (awakeCount < population) wakeStruck()
    findIslands(islands, scene, holds, awake, awakeCount)
    while (islands.struckCount > 0) {
      for (let n = 0; n < islands.struckCount; n++) wake(islands.struck[n])
      findIslands(islands, scene, holds, awake, awakeCount)
    }
    for (let n = 0; n < islands.count; n++) {
      const b0 = islands.bodyStart[n]
      const b1 = islands.bodyStart[n + 1]
      const c0 = islands.contactStart[n]
      const c1 = islands.contactStart[n + 1]
      if (c0 === c1 && held[islands.bodies[b0]] === 0) fly(islands.bodies[b0])
      else solve(b0, b1, c0, c1)
    }
    stats.steps++
    stats.islands = islands.count
    stats.awake = awakeCount
    if (sleeps) awakeCount = rest(islands, scene, held, awake, awakeCount)
  }

  /** A body alone in the air: the whole step in closed form. */
  function fly(i: number): void {
    const { state } = bodies
    const { linear, spin } = airFor(1)
    const s = i * STATE
    const dx = linear.reach * state[s + VX]
    const dy = linear.reach * state[s + VY] + scene.gravity * linear.fall
    const by = spin.reach * state[s + SPIN]
    state[s + X] += dx
    state[s + Y] += dy
    state[s + ANGLE] += by
    state[s + VX] *= linear.fade
    state[s + VY] = linear.fade * state[s + VY] + scene.gravity * linear.reach
    state[s + SPIN] *= spin.fade
    capSpeed(state, s)
    keepInside(scene, i)
  }

  /** One island through the step. */
  function solve(b0: number, b1: number, c0: number, c1: number): void {
    const live = islands.live
    let end = c0
    const speed = fastest(b0, b1)
    const { linear, spin } = airFor(substeps)
    const still = speed <= BALANCE
    scene.slow = still ? TOLERANCE_STILL : BALANCE
    scene.tolerance = still
      ? TOLERANCE_STILL
      : Math.max(TOLERANCE_LEAST, Math.min(TOLERANCE_MOST, TOLERANCE_SHARE * speed))
    const relaxation = c1 - c0 > CROWDED && speed > CREEP ? RELAXATION : 1
    const grabbed = holds.length > 0 ? holds.filter((hold) => inIsland(hold, b0)) : holds
    // A hand can press harder than any chip: what it does is solved to the end.
    let sweeps =
      grabbed.length > 0
        ? SWEEPS
        : speed > LIVELY
          ? SWEEPS_LIVELY
          : Math.max(SWEEPS_LEAST, Math.min(SWEEPS, Math.floor(SWEEP_BUDGET / (c1 - c0))))
    // A light chip under a heavy one hands a sweep's impulse on in tiny parts only.
    if (uneven > UNEVEN) sweeps = Math.max(sweeps, Math.min(uneven, Math.floor(SWEEP_BUDGET / 3 / (c1 - c0))))
    // Dull chips lose more than what parts them could give: slow ones are left alone, and what lifts fast ones costs them nothing.
    const dull = scene.bounce < LIVELY_BOUNCE
    const free = grabbed.length > 0 || (dull && speed < LIVELY)
    if (!free) weigh(b0, b1, 0)
    warmStart(b0, b1, c0, c1, grabbed, substeps)
    for (let n = 0; n < substeps; n++) {
      round = (round + ROUNDS) & 0x3fffffff
      clearImpacts(impacts)
      scene.relaxation = relaxation
      if (n > 0) tally(bodies, islands.bodies, b0, b1, ahead)
      end = prepare(scene, impacts, islands.contacts, live, c0, c1)
      for (let g = 0; g < grabbed.length; g++) prepareHold(bodies, grabbed[g]!, h, scene.gravity)
      kick(scene, islands.bodies, b0, b1, linear, spin, round)
      let stirs = 1
      for (let k = 0; k < sweeps && stirs > 0; k++) {
        for (let g = 0; g < grabbed.length; g++) {
          solveHold(bodies, grabbed[g]!)
          bodies.stirred[grabbed[g]!.body] = round + k - 1
        }
        stirs = sweep(scene, live, c0, end, round + k)
        stats.sweeps++
      }
      const active = move(scene, islands.bodies, b0, b1)
      stats.substeps++
      if (active === 0 && (stirs === 0 || still) && grabbed.length === 0) break
    }
    let deep = separate(scene, live, c0, end)
    if (deep > 0 && speed <= JAMMED) {
      for (let n = Math.max(PARTINGS, uneven); n > 1 && deep > 0; n--) deep = separate(scene, live, c0, end)
      if (deep > 0) relieve(b0, b1, c0, end)
    }
    for (let n = b0; n < b1; n++) {
      keepInBox(bodies, pairs, contacts, islands.bodies[n])
      keepInside(scene, islands.bodies[n])
    }
    if (free) return
    weigh(b0, b1, 2)
    const moving = energies[2]
    const gain = Math.min(energies[3] - energies[1], dull ? moving - energies[0] : Infinity)
    if (!(gain > 0)) return
    const share = Math.sqrt(Math.max(0, 1 - gain / moving))
    for (let n = b0; n < b1; n++) {
      const s = islands.bodies[n] * STATE
      for (let axis = VX; axis <= SPIN; axis++) bodies.state[s + axis] *= share
    }
  }

  /** Counts how often partings have left the island deep in itself; after a while one of the two deepest is pushed up until it is free. */
  function relieve(b0: number, b1: number, c0: number, end: number): void {
    const worst = deepest(scene, islands.live, c0, end)
    let often = 0
    for (let n = b0; n < b1; n++) {
      const i = islands.bodies[n]
      jams[i] = worst < 0 ? 0 : jams[i] + 1
      often = Math.max(often, jams[i])
    }
    if (often >= PATIENCE) lift(scene, worst)
  }

  /** Leaves in `energies` at `at` the kinetic energy of the bodies of an island, and next to it the same with that of their height. */
  function weigh(b0: number, b1: number, at: number): void {
    const { state } = bodies
    let moving = 0
    let height = 0
    for (let n = b0; n < b1; n++) {
      const s = islands.bodies[n] * STATE
      const vx = state[s + VX]
      const vy = state[s + VY]
      const spin = state[s + SPIN]
      const mass = 1 / state[s + INV_MASS]
      moving += mass * (vx * vx + vy * vy) + (spin * spin) / state[s + INV_INERTIA]
      height -= mass * state[s + Y]
    }
    energies[at] = 0.5 * moving
    energies[at + 1] = 0.5 * moving + scene.gravity * height
  }

  /** px/s, speed of the fastest point of the bodies of an island; whether their masses are very unlike is noted in passing. */
  function fastest(b0: number, b1: number): number {
    const { state, shape } = bodies
    let most = 0
    let lightest = 0
    let heaviest = Infinity
    for (let n = b0; n < b1; n++) {
      const i = islands.bodies[n]
      const s = i * STATE
      const inverse = state[s + INV_MASS]
      if (inverse > lightest) lightest = inverse
      if (inverse < heaviest) heaviest = inverse
      const speed =
        Math.abs(state[s + VX]) +
        Math.abs(state[s + VY]) +
        shape[i * SHAPE + EXTENT] * Math.abs(state[s + SPIN])
      if (speed > most) most = speed
    }
    uneven = Math.min(SWEEPS_UNEVEN, lightest / heaviest) | 0
    return most
  }

  /** Hands the impulses of the last step to the bodies as what they may expect in a sub-step. */
  function warmStart(
    b0: number,
    b1: number,
    c0: number,
    c1: number,
    grabbed: Hold[],
    substeps: number,
  ): void {
    const { motion } = bodies
    for (let n = b0; n < b1; n++) {
      const i = islands.bodies[n]
      const m = i * MOTION
      motion[m + PUSH_X] = 0
      motion[m + PUSH_Y] = 0
      motion[m + PUSH_SPIN] = 0
    }
    const d = contacts.data
    for (let n = c0; n < c1; n++) {
      const c = islands.contacts[n]
      const k = c * CONTACT
      d[k + LAG] = 0
      if (d[k + POINTS] > 0 && d[k + LOAD] + d[k + SECOND + LOAD] > 0) {
        if (d[k + RATE] !== substeps) {
          const scale = d[k + RATE] / substeps
          d[k + LOAD] *= scale
          d[k + SECOND + LOAD] *= scale
          d[k + DRAG] *= scale
        }
        carry(bodies, contacts, c, 1)
      }
      d[k + RATE] = substeps
    }
    for (const hold of grabbed) carryHold(bodies, hold, substeps)
  }

  /** Whether the body that `hold` holds is in the island that starts at `b0`. */
  function inIsland(hold: Hold, b0: number): boolean {
    return islands.bodyStart[islands.number[find(islands.parent, hold.body)]] === b0
  }

  return {
    get stats(): Readonly<Stats> {
      count()
      return stats
    },

    /** Adds a body and returns its id. */
    add(body: BodyOptions): number {
      const i = freeSlots.pop() ?? bodies.count++
      reserve(bodies.count)
      const s = i * STATE
      densities[i] = within(positive(body.density, 1), 1e-6, 1e6, 1)
      setShape(bodies, i, size(body.width), size(body.height), finite(body.radius), densities[i])
      setPose(
        bodies,
        i,
        within(body.x, -FAR, FAR, 0),
        within(body.y, -FAR, FAR, 0),
        within(body.angle, -FAR, FAR, 0),
      )
      bodies.state[s + VX] = finite(body.vx)
      bodies.state[s + VY] = finite(body.vy)
      bodies.state[s + SPIN] = within(body.spin, -1000, 1000, 0)
      capSpeed(bodies.state, s)
      bodies.alive[i] = 1
      population++
      bodies.asleep[i] = 0
      held[i] = 0
      jams[i] = 0
      undrawn[i] = 1
      awake[awakeCount++] = i
      enterPairs(pairs, i)
      return i
    },

    /** Takes body `id` out; what leaned on it wakes. */
    remove(id: number): void {
      if (!bodies.alive[id]) return
      disturb(id)
      for (let n = holds.length - 1; n >= 0; n--) if (holds[n]!.body === id) holds.splice(n, 1)
      leavePairs(pairs, contacts, id)
      let to = 0
      for (let n = 0; n < awakeCount; n++) if (awake[n] !== id) awake[to++] = awake[n]
      awakeCount = to
      bodies.alive[id] = 0
      population--
      freeSlots.push(id)
    },

    /** Moves body `id` to where and as fast as is given; what leaned on it wakes. */
    place(id: number, motion: Motion): void {
      if (!bodies.alive[id]) return
      disturb(id)
      const s = id * STATE
      const state = bodies.state
      setPose(
        bodies,
        id,
        within(motion.x, -FAR, FAR, state[s + X]),
        within(motion.y, -FAR, FAR, state[s + Y]),
        within(motion.angle, -FAR, FAR, state[s + ANGLE]),
      )
      state[s + VX] = finite(motion.vx, state[s + VX])
      state[s + VY] = finite(motion.vy, state[s + VY])
      state[s + SPIN] = within(motion.spin, -1000, 1000, state[s + SPIN])
      capSpeed(state, s)
      forget(id)
    },

    /** Gives body `id` a new size (px) in place; what it touches wakes. */
    reshape(id: number, shape: { width: number; height: number; radius?: number }): void {
      if (!bodies.alive[id]) return
      disturb(id)
      setShape(bodies, id, size(shape.width), size(shape.height), finite(shape.radius), densities[id])
      forget(id)
    },

    /** Moves floor and right wall; wakes everything. */
    resize(width: number, height: number): void {
      if (size(width) === walls.width && size(height) === walls.height) return
      walls.width = size(width)
      walls.height = size(height)
      for (let i = 1; i < bodies.count; i++) {
        if (!bodies.alive[i]) continue
        wake(i)
        bodies.rest[i * 4 + 3] = 0
        forget(i)
      }
    },

    /** Changes gravity (px/s²), bounce or friction; wakes everything. */
    configure(change: { gravity?: number; bounce?: number; friction?: number }): void {
      const gravity = within(change.gravity, -1e5, 1e5, scene.gravity)
      // What rests weighs as much more or less at once: else a pile hops.
      const share = Math.max(0, Math.min(1000, gravity / (scene.gravity || gravity || 1)))
      for (let k = 0; k < contacts.count * CONTACT; k += CONTACT) {
        contacts.data[k + LOAD] *= share
        contacts.data[k + SECOND + LOAD] *= share
        contacts.data[k + DRAG] *= share
      }
      scene.gravity = gravity
      scene.bounce = within(change.bounce, 0, 1, scene.bounce)
      scene.friction = within(change.friction, 0, 100, scene.friction)
      for (let i = 1; i < bodies.count; i++) {
        if (!bodies.alive[i]) continue
        wake(i)
        bodies.rest[i * 4 + 3] = 0
      }
    },

    /** Lets `seconds` pass in fixed steps, an hour at most; what is left over is simulated next time. */
    step(seconds: number): void {
      stats.steps = 0
      stats.awake = 0
      contacts.measured = 0
      stats.islands = 0
      stats.substeps = 0
      stats.sweeps = 0
      stats.rows = 0
      contacts.rows = 0
      impacts.sweeps = 0
      left += seconds > 0 && seconds < Infinity ? Math.min(seconds, 3600) : 0
      // A thousandth of a step of grace, so that a step handed in as a rounded number of seconds is not put off.
      while (left >= STEP * 0.999) {
        left -= STEP
        if (awakeCount > 0) stepOnce()
      }
    },

    /** Pose and velocity of body `id`: px, radians, px/s, rad/s. For tests and tools; not used in a loop. */
    read(id: number): Reading {
      const s = id * STATE
      const state = bodies.state
      return {
        x: state[s + X],
        y: state[s + Y],
        angle: state[s + ANGLE],
        vx: state[s + VX],
        vy: state[s + VY],
        spin: state[s + SPIN],
        asleep: bodies.asleep[id] === 1,
      }
    },

    /** Mass and moment of inertia of body `id`, in units of density·px² and density·px⁴. */
    mass(id: number): { mass: number; inertia: number } {
      return {
        mass: 1 / bodies.state[id * STATE + INV_MASS],
        inertia: 1 / bodies.state[id * STATE + INV_INERTIA],
      }
    },

    /** Takes hold of body `id` at the point (x, y) of the stage; of one that is gone nothing comes. */
    grab(id: number, x: number, y: number): Grab {
      if (!bodies.alive[id]) return { moveTo() {}, release() {} }
      const hold = createHold(
        bodies,
        id,
        within(x, -FAR, FAR, bodies.state[id * STATE + X]),
        within(y, -FAR, FAR, bodies.state[id * STATE + Y]),
      )
      disturb(id)
      held[id]++
      holds.push(hold)
      return {
        moveTo(toX, toY, seconds) {
          const when = within(seconds, -1e12, 1e12, 0)
          recordHold(hold, within(toX, -FAR, FAR, hold.x), within(toY, -FAR, FAR, hold.y), when)
        },
        release() {
          const n = holds.indexOf(hold)
          if (n < 0) return
          holds.splice(n, 1)
          held[id]--
          throwVelocity(bodies, hold)
        },
      }
    },

    /** What the world is made of, for tools that draw it. */
    scene,

    /** x, y (px) and angle (rad) to draw of the body that `eachMoved` visits. */
    pose,

    /** Visits every body that has moved since the last call, its pose to draw in `pose`. */
    eachMoved(visit: (id: number, asleep: boolean) => void): void {
      const share = Math.min(1, Math.max(0, left / STEP))
      const { state, before } = bodies
      for (let i = 1; i < bodies.count; i++) {
        if (undrawn[i] === 0 || bodies.alive[i] === 0) continue
        undrawn[i] = 1 - bodies.asleep[i]
        for (let axis = 0; axis < 3; axis++) {
          const now = state[i * STATE + axis]
          const then = before[i * 3 + axis]
          pose[axis] = undrawn[i] > 0 ? then + share * (now - then) : now
        }
        visit(i, undrawn[i] === 0)
      }
    },

    /** True when nothing is awake. */
    get resting(): boolean {
      return awakeCount === 0
    },

    /** Digest of every pose and velocity, bit for bit (FNV-1a). */
    hash(): string {
      let hash = 0x811c9dc5
      for (let i = 1; i < bodies.count; i++) {
        if (bodies.alive[i] === 0) continue
        const words = new Uint32Array(bodies.state.slice(i * STATE, i * STATE + 6).buffer)
        for (const word of words) hash = Math.imul(hash ^ word, 0x01000193)
      }
      return (hash >>> 0).toString(16).padStart(8, '0')
    },
  }

  /** Body `i` was moved or changed by hand: its box and its contacts are made anew. */
  function forget(i: number): void {
    pairs.box[i * 4] = Infinity
    undrawn[i] = 1
    for (let edge = contacts.head[i]; edge >= 0; edge = contacts.next[edge]) {
      contacts.data[(edge >> 1) * CONTACT + CLEAR] = -Infinity
      contacts.data[(edge >> 1) * CONTACT + DUE] = -Infinity
      contacts.data[(edge >> 1) * CONTACT + POINTS] = 0
      contacts.data[(edge >> 1) * CONTACT + LOAD] = 0
      contacts.data[(edge >> 1) * CONTACT + SECOND + LOAD] = 0
      contacts.data[(edge >> 1) * CONTACT + DRAG] = 0
    }
  }

  function count(): void {
    stats.narrow = contacts.measured
    stats.rows = contacts.rows
    stats.hits = impacts.sweeps
    stats.pairs = 0
    stats.contacts = 0
    stats.points = 0
    for (let c = 0; c < contacts.count; c++) {
      if (contacts.pair[2 * c + 1] === 0) continue
      stats.pairs++
      const points = contacts.data[c * CONTACT + POINTS]
      if (points > 0) stats.contacts++
      stats.points += points
    }
  }
}

/** px (and rad), the farthest that anything lies from the stage's corner: beyond it poses lose their precision. */
const FAR = 1e6

function finite(value: number | undefined, otherwise = 0): number {
  return value !== undefined && value - value === 0 ? value : otherwise
}

/** `value` brought between `least` and `most`; `otherwise` if it is not a finite number. */
function within(value: number | undefined, least: number, most: number, otherwise: number): number {
  return Math.max(least, Math.min(most, finite(value, otherwise)))
}

function positive(value: number | undefined, otherwise: number): number {
  return value !== undefined && value > 0 && value < Infinity ? value : otherwise
}

/** px; a size below 1 px, or none, counts as 1 px. */
function size(value: number): number {
  return Math.max(1, Math.min(FAR, finite(value)))
}

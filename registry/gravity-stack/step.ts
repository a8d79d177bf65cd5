import {
  type Air,
  ANGLE,
  air,
  type Bodies,
  CORE,
  capSpeed,
  INV_INERTIA,
  INV_MASS,
  MOTION,
  PUSH_SPIN,
  PUSH_X,
  PUSH_Y,
  RADIUS,
  SHAPE,
  SPIN,
  STATE,
  speedOf,
  tally,
  VX,
  VY,
  X,
  Y,
} from './body'
import { COUNT, GAP_NOW, RATE_NOW, touch, WIDEST } from './collide'
import {
  AHEAD,
  BALANCE,
  CREEP,
  CROWDED,
  IMPACT_SPREAD,
  JAMMED,
  LIVELY,
  LIVELY_BOUNCE,
  MARGIN,
  MAX_SPEED,
  PARTING_BUDGET,
  PARTINGS,
  PATIENCE,
  REFRESH,
  REFRESH_ROCKING,
  RELAXATION,
  ROCKING,
  ROOM_ROUNDS,
  RUNAWAY,
  SLOP,
  STEP,
  STICTION,
  SWEEP_BUDGET,
  SWEEPS,
  SWEEPS_LEAST,
  SWEEPS_LIVELY,
  SWEEPS_UNEVEN,
  TOLERANCE_LEAST,
  TOLERANCE_MOST,
  TOLERANCE_SHARE,
  TOLERANCE_SHARE_LIVELY,
  TOLERANCE_STILL,
  UNEVEN,
  UPRIGHT_CORE,
  UPRIGHT_ROUND,
} from './constants'
import {
  CONTACT,
  carry,
  gapBound,
  LAG,
  LOAD,
  loadOf,
  MEASURED,
  measure,
  POINTS,
  probe,
  Scene,
  SECOND,
  SUBSTEPS_TAKEN,
  SWEPT,
  TA,
} from './contacts'
import { carryHold, type Hold, prepareHold, solveHold } from './grab'
import { clearImpacts, furthest, Impacts } from './impacts'
import { findIslands, Islands, rest } from './islands'
import { keepBack, Pairs, updatePairs } from './pairs'
import { keepInside, kick, liftWedged, move, prepare, separate, straighten, sweep } from './solver'

/**
 * All that a step works on. What runs in a step is outside of the world that calls it: functions made anew for every world would be
 * compiled anew as well, and all of them whenever one of the worlds has gone.
 */
export class Simulation extends Scene {
  /** Once all of a class have gone V8 forgets its shape, and throws away what was compiled for it: one stays. */
  static kept: Simulation = new Simulation(2, 0.5, 0.5)
  pairs = new Pairs()
  islands = new Islands()
  impacts = new Impacts()
  sleeps = true
  /** Of a step of 1/60 s. */
  substeps = 1
  /** What the air does to velocity and to spin in a sub-step, and in a step without any. */
  air: Air
  spinAir: Air
  flightAir: Air
  flightSpinAir: Air
  /** Of the present island, before and after its step. */
  energies: Float64Array = new Float64Array(4)
  /** Steps left in which room is made for what was pressed together. */
  cramped = 0
  /** px/s, speed of the fastest point of the present island when its step began, and whether very unequal masses fly about in it. */
  speed = 0.5
  crushing = false
  /** s, time handed in and not simulated yet. */
  left = 0.5
  /** Ids of removed bodies, which the next bodies get. */
  freeSlots: number[] = []
  /** How often the world was changed from outside, other than by a new body. */
  revision = 0

  constructor(substeps: number, damping: number, spinDamping: number) {
    super()
    const h = STEP / substeps
    this.substeps = substeps
    this.left = 0
    this.h = h
    // What nothing brakes in the air slides as Coulomb says: so it is measured.
    this.stiction = damping > 0 ? STICTION : 0
    this.air = air(damping, h)
    this.spinAir = air(spinDamping, h)
    this.flightAir = air(damping, STEP)
    this.flightSpinAir = air(spinDamping, STEP)
  }
}

/** One step of all that is awake. */
export function stepOnce(simulation: Simulation): void {
  const { bodies, pairs, islands } = simulation
  const { state, before, awake } = bodies
  for (let n = 0; n < bodies.awakeCount; n++) {
    const i = awake[n]
    for (let axis = 0; axis < 3; axis++) before[i * 3 + axis] = state[i * STATE + axis]
  }
  if (simulation.cramped > 0) makeRoom(simulation)
  tally(bodies, awake, 0, bodies.awakeCount, AHEAD * simulation.h)
  updatePairs(simulation, pairs)
  if (bodies.awakeCount < pairs.sorted) wakeStruck(simulation)
  findIslands(islands, simulation)
  while (islands.struckCount > 0) {
    for (let n = 0; n < islands.struckCount; n++) wake(simulation, islands.struck[n])
    findIslands(islands, simulation)
  }
  for (let n = 0; n < islands.count; n++) {
    const b0 = islands.bodyStart[n]
    const b1 = islands.bodyStart[n + 1]
    const c0 = islands.contactStart[n]
    const c1 = islands.contactStart[n + 1]
    if (c0 === c1 && bodies.held[islands.bodies[b0]] === 0) fly(simulation, islands.bodies[b0])
    else solve(simulation, b0, b1, c0, c1)
  }
  if (simulation.sleeps) rest(islands, simulation)
}

/** A body alone in the air: the whole step in closed form. */
function fly(simulation: Simulation, i: number): void {
  const { bodies, gravity, flightAir: linear, flightSpinAir: spin } = simulation
  const { state } = bodies
  const s = i * STATE
  state[s + X] += linear.reach * state[s + VX]
  state[s + Y] += linear.reach * state[s + VY] + gravity * linear.fall
  state[s + ANGLE] += spin.reach * state[s + SPIN]
  state[s + VX] *= linear.fade
  state[s + VY] = linear.fade * state[s + VY] + gravity * linear.reach
  state[s + SPIN] *= spin.fade
  capSpeed(state, s, MAX_SPEED)
  keepInside(simulation, i)
}

/** One island through the step. */
function solve(simulation: Simulation, b0: number, b1: number, c0: number, c1: number): void {
  const { bodies, contacts, h, holds, pairs, islands, impacts, substeps, work, air, spinAir } = simulation
  const { live, sorted } = contacts
  const grabbed = holds.length > 0 ? holds.filter((hold) => inIsland(islands, hold, b0)) : holds
  const held = grabbed.length > 0
  const speed = fastest(simulation, b0, b1)
  simulation.speed = speed
  const sweeps = tune(simulation, c1 - c0, held)
  const { relaxation } = simulation
  // Slow ones are left alone: next to what creeps the least that a parting lifts is much. What lifts fast ones costs dull chips nothing, who lose more than that.
  const dull = simulation.bounce < LIVELY_BOUNCE
  const free = held || speed < LIVELY
  if (!free) weigh(simulation, b0, b1, 0)
  warmStart(simulation, b0, b1, c0, c1, grabbed)
  let end = c0
  for (let n = 0; n < substeps; n++) {
    simulation.relaxation = relaxation
    simulation.sweeps = sweeps
    clearImpacts(impacts)
    if (n > 0) tally(bodies, islands.bodies, b0, b1, AHEAD * h)
    end = prepare(simulation, impacts, sorted, live, c0, c1)
    for (let g = 0; g < grabbed.length; g++) prepareHold(simulation, grabbed[g]!)
    kick(simulation, islands.bodies, b0, b1, air, spinAir)
    const solved = converge(simulation, grabbed, b0, b1, c0, end)
    const active = move(simulation, islands.bodies, b0, b1)
    work[SUBSTEPS_TAKEN]++
    // In balance the other sub-steps would repeat this one.
    if (active === 0 && (solved || speed <= BALANCE) && !held) break
  }
  const deep = separate(simulation, live, c0, end)
  if (speed <= JAMMED) unjam(simulation, deep, b0, b1, c0, end)
  for (let n = b0; n < b1; n++) keepBack(simulation, pairs, islands.bodies[n], speed)
  if (!free) holdEnergy(simulation, dull, b0, b1)
}

/** Chooses how exactly an island of so many contacts is solved, by its speed and masses; returns the most sweeps of a sub-step. */
function tune(simulation: Simulation, contactCount: number, held: boolean): number {
  const { speed, uneven } = simulation
  const still = speed <= BALANCE
  const lively = speed > LIVELY
  // A light chip under a heavy one hands a sweep's impulse on in tiny parts only.
  const unequal = uneven > UNEVEN
  const most = Math.min(uneven, SWEEPS_UNEVEN)
  simulation.lively = lively
  simulation.crushing = unequal && lively
  simulation.loose = speed > ROCKING * Math.abs(simulation.gravity) && !lively ? REFRESH_ROCKING : REFRESH
  simulation.tolerance = still
    ? TOLERANCE_STILL
    : Math.max(
        TOLERANCE_LEAST,
        Math.min(TOLERANCE_MOST, (lively ? TOLERANCE_SHARE_LIVELY : TOLERANCE_SHARE) * speed),
      ) / (simulation.crushing ? Math.sqrt(uneven) : 1)
  // Two contacts of one light chip are solved soonest with the root of the ratio: Young's optimal over-relaxation.
  simulation.relaxation = simulation.crushing
    ? 2 / (1 + 1 / Math.sqrt(1 + most))
    : contactCount > CROWDED && speed > CREEP
      ? RELAXATION
      : 1
  // A hand can press harder than any chip: what it does is solved to the end.
  const usual = held
    ? SWEEPS
    : lively
      ? SWEEPS_LIVELY
      : Math.max(SWEEPS_LEAST, Math.min(SWEEPS, Math.floor(SWEEP_BUDGET / contactCount)))
  return unequal ? Math.max(usual, Math.min(most, Math.floor(SWEEP_BUDGET / 3 / contactCount))) : usual
}

/** Sweeps an island until none of its contacts changes, or as often as a sub-step may; returns whether it came to that. */
function converge(
  simulation: Simulation,
  grabbed: Hold[],
  b0: number,
  b1: number,
  c0: number,
  end: number,
): boolean {
  const { bodies, contacts, h, crushing, speed, sweeps, work } = simulation
  const unequal = simulation.uneven > UNEVEN
  const lap = end - c0 + 1
  let further = simulation.relaxation
  let latest = 0
  for (let k = 0; k < sweeps; k++) {
    if (crushing) simulation.relaxation = furthest(further, k, sweeps)
    for (let g = 0; g < grabbed.length; g++) {
      solveHold(bodies, grabbed[g]!, h, simulation.gravity)
      bodies.stirred[grabbed[g]!.body] = latest = k * lap
    }
    latest = sweep(simulation, contacts.live, c0, end, k * lap, latest)
    work[SWEPT]++
    // Where friction or a third chip has a say, it may not converge.
    if (unequal && simulation.relaxation > 1 && fastest(simulation, b0, b1) > RUNAWAY * speed)
      simulation.relaxation = further = 1
    if (latest <= k * lap) return true
  }
  return false
}

/** Takes the energy that the step has given an island out of all its velocities alike. */
function holdEnergy(simulation: Simulation, dull: boolean, b0: number, b1: number): void {
  weigh(simulation, b0, b1, 2)
  const { bodies, energies, islands } = simulation
  const moving = energies[2]
  const gain = Math.min(energies[3] - energies[1], dull ? moving - energies[0] : Infinity)
  if (!(gain > 0)) return
  const share = Math.sqrt(Math.max(0, 1 - gain / moving))
  for (let n = b0; n < b1; n++) {
    const s = islands.bodies[n] * STATE
    for (let axis = VX; axis <= SPIN; axis++) bodies.state[s + axis] *= share
  }
}

/** Parts an island that its step has left `deep`, as often as its masses ask; one that stays so for long more often, and what is wedged in it is pushed up until it is free. */
function unjam(simulation: Simulation, deep: number, b0: number, b1: number, c0: number, end: number): void {
  const { bodies } = simulation.islands
  const { live } = simulation.contacts
  const { jams } = simulation.bodies
  let steps = 0
  for (let n = b0; n < b1; n++) steps = Math.max(steps, jams[bodies[n]])
  const most = Math.max(PARTINGS, Math.min(simulation.uneven, SWEEPS_UNEVEN))
  const partings = steps < PATIENCE ? most : Math.max(most, PARTING_BUDGET / (end - c0))
  for (let n = partings; n > 1 && deep > 0; n--) deep = separate(simulation, live, c0, end)
  for (let n = b0; n < b1; n++) jams[bodies[n]] = deep > 0 ? steps + 1 : 0
  if (deep > 0 && steps >= PATIENCE) liftWedged(simulation, live, c0, end)
}

/** Leaves in `energies` at `at` the kinetic energy of the bodies of an island, and next to it the same with that of their height. */
function weigh(simulation: Simulation, b0: number, b1: number, at: number): void {
  const { bodies, gravity, islands, energies } = simulation
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
  energies[at + 1] = 0.5 * moving + gravity * height
}

/** px/s, speed of the fastest point of the bodies of an island; whether their masses are very unlike is noted in passing. */
function fastest(simulation: Simulation, b0: number, b1: number): number {
  const { bodies, islands } = simulation
  const { state } = bodies
  let most = 0
  let lightest = 0
  let heaviest = Infinity
  for (let n = b0; n < b1; n++) {
    const i = islands.bodies[n]
    const s = i * STATE
    const inverse = state[s + INV_MASS]
    if (inverse > lightest) lightest = inverse
    if (inverse < heaviest) heaviest = inverse
    most = Math.max(most, speedOf(bodies, i))
  }
  simulation.uneven = Math.min(1e6, lightest / heaviest) | 0
  return most
}

/** Hands the impulses of the last step to the bodies as what they may expect in a sub-step, and notes how well each is borne. */
function warmStart(
  simulation: Simulation,
  b0: number,
  b1: number,
  c0: number,
  c1: number,
  grabbed: Hold[],
): void {
  const { bodies, contacts, islands } = simulation
  const { motion, shape, footing } = bodies
  for (let n = b0; n < b1; n++) {
    const i = islands.bodies[n]
    const m = i * MOTION
    footing[i] = 0
    motion[m + PUSH_X] = 0
    motion[m + PUSH_Y] = 0
    motion[m + PUSH_SPIN] = 0
  }
  const d = contacts.data
  for (let n = c0; n < c1; n++) {
    const c = contacts.sorted[n]
    const k = c * CONTACT
    d[k + LAG] = 0
    if (d[k + POINTS] === 0 || d[k + LOAD] + d[k + SECOND + LOAD] === 0) continue
    carry(simulation, c, 1)
    const both = d[k + LOAD] * d[k + SECOND + LOAD] > 0
    for (let side = 0; side < 2; side++) {
      const i = contacts.pair[2 * c + side]
      const other = contacts.pair[2 * c + 1 - side]
      // On what is rounder than it is high it would only rock.
      const low = UPRIGHT_ROUND * shape[i * SHAPE + RADIUS] + UPRIGHT_CORE * shape[i * SHAPE + CORE]
      const stands = Math.abs(d[k + TA + side]) > Math.max(low, shape[other * SHAPE + RADIUS])
      if (both || !stands) footing[i] = 1
    }
  }
  for (const hold of grabbed) carryHold(bodies, hold)
}

/** Whether the body that `hold` holds is in the island that starts at `b0`. */
function inIsland(islands: Islands, hold: Hold, b0: number): boolean {
  return islands.bodyStart[islands.number[hold.body]] === b0
}

/**
 * Walls have moved, or chips have grown: what is in them now is moved aside, and what lies there in turn. No velocity changes, so
 * nothing is thrown. After a jump it takes some steps.
 */
export function makeRoom(simulation: Simulation): void {
  const { bodies, contacts, pairs } = simulation
  const { asleep } = bodies
  simulation.cramped--
  for (let rounds = ROOM_ROUNDS; rounds > 0; rounds--) {
    updatePairs(simulation, pairs)
    // What has grown into a sleeper, or was pushed into one, wakes it.
    if (bodies.awakeCount < pairs.sorted) wakeStruck(simulation)
    // New pairs may have needed new arrays.
    const { pair } = contacts
    const list: Int32Array = new Int32Array(contacts.count)
    let count = 0
    for (let c = 0; c < contacts.count; c++)
      if (pair[2 * c + 1] > 0 && asleep[pair[2 * c]] + asleep[pair[2 * c + 1]] === 0) list[count++] = c
    if (!straighten(simulation, list, count)) {
      simulation.cramped = 0
      return
    }
    // A row between two walls that come nearer has room upwards only.
    liftWedged(simulation, list, 0, count)
  }
}

// Waking -----------------------------------------------------------------------------------------------------------------

/** Wakes body `i` and everything that carries it or is carried by it, at any remove. */
export function wake(scene: Scene, i: number): void {
  const { bodies, contacts } = scene
  bodies.rest[i * 4 + 3] = 0
  if (bodies.asleep[i] === 0) return
  rouse(bodies, i)
  for (let n = bodies.awakeCount - 1; n < bodies.awakeCount; n++) {
    for (let edge = contacts.head[bodies.awake[n]]; edge >= 0; edge = contacts.next[edge]) {
      const j = contacts.pair[edge ^ 1]
      if (bodies.asleep[j] === 1 && loadOf(contacts, edge >> 1) > 0) rouse(bodies, j)
    }
  }
}

export function rouse(bodies: Bodies, i: number): void {
  bodies.asleep[i] = 0
  bodies.rest[i * 4 + 3] = 0
  bodies.jams[i] = 0
  bodies.undrawn[i] = 1
  bodies.awake[bodies.awakeCount++] = i
  bodies.before.set(bodies.state.subarray(i * STATE + X, i * STATE + ANGLE + 1), i * 3)
}

/** Wakes body `i` and all that touch it, whether they carry anything or not. */
export function disturb(scene: Scene, i: number): void {
  const { contacts } = scene
  wake(scene, i)
  for (let edge = contacts.head[i]; edge >= 0; edge = contacts.next[edge]) {
    if (contacts.data[(edge >> 1) * CONTACT + POINTS] > 0) wake(scene, contacts.pair[edge ^ 1])
  }
}

/** Wakes the sleepers that an awake body is about to hit. One that merely lies against them wakes nobody. */
function wakeStruck(scene: Scene): void {
  const { bodies, contacts, gravity } = scene
  for (let n = 0; n < bodies.awakeCount; n++) {
    const i = bodies.awake[n]
    for (let edge = contacts.head[i]; edge >= 0; edge = contacts.next[edge]) {
      const j = contacts.pair[edge ^ 1]
      if (bodies.asleep[j] === 0) continue
      const c = edge >> 1
      const go = speedOf(bodies, i) * STEP + 0.5 * Math.abs(gravity) * STEP * STEP
      if (gapBound(scene, c) > go + MARGIN) continue
      touch[WIDEST] = go + MARGIN
      measure(scene, c)
      scene.work[MEASURED]++
      for (let p = c * CONTACT, n = touch[COUNT]; n > 0; n--, p += SECOND) {
        probe(scene, c, p)
        if (touch[GAP_NOW] < -4 * SLOP || touch[RATE_NOW] < -IMPACT_SPREAD) wake(scene, j)
      }
    }
  }
}

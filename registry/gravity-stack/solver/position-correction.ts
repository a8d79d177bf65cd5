import { extents, halfExtents, isStatic, speedOf } from './body'
import {
  CORRECTION,
  CORRECTIONS,
  DEEP_OVERLAP,
  LINEAR_SLOP,
  MAX_CORRECTION,
  REST_DISTANCE,
  REST_TIME,
  SLOW_CONTACT,
  STEP,
  WALL_OVERLAP,
} from './constants'
import { gapOf, separationAndRate } from './contact'
import { updateEntry } from './entry'
import { GAP_NOW, manifold, RATE_NOW } from './manifold'
import {
  ANGLE,
  ARM_NA,
  CONTACT,
  DEEP_STEPS,
  FIRST_CHIP,
  INV_INERTIA,
  INV_MASS,
  NORMAL_X,
  NORMAL_Y,
  SECOND,
  type Simulation,
  STATE,
  X,
  Y,
} from './state'

/**
 * The body of contact `c` that a correction leaves in place, or -1: the lower one, if it was lifted. So what
 * lies on it goes up with it and does not press it back.
 */
function fixedBody({ bodies, contacts }: Simulation, c: number): number {
  const { immovable, lifted, state } = bodies
  const a = contacts.pair[2 * c]
  const b = contacts.pair[2 * c + 1]
  const lower = state[a * STATE + Y] > state[b * STATE + Y] ? a : b
  const upper = a + b - lower
  return lifted[lower] > lifted[upper] && immovable[upper] === 0 && !isStatic(bodies, upper) ? lower : -1
}

/**
 * Position correction pushes overlapping poses apart and never touches a velocity, so that it adds no energy.
 * This is one for the point at place `p` of contact `c`; returns whether its overlap was deep. What a deep
 * one moves has changed in this `turn`.
 */
function correctPoint(simulation: Simulation, c: number, p: number, turn: number): boolean {
  const gap = manifold[GAP_NOW] + LINEAR_SLOP
  if (gap > 0) return false
  const { bodies, contacts } = simulation
  const { state: s, changed, immovable } = bodies
  const d = contacts.data
  const k = c * CONTACT
  const fixed = fixedBody(simulation, c)
  let inverseMass = 0
  for (let side = 0; side < 2; side++) {
    const i = contacts.pair[2 * c + side]
    if (i === fixed) continue
    const arm = d[p + ARM_NA + side]
    inverseMass += (1 - immovable[i]) * (s[i * STATE + INV_MASS] + s[i * STATE + INV_INERTIA] * arm * arm)
  }
  const push = Math.min(-CORRECTION * gap, MAX_CORRECTION) / inverseMass
  for (let side = 0; side < 2; side++) {
    const i = contacts.pair[2 * c + side]
    if (immovable[i] > 0 || i === fixed) continue
    if (gap < -DEEP_OVERLAP) changed[i] = turn
    if (fixed >= 0) bodies.lifted[i] = 1
    const by = side > 0 ? push : -push
    s[i * STATE + X] += d[k + NORMAL_X] * s[i * STATE + INV_MASS] * by
    s[i * STATE + Y] += d[k + NORMAL_Y] * s[i * STATE + INV_MASS] * by
    s[i * STATE + ANGLE] += s[i * STATE + INV_INERTIA] * d[p + ARM_NA + side] * by
  }
  return gap < -DEEP_OVERLAP
}

/**
 * Corrects the point that `separationAndRate` looked at before a sub-step, unless its bodies part by
 * themselves.
 */
export function correctEarly(simulation: Simulation, c: number, p: number): void {
  if (manifold[GAP_NOW] + LINEAR_SLOP + manifold[RATE_NOW] * simulation.h > 0) return
  correctPoint(simulation, c, p, 0)
}

/**
 * Corrects the live contacts once, in `pass` 0; in later passes those of which a deep correction has moved a
 * body since their last turn. Returns whether one of those that must separate was deep.
 */
export function correctPositions(simulation: Simulation, pass: number): boolean {
  const { live, liveCount, pair, points } = simulation.contacts
  const { changed, immovable } = simulation.bodies
  if (pass === 0) changed.fill(0)
  let deep = false
  for (let n = 0; n < liveCount; n++) {
    const c = live[n]
    const a = pair[2 * c]
    const b = pair[2 * c + 1]
    // Skipped, as in `iterate`, unless a body changed since the contact's last turn.
    const turn = pass * liveCount + n + 1
    const last = turn - liveCount
    if ((immovable[a] & immovable[b]) > 0 || ((changed[a] - last) & (changed[b] - last)) < 0) continue
    for (let p = c * CONTACT, m = points[c]; m > 0; m--, p += SECOND) {
      separationAndRate(simulation, c, p)
      if (correctPoint(simulation, c, p, turn) && mustSeparate(simulation, c)) deep = true
    }
  }
  return deep
}

/**
 * Corrects all contacts once, then slow bodies alone while slow contacts overlap deeply: a jam comes apart.
 * Fast bodies keep their poses in these passes, or the pile would be stirred.
 */
export function correctOverlaps(simulation: Simulation): void {
  const { bodies } = simulation
  const { awake, awakeCount, immovable } = bodies
  let deep = correctPositions(simulation, 0)
  if (deep) {
    immovable.fill(1)
    for (let n = 0; n < awakeCount; n++)
      if (speedOf(bodies, awake[n]) <= SLOW_CONTACT) immovable[awake[n]] = 0
    for (let n = 1; n <= CORRECTIONS && deep; n++) deep = correctPositions(simulation, n)
    immovable.fill(0)
  }
  if (deep) liftWedged(simulation)
  else bodies.lifted.fill(0)
}

/** Whether a deep overlap of contact `c` must go: its bodies are slow, or room is being made. */
function mustSeparate({ bodies, contacts, roomSteps }: Simulation, c: number): boolean {
  const speed = speedOf(bodies, contacts.pair[2 * c]) + speedOf(bodies, contacts.pair[2 * c + 1])
  return roomSteps > 0 || speed <= SLOW_CONTACT
}

/**
 * Of the deepest overlap that lasts, lifts the higher chip, or the chip in an obstacle: only above is there
 * room. Chips on top of one another overlap by more before one is lifted, as the weight above presses them.
 */
export function liftWedged(simulation: Simulation): void {
  const { bodies, contacts, roomSteps } = simulation
  const { density, lifted, state } = bodies
  const { data, live, liveCount, pair } = contacts
  let deepest = 0
  let higher = -1
  let lower = -1
  for (let n = 0; n < liveCount; n++) {
    const c = live[n]
    const k = c * CONTACT
    const a = pair[2 * c]
    const b = pair[2 * c + 1]
    const gap = gapOf(simulation, c)
    data[k + DEEP_STEPS] = gap < -DEEP_OVERLAP && mustSeparate(simulation, c) ? data[k + DEEP_STEPS] + 1 : 0
    if (a < FIRST_CHIP || (roomSteps === 0 && data[k + DEEP_STEPS] <= REST_TIME / STEP)) continue
    const isLevel = Math.abs(data[k + NORMAL_X]) > Math.abs(data[k + NORMAL_Y])
    if (gap >= Math.min(deepest, isLevel ? -DEEP_OVERLAP : -REST_DISTANCE)) continue
    deepest = gap
    higher = density[a] < Infinity && state[a * STATE + Y] < state[b * STATE + Y] ? a : b
    lower = a + b - higher
  }
  lifted.fill(0)
  if (higher < 0) return
  let lift = REST_DISTANCE
  if (density[lower] === Infinity) {
    // The chip goes up to the obstacle's top at once: from inside, the obstacle could push it back down.
    lift = state[higher * STATE + Y] - state[lower * STATE + Y]
    for (const i of [higher, lower]) {
      halfExtents(bodies, i, 0, 0)
      lift += extents[Y]
    }
  }
  lifted[higher] = 1
  state[higher * STATE + Y] -= lift
}

/** Puts chips that were pressed into a wall back inside, and notes chips that have entered the stage. */
export function keepInside(simulation: Simulation): void {
  const { bodies, ceiling, width, height } = simulation
  const { inside, state, awake, awakeCount } = bodies
  for (let n = 0; n < awakeCount; n++) {
    const i = awake[n]
    const s = i * STATE
    halfExtents(bodies, i, WALL_OVERLAP, 0)
    state[s + X] = Math.max(extents[X], Math.min(state[s + X], width - extents[X]))
    state[s + Y] = Math.min(
      ceiling && inside[i] ? Math.max(state[s + Y], extents[Y]) : state[s + Y],
      height - extents[Y],
    )
    if (!inside[i]) updateEntry(simulation, i)
  }
}

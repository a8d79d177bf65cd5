import { updateRotation } from './math'
import {
  type Bodies,
  CORE,
  COS,
  EXTENT,
  HX,
  HY,
  INV_INERTIA,
  INV_MASS,
  MOTION,
  RADIUS,
  ROTATED_TO,
  SHAPE,
  SIN,
  SPIN,
  STATE,
  VX,
  VY,
  X,
  Y,
} from './state'

/**
 * Sets the shape of body `i` from its outer size and corner radius (px), and its mass from its area. Area and
 * second moment are the rounded rectangle's own: core, four slabs and four quarter discs.
 */
export function setShape(
  { shape, state }: Bodies,
  i: number,
  width: number,
  height: number,
  radius: number,
  density: number,
): void {
  const r = Math.max(0, Math.min(radius, width / 2, height / 2))
  const hx = width / 2 - r
  const hy = height / 2 - r
  const xx = hx * hx
  const yy = hy * hy
  const core = Math.sqrt(xx + yy)
  shape.set([hx, hy, r, core + r, core], i * SHAPE)
  // The four corners together are one disc.
  const rr = r * r
  const corner = Math.PI * rr
  const area = 4 * (hx * hy + hx * r + hy * r) + corner
  // ∫x²+y² over the core, over the slabs left and right, above and below, and over the corners.
  const inner = (4 * hx * hy * (xx + yy)) / 3
  const sides = 4 * r * hy * ((yy + rr / 4) / 3 + (hx + r / 2) * (hx + r / 2))
  const caps = 4 * r * hx * ((xx + rr / 4) / 3 + (hy + r / 2) * (hy + r / 2))
  // A quarter disc's centre of area lies 4r/3π from its corner along each axis.
  const corners = corner * (xx + yy + rr / 2) + (8 * rr * r * (hx + hy)) / 3
  state[i * STATE + INV_MASS] = 1 / (density * area)
  state[i * STATE + INV_INERTIA] = 1 / (density * (inner + sides + caps + corners))
}

/** Puts body `i` at a pose, as if it had always been there. */
export function setPose(bodies: Bodies, i: number, x: number, y: number, angle: number): void {
  bodies.state.set([x, y, angle], i * STATE)
  bodies.before.set([x, y, angle], i * 3)
  bodies.rest.set([x, y, angle, 0], i * 4)
  bodies.motion[i * MOTION + ROTATED_TO] = Number.NaN
}

/**
 * Whether nothing moves body `i`: floor, walls, ceiling, obstacles, and chips on their way into a stage that
 * pulls aside.
 */
export function isStatic({ state }: Bodies, i: number): boolean {
  return state[i * STATE + INV_MASS] === 0
}

/** Whether body `i` is an obstacle: it stays where it is put, and what it is put on moves aside. */
export function isObstacleBody({ density }: Bodies, i: number): boolean {
  return density[i] === Infinity
}

/** px, half the width and half the height of the box around the body that `halfExtents` looked at. */
export const extents: Float64Array = new Float64Array(2)

/**
 * Leaves in `extents` how far body `i`, `inset` px thinner all round, reaches, or would turned by `swing` px
 * more.
 */
export function halfExtents(bodies: Bodies, i: number, inset: number, swing: number): void {
  const { motion, shape } = bodies
  updateRotation(bodies, i)
  const c = Math.abs(motion[i * MOTION + COS])
  const n = Math.abs(motion[i * MOTION + SIN])
  const hx = shape[i * SHAPE + HX]
  const hy = shape[i * SHAPE + HY]
  const core = shape[i * SHAPE + CORE]
  const r = shape[i * SHAPE + RADIUS] - inset
  extents[X] = Math.min(core, hx * c + hy * n + swing) + r
  extents[Y] = Math.min(core, hx * n + hy * c + swing) + r
}

/** px/s, bound of the speed of the fastest point of body `i`. */
export function speedOf({ state, shape }: Bodies, i: number): number {
  const s = i * STATE
  return (
    Math.abs(state[s + VX]) + Math.abs(state[s + VY]) + shape[i * SHAPE + EXTENT] * Math.abs(state[s + SPIN])
  )
}

/** Keeps the body at place `s` of `state` from moving faster than `most` px/s. */
export function capSpeed(state: Float64Array, s: number, most: number): void {
  const share = most / Math.sqrt(state[s + VX] * state[s + VX] + state[s + VY] * state[s + VY])
  if (share < 1) {
    state[s + VX] *= share
    state[s + VY] *= share
  }
}

import { IMPACT_TOLERANCE } from './constants'
import { updateRotation } from './math'
import { type Bodies, COS, HX, HY, MOTION, RADIUS, SHAPE, SIN, STATE, VX, VY, X, Y } from './state'

/**
 * Two shapes in, contact points out. Both go through `manifold`, which the next call uses again: numbers
 * handed over as arguments or results would be boxed.
 *
 * The normal points from A to B. Each point lies on both surfaces: an arm leads from each body's centre to
 * its own surface, and the separation along the normal is negative where the two overlap.
 */
export const manifold: Float64Array = new Float64Array(21)
/**
 * px, from the centre of A to its surface, of B to its surface; separation; feature. Then the same of a
 * second point.
 */
export const ARM_AX = 0
export const ARM_AY = 1
export const ARM_BX = 2
export const ARM_BY = 3
export const GAP = 4
export const FEATURE = 5
export const POINT = 6
export const MANIFOLD_NX = 12
export const MANIFOLD_NY = 13
/** Points made. */
export const COUNT = 14
/** px, distance of the shapes; a lower bound of it when it is more than `WIDEST`. */
export const DISTANCE = 15
/** px, the widest separation that still makes a point: set before a call. */
export const WIDEST = 16
/** s that a chip is turned ahead before it is measured at a wall: set before a call of `updateContact`. */
export const LEAD = 17
/** px and px/s, separation of a point and the rate at which it opens, left by `separationAndRate`. */
export const GAP_NOW = 18
export const RATE_NOW = 19
/**
 * px by which the two facing sides overlap, seen along the relative motion of the bodies: that much farther
 * apart they would miss. Infinite where the motion is neither along nor against the face.
 */
export const ACROSS = 20

/** px, distance of the cores along the face normals of one of them, its x axis first. */
const faceGaps: Float64Array = new Float64Array(2)

/**
 * Measures the core of body `i` from the faces of body `r`. A side of no length, of a pill or disc, is no
 * face.
 */
function measureFaces({ state, motion, shape }: Bodies, r: number, i: number): number {
  const rc = motion[r * MOTION + COS]
  const rn = motion[r * MOTION + SIN]
  const ic = motion[i * MOTION + COS]
  const inn = motion[i * MOTION + SIN]
  const hx = shape[i * SHAPE + HX]
  const hy = shape[i * SHAPE + HY]
  const px = state[i * STATE + X] - state[r * STATE + X]
  const py = state[i * STATE + Y] - state[r * STATE + Y]
  const c = Math.abs(rc * ic + rn * inn)
  const n = Math.abs(rc * inn - rn * ic)
  const rhx = shape[r * SHAPE + HX]
  const rhy = shape[r * SHAPE + HY]
  faceGaps[X] = rhy > 0 ? Math.abs(px * rc + py * rn) - rhx - hx * c - hy * n : -Infinity
  faceGaps[Y] = rhx > 0 ? Math.abs(py * rc - px * rn) - rhy - hx * n - hy * c : -Infinity
  return Math.max(faceGaps[X], faceGaps[Y])
}

/**
 * Leaves in `manifold` the distance of bodies `a` and `b`, and their contact points where these are at most
 * `WIDEST` apart. Exact for rounded boxes of any size: separating axes of the cores, then the features that
 * face each other.
 */
export function collide(bodies: Bodies, a: number, b: number): void {
  const { state, motion, shape } = bodies
  manifold[COUNT] = 0
  updateRotation(bodies, a)
  updateRotation(bodies, b)
  const radiusA = shape[a * SHAPE + RADIUS]
  const radiusB = shape[b * SHAPE + RADIUS]
  const gapB = measureFaces(bodies, b, a)
  const gapA = measureFaces(bodies, a, b)
  const onA = gapB <= gapA + 1e-3
  const best = onA ? gapA : gapB
  // Reference body R has the face, incident body I the side that faces it most; all is seen from the centre
  // of R.
  const r = onA ? a : b
  const i = onA ? b : a
  if (!onA) measureFaces(bodies, r, i)
  const onX = faceGaps[X] >= faceGaps[Y] && best > -Infinity
  const rhx = shape[r * SHAPE + HX]
  const rhy = shape[r * SHAPE + HY]
  const ihx = shape[i * SHAPE + HX]
  const ihy = shape[i * SHAPE + HY]
  manifold[DISTANCE] = best - radiusA - radiusB
  // Cores without an inside, of pills and discs, need their closest points even to know their distance.
  const thin = rhx * rhy === 0 && ihx * ihy === 0
  if (!thin && manifold[DISTANCE] > manifold[WIDEST]) return

  const sign = onA ? 1 : -1
  const ox = state[i * STATE + X] - state[r * STATE + X]
  const oy = state[i * STATE + Y] - state[r * STATE + Y]
  const rc = motion[r * MOTION + COS]
  const rn = motion[r * MOTION + SIN]
  const ic = motion[i * MOTION + COS]
  const inn = motion[i * MOTION + SIN]
  // Face normal f, outward from R towards I, and the face's half length u along its tangent.
  let fx = onX ? rc : -rn
  let fy = onX ? rn : rc
  if (fx * ox + fy * oy < 0) {
    fx = -fx
    fy = -fy
  }
  const depth = onX ? rhx : rhy
  const half = onX ? rhy : rhx
  const ux = -fy * half
  const uy = fx * half
  // Incident side, of a segment a long one: its outward normal is the one most against f. Middle m, half
  // length e.
  const fi = fx * ic + fy * inn
  const gi = fy * ic - fx * inn
  const useX = ihy > 0 && (ihx === 0 || Math.abs(fi) > Math.abs(gi))
  const k = useX ? (fi > 0 ? -ihx : ihx) : gi > 0 ? -ihy : ihy
  const ax = useX ? ic : -inn
  const ay = useX ? inn : ic
  const long = useX ? ihy : ihx
  const mx = ox + k * ax
  const my = oy + k * ay
  let ex = -ay * long
  let ey = ax * long
  const vx = state[b * STATE + VX] - state[a * STATE + VX]
  const vy = state[b * STATE + VY] - state[a * STATE + VY]
  const speed = Math.sqrt(vx * vx + vy * vy)
  const head = Math.abs(fx * vx + fy * vy)
  const along = Math.abs(fx * vy - fy * vx)
  const halves = Math.abs(ex * vy - ey * vx) + half * head
  const centres = Math.abs((mx - fx * depth) * vy - (my - fy * depth) * vx)
  const slanted = Math.min(head, along) > IMPACT_TOLERANCE * speed
  manifold[ACROSS] = slanted ? Infinity : radiusA + radiusB + (halves - centres) / speed
  let nx = fx
  let ny = fy
  // Places on the two sides, from -1 to 1, that are nearest; not known where the cores overlap.
  let s = 0
  const deepest = ex * fx + ey * fy > 0 ? -1 : 1
  let t = deepest
  const known = best > 0 || thin
  if (known) {
    // Closest points of the sides f·depth ± u and m ± e, in units of their half lengths.
    const wx = mx - fx * depth
    const wy = my - fy * depth
    const invU = half > 0 ? 1 / (half * half) : 0
    const invE = long > 0 ? 1 / (long * long) : 0
    const ue = ux * ex + uy * ey
    const uw = ux * wx + uy * wy
    const ew = ex * wx + ey * wy
    // The squared sine of the angle between the two: parallel sides have no one place that is nearest.
    const det = 1 - ue * ue * invU * invE
    s = uw * invU
    if (det > 1e-9 && invE > 0) s = (s - ue * ew * invU * invE) / det
    // Segments that cross at a right angle are measured at the end that is deeper.
    t = best < -1e-6 && det > 0.999999 ? deepest : clampToUnit((ue * clampToUnit(s) - ew) * invE)
    s = clampToUnit((uw + ue * t) * invU)
    const dx = wx + ex * t - ux * s
    const dy = wy + ey * t - uy * s
    const distance = Math.sqrt(dx * dx + dy * dy)
    // Two corners have a normal of their own only where the line between them leaves the face.
    const corners = (half === 0 || isEnd(s)) && (long === 0 || isEnd(t))
    if (corners && distance > Math.max(best, 0) + 1e-9) {
      nx = dx / distance
      ny = dy / distance
      // A motion along the face sees both sides edge on: the distance of the two corners counts instead.
      if (!slanted && along > head) manifold[ACROSS] = radiusA + radiusB - Math.abs(dx * vy - dy * vx) / speed
    }
  }
  manifold[MANIFOLD_NX] = sign * nx
  manifold[MANIFOLD_NY] = sign * ny
  // Seen along the normal both sides are intervals: the two touch where these overlap, and at the nearest
  // point.
  const cu = depth * (fy * nx - fx * ny)
  const un = uy * nx - ux * ny
  const ce = my * nx - mx * ny
  let en = ey * nx - ex * ny
  if (en < 0) {
    ex = -ex
    ey = -ey
    en = -en
    t = -t
  }
  const nearest = ce + t * en
  let low = Math.max(cu - un, ce - en)
  let high = Math.min(cu + un, ce + en)
  const single = high - low < 1e-6
  if (known) {
    low = Math.min(low, nearest)
    high = Math.max(high, nearest)
  }
  const side = (onA ? 0 : 4) + (onX ? 0 : 2)
  manifold[DISTANCE] = Infinity
  for (let n = 0; n < (single ? 1 : 2); n++) {
    if (!single) t = ((n > 0 ? high : low) - ce) / en
    if (un > 1e-9) s = (ce + t * en - cu) / un
    const rx = fx * depth + ux * s
    const ry = fy * depth + uy * s
    const ix = mx + ex * t
    const iy = my + ey * t
    const gap = (ix - rx) * nx + (iy - ry) * ny - radiusA - radiusB
    manifold[DISTANCE] = Math.min(manifold[DISTANCE], gap)
    if (gap > manifold[WIDEST]) continue
    const p = manifold[COUNT]++ * POINT
    manifold[p + ARM_AX] = (onA ? rx : ix - ox) + radiusA * sign * nx
    manifold[p + ARM_AY] = (onA ? ry : iy - oy) + radiusA * sign * ny
    manifold[p + ARM_BX] = (onA ? ix - ox : rx) - radiusB * sign * nx
    manifold[p + ARM_BY] = (onA ? iy - oy : ry) - radiusB * sign * ny
    manifold[p + GAP] = gap
    manifold[p + FEATURE] = (isEnd(t) ? 12 - side : side) + n
  }
}

/**
 * Whether a place on a side is an end of it. Compared with a fraction: places would seem whole numbers at
 * first.
 */
function isEnd(t: number): boolean {
  return Math.abs(t) > 0.999999
}

function clampToUnit(t: number): number {
  return t > 1 ? 1 : Math.max(t, -1)
}

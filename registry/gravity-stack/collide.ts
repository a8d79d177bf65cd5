import {
  type Bodies,
  COS,
  farWall,
  HX,
  HY,
  MOTION,
  RADIUS,
  SHAPE,
  SIN,
  STATE,
  turn,
  VX,
  VY,
  X,
  Y,
} from './body'
import { GRAZE_SLOPE } from './constants'

/**
 * Two shapes in, contact points out. The result is left in `touch`, which is used again by the next call.
 *
 * The normal points from A to B. Each point lies on both surfaces: its arms are given from each body's own centre to
 * its own surface, its separation along the normal is negative where they overlap. Its feature says which corner made it.
 *
 * In and out through arrays: numbers handed over as arguments would be boxed.
 */
export const touch: Float64Array = new Float64Array(21)
/** px; from the centre of A to its surface, of B to its surface, separation, feature; then the same of a second point. */
export const AX = 0
export const AY = 1
export const BX = 2
export const BY = 3
export const GAP = 4
export const FEATURE = 5
export const POINT = 6
export const NORMAL_X = 12
export const NORMAL_Y = 13
/** Points made. */
export const COUNT = 14
/** px, distance of the shapes; a lower bound of it when it is more than the widest. */
export const DISTANCE = 15
/** px, the widest gap that still makes a contact point; to be set before a call. */
export const WIDEST = 16
/** s, how far ahead a chip's rotation is taken when it meets a wall; to be set before a call. */
export const LEAD = 17
/** px and px/s, gap of a point and the rate at which it opens, left by `probe`. */
export const GAP_NOW = 18
export const RATE_NOW = 19
/**
 * px by which the two facing sides overlap, seen along the relative motion of the bodies: that much farther apart they would
 * miss. Infinite where the motion is neither along nor against the face.
 */
export const ACROSS = 20

/** px² and px below which a direction is no direction. */
const TINY = 1e-12

/** Moves the points from the cores to the surfaces. */
function finish(shape: Float64Array, a: number, b: number): void {
  const ra = shape[a * SHAPE + RADIUS]
  const rb = shape[b * SHAPE + RADIUS]
  for (let k = 0; k < touch[COUNT] * POINT; k += POINT) {
    touch[k + AX] += ra * touch[NORMAL_X]
    touch[k + AY] += ra * touch[NORMAL_Y]
    touch[k + BX] -= rb * touch[NORMAL_X]
    touch[k + BY] -= rb * touch[NORMAL_Y]
  }
}

/**
 * Distance of the shapes of bodies `a` and `b` in `touch`, and their contact points where these are at most
 * `WIDEST` apart. Exact for rounded boxes of any size: separating axes of the cores, then the features that face each other.
 */
export function collide(bodies: Bodies, a: number, b: number): void {
  const { state, motion, shape } = bodies
  touch[COUNT] = 0
  turn(state, motion, a)
  turn(state, motion, b)
  const hxa = shape[a * SHAPE + HX]
  const hya = shape[a * SHAPE + HY]
  const hxb = shape[b * SHAPE + HX]
  const hyb = shape[b * SHAPE + HY]
  const ra = shape[a * SHAPE + RADIUS]
  const rb = shape[b * SHAPE + RADIUS]
  const radii = ra + rb
  const ca = motion[a * MOTION + COS]
  const na = motion[a * MOTION + SIN]
  const cb = motion[b * MOTION + COS]
  const nb = motion[b * MOTION + SIN]
  const px = state[b * STATE + X] - state[a * STATE + X]
  const py = state[b * STATE + Y] - state[a * STATE + Y]
  // Rotation of B seen from A.
  const c = ca * cb + na * nb
  const n = ca * nb - na * cb
  const absC = c < 0 ? -c : c
  const absN = n < 0 ? -n : n
  // Offset of B's centre along the axes of A, and along the axes of B.
  const pax = px * ca + py * na
  const pay = py * ca - px * na
  const pbx = px * cb + py * nb
  const pby = py * cb - px * nb
  // A side of no length (of a pill or disc) is no face; two discs have none at all.
  let best = -Infinity
  let axis = 1
  if (hya > 0) {
    best = Math.abs(pax) - hxa - hxb * absC - hyb * absN
    axis = 0
  }
  if (hxa > 0) {
    const d = Math.abs(pay) - hya - hxb * absN - hyb * absC
    if (d > best) {
      best = d
      axis = 1
    }
  }
  if (hyb > 0) {
    const d = Math.abs(pbx) - hxb - hxa * absC - hya * absN
    if (d > best + 1e-3) {
      best = d
      axis = 2
    }
  }
  if (hxb > 0) {
    const d = Math.abs(pby) - hyb - hxa * absN - hya * absC
    if (d > best + (axis < 2 ? 1e-3 : 0)) {
      best = d
      axis = 3
    }
  }
  touch[DISTANCE] = best - radii
  // Of pills and discs the closest points are found anyway.
  const thin = hxa * hya === 0 && hxb * hyb === 0
  if (!thin && touch[DISTANCE] > touch[WIDEST]) return

  // Reference R with the face, incident I with the side that faces it most; everything from R's centre.
  const onA = axis < 2
  const sign = onA ? 1 : -1
  const ox = onA ? px : -px
  const oy = onA ? py : -py
  const rc = onA ? ca : cb
  const rn = onA ? na : nb
  const ic = onA ? cb : ca
  const inn = onA ? nb : na
  const rhx = onA ? hxa : hxb
  const rhy = onA ? hya : hyb
  const ihx = onA ? hxb : hxa
  const ihy = onA ? hyb : hya
  const onX = axis === 0 || axis === 2
  // Face normal f (outward from R towards I) and face tangent g = f turned by +90°.
  let fx = onX ? rc : -rn
  let fy = onX ? rn : rc
  if (fx * ox + fy * oy < 0) {
    fx = -fx
    fy = -fy
  }
  const gx = -fy
  const gy = fx
  const depth = onX ? rhx : rhy
  const half = onX ? rhy : rhx
  // Incident side: the one whose outward normal is most against f.
  const fi = fx * ic + fy * inn
  const gi = fy * ic - fx * inn
  // A core that is a segment has only its long sides, a point has none.
  const useX = ihy === 0 ? false : ihx === 0 ? true : Math.abs(fi) > Math.abs(gi)
  let ex: number
  let ey: number
  let mx: number
  let my: number
  if (useX) {
    const k = fi > 0 ? -ihx : ihx
    mx = ox + k * ic
    my = oy + k * inn
    ex = -inn * ihy
    ey = ic * ihy
  } else {
    const k = gi > 0 ? -ihy : ihy
    mx = ox - k * inn
    my = oy + k * ic
    ex = ic * ihx
    ey = inn * ihx
  }
  // Both sides run along +g, so that the features keep their names.
  if (ex * gx + ey * gy < 0) {
    ex = -ex
    ey = -ey
  }
  const ee = ex * ex + ey * ey
  const invE = ee > 0 ? 1 / ee : 0
  const own = onA ? 0 : 4
  const other = onA ? 4 : 0
  const vx = state[b * STATE + VX] - state[a * STATE + VX]
  const vy = state[b * STATE + VY] - state[a * STATE + VY]
  const speed = Math.sqrt(vx * vx + vy * vy)
  const head = Math.abs(fx * vx + fy * vy)
  const side = Math.abs(gx * vx + gy * vy)
  const halves = Math.abs(ex * vy - ey * vx) + half * head
  const centres = Math.abs((mx - fx * depth) * vy - (my - fy * depth) * vx)
  const slanted = Math.min(head, side) > GRAZE_SLOPE * speed
  touch[ACROSS] = slanted ? Infinity : radii + (halves - centres) / speed
  const face = onX ? 0 : 2
  const mine = onA ? AX : BX
  const its = onA ? BX : AX

  // Where along the incident side it is nearest; not known where the cores overlap.
  let near = Number.NaN
  // Where the cores are apart, as two without an inside may be on every axis, the closest features may be two corners.
  if (best > 0 || thin) {
    // Closest points of the two sides, ±u and w ± e (after Ericson, Real-Time Collision Detection, 5.1.9).
    const ux = gx * half
    const uy = gy * half
    const wx = mx - fx * depth
    const wy = my - fy * depth
    const invU = half > 0 ? 1 / (half * half) : 0
    const ue = ux * ex + uy * ey
    const uw = ux * wx + uy * wy
    const ew = ex * wx + ey * wy
    // In units of the half lengths; det is the squared sine of the angle between the two.
    const det = 1 - ue * ue * invU * invE
    let s = uw * invU
    if (det > 1e-9 && invE > 0) s = (s - ue * ew * invU * invE) / det
    s = s > 1 ? 1 : Math.max(s, -1)
    let t = (ue * s - ew) * invE
    t = t > 1 ? 1 : Math.max(t, -1)
    near = t
    s = (uw + ue * t) * invU
    s = s > 1 ? 1 : Math.max(s, -1)
    if ((s === 1 || s === -1 || half === 0) && (t === 1 || t === -1 || invE === 0)) {
      const dx = wx + ex * t - ux * s
      const dy = wy + ey * t - uy * s
      const distance = Math.sqrt(dx * dx + dy * dy)
      // Two corners only if the line between them leaves the face: else the face's own normal is the same.
      if (distance > Math.max(best, 0) + 1e-9) {
        const nx = dx / distance
        const ny = dy / distance
        touch[NORMAL_X] = sign * nx
        touch[NORMAL_Y] = sign * ny
        touch[DISTANCE] = distance - radii
        // A motion along the face sees both sides edge on: the distance of the two corners counts instead.
        if (!slanted && side > head) touch[ACROSS] = radii - Math.abs(dx * vy - dy * vx) / speed
        // Seen along the normal the two sides may reach back beside each other: where the shorter one ends is a second point, as
        // what lies nearly in line may meet there next.
        const backU = s * (ux * ny - uy * nx)
        const backE = t * (ex * ny - ey * nx)
        const back = 2 * Math.min(Math.abs(backU), Math.abs(backE))
        let s2 = s
        let t2 = t
        for (let k = 0; k < 2; k++) {
          const rx = fx * depth + ux * s2
          const ry = fy * depth + uy * s2
          const qx = mx + ex * t2
          const qy = my + ey * t2
          const gap = (qx - rx) * nx + (qy - ry) * ny - radii
          if (gap > touch[WIDEST]) break
          const p = touch[COUNT]++ * POINT
          touch[p + mine] = rx
          touch[p + mine + 1] = ry
          touch[p + its] = qx - ox
          touch[p + its + 1] = qy - oy
          touch[p + GAP] = gap
          touch[p + FEATURE] = k === 0 || s2 === -s ? own + (s2 > 0 ? 1 : 0) : other + (t2 > 0 ? 1 : 0)
          if (!(backU * backE > 0)) break
          s2 *= 1 - back / Math.abs(backU)
          t2 *= 1 - back / Math.abs(backE)
        }
        finish(shape, a, b)
        return
      }
    }
  }

  touch[NORMAL_X] = sign * fx
  touch[NORMAL_Y] = sign * fy
  const mid = mx * gx + my * gy
  const span = ex * gx + ey * gy
  let lo = -1
  let hi = 1
  let loFeature = other + face
  let hiFeature = loFeature + 1
  if (span > TINY) {
    const endLo = (-half - mid) / span
    const endHi = (half - mid) / span
    if (endLo > lo) {
      lo = endLo
      loFeature = own + face
    }
    if (endHi < hi) {
      hi = endHi
      hiFeature = own + face + 1
    }
  }
  // Of an incident side that lies beyond the face its nearer end is all there is, and of a point the point. A side square to the face
  // may leave it by next to nothing: its end is not cut off.
  if (hi < lo || ee === 0) lo = hi = near >= -1 ? near : mid > 0 ? -1 : 1
  else if (near < lo) {
    lo = near
    loFeature = other + face
  } else if (near > hi) {
    hi = near
    hiFeature = other + face + 1
  }
  let least = Infinity
  for (let k = 0; k < 2; k++) {
    if (k === 1 && hi - lo < 1e-6) break
    const at = k === 0 ? lo : hi
    const qx = mx + at * ex
    const qy = my + at * ey
    const apart = fx * qx + fy * qy - depth
    const gap = apart - radii
    if (gap < least) least = gap
    if (gap > touch[WIDEST]) continue
    const p = touch[COUNT]++ * POINT
    touch[p + mine] = qx - fx * apart
    touch[p + mine + 1] = qy - fy * apart
    touch[p + its] = qx - ox
    touch[p + its + 1] = qy - oy
    touch[p + GAP] = gap
    touch[p + FEATURE] = k === 0 ? loFeature : hiFeature
  }
  touch[DISTANCE] = least
  finish(shape, a, b)
}

/** Floor at y = height, walls at x = 0 and x = width. */
export interface Walls {
  /** px, size of the stage. */
  width: number
  height: number
}

/**
 * Distance of body `b` from wall 1 (floor), 2 (left) or 3 (right), in `touch` like `collide`. The wall is shape A: its
 * normal points inwards, and as it never turns, its arms are left out.
 */
export function collideWall(bodies: Bodies, walls: Walls, b: number, wall: number): void {
  const { state, motion, shape } = bodies
  turn(state, motion, b)
  const floor = wall === 1
  const left = wall === 2
  const { width, height } = walls
  const nx = floor ? 0 : left ? 1 : -1
  const ny = floor ? -1 : 0
  const offset = -(floor ? height : left ? 0 : farWall(shape, b, width))
  touch.fill(0, 0, NORMAL_X)
  touch[COUNT] = 0
  touch[NORMAL_X] = nx
  touch[NORMAL_Y] = ny
  const c = motion[b * MOTION + COS]
  const s = motion[b * MOTION + SIN]
  const hx = shape[b * SHAPE + HX]
  const hy = shape[b * SHAPE + HY]
  const r = shape[b * SHAPE + RADIUS]
  // How much each half extent leans into the wall; the lowest corner leans with both.
  const lx = nx * c + ny * s
  const ly = ny * c - nx * s
  const deepX = lx > 0 ? -lx * hx : lx * hx
  const deepY = ly > 0 ? -ly * hy : ly * hy
  const gap = nx * state[b * STATE + X] + ny * state[b * STATE + Y] - offset - r + deepX + deepY
  touch[DISTANCE] = gap
  if (gap > touch[WIDEST]) return
  let x = lx > 0 ? -hx : hx
  let y = ly > 0 ? -hy : hy
  touch[COUNT] = 1
  touch[BX] = c * x - s * y
  touch[BY] = s * x + c * y
  touch[GAP] = gap
  touch[FEATURE] = (x > 0 ? 1 : 0) + (y > 0 ? 2 : 0)
  // The other end of the lower side, or of the long one, where the short is less than geometry may lag: a hair too high
  // for its corners a pill would stand on one end, and rock from it to the other.
  const flipX = Math.min(hx, hy) < 0.5 ? hx > hy : deepX > deepY
  const rise = gap - 2 * (flipX ? deepX : deepY)
  if ((flipX ? hx : hy) > 0 && rise <= touch[WIDEST]) {
    if (flipX) x = -x
    else y = -y
    touch[COUNT] = 2
    touch[POINT + BX] = c * x - s * y
    touch[POINT + BY] = s * x + c * y
    touch[POINT + GAP] = rise
    touch[POINT + FEATURE] = (x > 0 ? 1 : 0) + (y > 0 ? 2 : 0)
  }
  finish(shape, 0, b)
}

import { type Bodies, COS, HX, HY, INV_CORE2, MOTION, RADIUS, SHAPE, SIN, STATE, turn, X, Y } from './body'

/**
 * Two shapes in, contact points out. The result is left in `touch`, which is used again by the next call.
 *
 * The normal points from A to B. Each point lies on both surfaces: its arms are given from each body's own centre to
 * its own surface, its separation along the normal is negative where they overlap. Its feature says which corner made it.
 *
 * In and out through arrays: numbers handed over as arguments would be boxed.
 */
export const touch: Float64Array = new Float64Array(20)
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
 * `WIDEST` apart. Exact for rounded boxes of any size.
 */
export function collide(bodies: Bodies, a: number, b: number): void {
  const shape = bodies.shape
  const sa = a * SHAPE
  const sb = b * SHAPE
  touch[COUNT] = 0
  turn(bodies.state, bodies.motion, a)
  turn(bodies.state, bodies.motion, b)
  if ((shape[sa + HX] === 0 || shape[sa + HY] === 0) && (shape[sb + HX] === 0 || shape[sb + HY] === 0)) {
    collideSegments(bodies, a, b)
  } else collideBoxes(bodies, a, b)
}

/** Two segments, ±u and p ± v, and the parameters S and T, -1..1, of their closest points. */
const line: Float64Array = new Float64Array(10)
const PX = 0
const PY = 1
const UX = 2
const UY = 3
const EDGE_X = 4
const EDGE_Y = 5
/** Inverse squares of the half lengths; 0 for a point. */
const INV_UU = 6
const INV_VV = 7
const S = 8
const T = 9

/** Closest points of the segments in `line` (after Ericson, Real-Time Collision Detection, 5.1.9). */
function closest(): void {
  const ux = line[UX]
  const uy = line[UY]
  const vx = line[EDGE_X]
  const vy = line[EDGE_Y]
  const invU = line[INV_UU]
  const invV = line[INV_VV]
  const uv = ux * vx + uy * vy
  const up = ux * line[PX] + uy * line[PY]
  const vp = vx * line[PX] + vy * line[PY]
  // In units of the half lengths; det is the squared sine of the angle between the two.
  const det = 1 - uv * uv * invU * invV
  let s = up * invU
  if (det > 1e-9 && invV > 0) s = (s - uv * vp * invU * invV) / det
  s = s > 1 ? 1 : Math.max(s, -1)
  let t = (uv * s - vp) * invV
  t = t > 1 ? 1 : Math.max(t, -1)
  s = (up + uv * t) * invU
  line[S] = s > 1 ? 1 : Math.max(s, -1)
  line[T] = t
}

/**
 * Two segments that are nearest at their ends S and T, seen along the normal: whether they reach back beside each other. S and T
 * then are where the shorter one ends: what lies nearly in line may meet there next.
 */
function reachBack(): boolean {
  const nx = touch[NORMAL_X]
  const ny = touch[NORMAL_Y]
  const u = line[S] * (line[UX] * ny - line[UY] * nx)
  const v = line[T] * (line[EDGE_X] * ny - line[EDGE_Y] * nx)
  const back = 2 * Math.min(Math.abs(u), Math.abs(v))
  if (!(u * v > 0)) return false
  line[S] *= 1 - back / Math.abs(u)
  line[T] *= 1 - back / Math.abs(v)
  return true
}

/** Two pills (or discs): closest points, and a second point where they lie side by side. */
function collideSegments(bodies: Bodies, a: number, b: number): void {
  const { state, motion, shape } = bodies
  const hxa = shape[a * SHAPE + HX]
  const hya = shape[a * SHAPE + HY]
  const hxb = shape[b * SHAPE + HX]
  const hyb = shape[b * SHAPE + HY]
  const radii = shape[a * SHAPE + RADIUS] + shape[b * SHAPE + RADIUS]
  const ca = motion[a * MOTION + COS]
  const na = motion[a * MOTION + SIN]
  const cb = motion[b * MOTION + COS]
  const nb = motion[b * MOTION + SIN]
  const px = state[b * STATE + X] - state[a * STATE + X]
  const py = state[b * STATE + Y] - state[a * STATE + Y]
  // Half vectors of the two core segments; one along y belongs to a chip taller than wide.
  const ux = hya === 0 ? ca * hxa : -na * hya
  const uy = hya === 0 ? na * hxa : ca * hya
  const vx = hyb === 0 ? cb * hxb : -nb * hyb
  const vy = hyb === 0 ? nb * hxb : cb * hyb
  line[PX] = px
  line[PY] = py
  line[UX] = ux
  line[UY] = uy
  line[EDGE_X] = vx
  line[EDGE_Y] = vy
  line[INV_UU] = shape[a * SHAPE + INV_CORE2]
  line[INV_VV] = shape[b * SHAPE + INV_CORE2]
  closest()
  const s = line[S]
  const t = line[T]
  let nx = px + t * vx - s * ux
  let ny = py + t * vy - s * uy
  const square = nx * nx + ny * ny
  const distance = Math.sqrt(square)
  const gap = distance - radii
  touch[DISTANCE] = gap
  if (gap > touch[WIDEST]) return
  const uu = ux * ux + uy * uy
  const vv = vx * vx + vy * vy
  // The normal stands on the segment whose inside is nearest: the reference; the other one is cut to its length.
  let onA = uu > 0 && s > -1 && s < 1
  let onB = !onA && vv > 0 && t > -1 && t < 1
  const crossed = square < TINY
  if (crossed) {
    // Cores that cross part along the shorter way across one of them.
    const area = Math.abs(ux * vy - uy * vx)
    const acrossA = (area - Math.abs(ux * py - uy * px)) * Math.sqrt(vv)
    const acrossB = (area - Math.abs(vx * py - vy * px)) * Math.sqrt(uu)
    onA = uu > 0 && (vv === 0 || acrossA <= acrossB)
    onB = !onA && vv > 0
    const lx = onA ? ux : vx
    const ly = onA ? uy : vy
    const length = Math.sqrt(lx * lx + ly * ly)
    nx = length > 0 ? -ly / length : 0
    ny = length > 0 ? lx / length : -1
    if (nx * px + ny * py < 0) {
      nx = -nx
      ny = -ny
    }
  } else {
    const inverse = 1 / distance
    nx *= inverse
    ny *= inverse
  }
  touch[NORMAL_X] = nx
  touch[NORMAL_Y] = ny
  if (uu > 0 && vv > 0 && (onA || onB)) {
    const rx = onA ? ux : vx
    const ry = onA ? uy : vy
    const inverse = shape[(onA ? a : b) * SHAPE + INV_CORE2]
    const ix = onA ? vx : ux
    const iy = onA ? vy : uy
    const ox = onA ? px : -px
    const oy = onA ? py : -py
    // Along the reference, the other segment reaches from mid − half to mid + half.
    const mid = (rx * ox + ry * oy) * inverse
    const half = (rx * ix + ry * iy) * inverse
    const size = Math.abs(half)
    const way = half > 0 ? 1 : -1
    const own = onA ? 0 : 4
    const other = 4 - own
    let lo = -1
    let hi = 1
    let loFeature = other + (half > 0 ? 0 : 1)
    let hiFeature = other + (half > 0 ? 1 : 0)
    if (mid - size < -1 && size > TINY) {
      lo = (-1 - mid) / size
      loFeature = own
    }
    if (mid + size > 1 && size > TINY) {
      hi = (1 - mid) / size
      hiFeature = own + 1
    }
    if (hi - lo > 1e-6) {
      const sign = onA ? 1 : -1
      let least = Infinity
      for (let k = 0; k < 2; k++) {
        const at = k === 0 ? lo : hi
        const qx = ox + way * at * ix
        const qy = oy + way * at * iy
        const apart = sign * (qx * nx + qy * ny) - radii
        if (apart < least) least = apart
        if (apart > touch[WIDEST]) continue
        const along = mid + at * size
        const p = touch[COUNT]++ * POINT
        const mine = p + (onA ? AX : BX)
        const its = p + (onA ? BX : AX)
        touch[mine] = along * rx
        touch[mine + 1] = along * ry
        touch[its] = qx - ox
        touch[its + 1] = qy - oy
        touch[p + GAP] = apart
        touch[p + FEATURE] = k === 0 ? loFeature : hiFeature
      }
      if (crossed) touch[DISTANCE] = least
    }
  }
  if (touch[COUNT] === 0) {
    touch[COUNT] = 1
    touch[AX] = s * ux
    touch[AY] = s * uy
    touch[BX] = t * vx
    touch[BY] = t * vy
    touch[GAP] = gap
    touch[FEATURE] = onA ? (t > 0 ? 5 : 4) : s > 0 ? 1 : 0
    if (!onA && !onB && reachBack()) {
      const s2 = line[S]
      const t2 = line[T]
      const gap2 = (px + t2 * vx - s2 * ux) * nx + (py + t2 * vy - s2 * uy) * ny - radii
      if (gap2 <= touch[WIDEST]) {
        touch[COUNT] = 2
        touch[POINT + AX] = s2 * ux
        touch[POINT + AY] = s2 * uy
        touch[POINT + BX] = t2 * vx
        touch[POINT + BY] = t2 * vy
        touch[POINT + GAP] = gap2
        touch[POINT + FEATURE] = s2 === -s ? (s > 0 ? 0 : 1) : t > 0 ? 4 : 5
      }
    }
  }
  finish(shape, a, b)
}

/** Two rounded boxes, or one and a pill or disc: separating axes of the cores, then the features that face each other. */
function collideBoxes(bodies: Bodies, a: number, b: number): void {
  const { state, motion, shape } = bodies
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
  // A side of no length (of a pill or disc) is no face.
  let best = -Infinity
  let axis = 0
  if (hya > 0) {
    best = Math.abs(pax) - hxa - hxb * absC - hyb * absN
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
  if (touch[DISTANCE] > touch[WIDEST]) return

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
  const own = onA ? 0 : 4
  const other = onA ? 4 : 0
  const face = onX ? 0 : 2
  const mine = onA ? AX : BX
  const its = onA ? BX : AX

  // Where the cores are apart the closest features may be two corners.
  if (best > 0) {
    line[PX] = mx - fx * depth
    line[PY] = my - fy * depth
    line[UX] = gx * half
    line[UY] = gy * half
    line[EDGE_X] = ex
    line[EDGE_Y] = ey
    const ee = ex * ex + ey * ey
    line[INV_UU] = half > 0 ? 1 / (half * half) : 0
    line[INV_VV] = ee > 0 ? 1 / ee : 0
    closest()
    const s = line[S]
    const t = line[T]
    if ((s === 1 || s === -1) && (t === 1 || t === -1 || (ex === 0 && ey === 0))) {
      const rx = fx * depth + gx * half * s
      const ry = fy * depth + gy * half * s
      const dx = mx + ex * t - rx
      const dy = my + ey * t - ry
      const distance = Math.sqrt(dx * dx + dy * dy)
      // Two corners only if the line between them leaves the face: else the face's own normal is the same.
      if (distance > best + 1e-9) {
        const gap = distance - radii
        touch[DISTANCE] = gap
        if (gap > touch[WIDEST]) return
        touch[NORMAL_X] = (sign * dx) / distance
        touch[NORMAL_Y] = (sign * dy) / distance
        touch[COUNT] = 1
        touch[mine] = rx
        touch[mine + 1] = ry
        touch[its] = mx + ex * t - ox
        touch[its + 1] = my + ey * t - oy
        touch[GAP] = gap
        touch[FEATURE] = own + (s > 0 ? 1 : 0)
        if (reachBack()) {
          const rx2 = fx * depth + gx * half * line[S]
          const ry2 = fy * depth + gy * half * line[S]
          const qx2 = mx + ex * line[T]
          const qy2 = my + ey * line[T]
          const gap2 = ((qx2 - rx2) * dx + (qy2 - ry2) * dy) / distance - radii
          if (gap2 <= touch[WIDEST]) {
            touch[COUNT] = 2
            touch[POINT + mine] = rx2
            touch[POINT + mine + 1] = ry2
            touch[POINT + its] = qx2 - ox
            touch[POINT + its + 1] = qy2 - oy
            touch[POINT + GAP] = gap2
            touch[POINT + FEATURE] = line[S] === -s ? own + (s > 0 ? 0 : 1) : other + (t > 0 ? 0 : 1)
          }
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
  if (hi < lo) {
    // The incident side lies beyond the face: its nearer end is all there is.
    const end = mid > 0 ? -1 : 1
    lo = end
    hi = end
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
  const offset = -(floor ? height : left ? 0 : width)
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
  // The other end of the lower side.
  const flipX = hx > 0 && (hy === 0 || deepX > deepY)
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

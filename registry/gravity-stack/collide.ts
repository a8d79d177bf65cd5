import { type Bodies, COS, HX, HY, MOTION, RADIUS, SHAPE, SIN, STATE, turn, X, Y } from './body'

/**
 * Two shapes in, contact points out. The result is left in `touch`, which is used again by the next call.
 *
 * The normal points from A to B. Each point lies on both surfaces: its arms are given from each body's own centre to
 * its own surface, its separation along the normal is negative where they overlap. Its feature says which corner made it.
 */
export const touch = {
  count: 0,
  nx: 0,
  ny: 0,
  /** px; from the centre of A to its surface, of B to its surface, separation, feature. */
  points: new Float64Array(2 * 6),
}
export const AX = 0
export const AY = 1
export const BX = 2
export const BY = 3
export const GAP = 4
export const FEATURE = 5
export const POINT = 6

/** px² and px below which a direction is no direction. */
const TINY = 1e-12

/** Adds a point whose core points are (px, py) from A's centre and (qx, qy) from B's, with the radii of both. */
function addPoint(
  px: number,
  py: number,
  qx: number,
  qy: number,
  ra: number,
  rb: number,
  gap: number,
  feature: number,
): void {
  const k = touch.count++ * POINT
  const p = touch.points
  p[k + AX] = px + ra * touch.nx
  p[k + AY] = py + ra * touch.ny
  p[k + BX] = qx - rb * touch.nx
  p[k + BY] = qy - rb * touch.ny
  p[k + GAP] = gap
  p[k + FEATURE] = feature
}

/**
 * Distance of the shapes of bodies `a` and `b`, px, negative when they overlap; contact points up to `margin` apart.
 * Exact for rounded boxes of any size. Beyond `margin` the answer is a lower bound and there are no points.
 */
export function collide(bodies: Bodies, a: number, b: number, margin: number): number {
  const { state, motion, shape } = bodies
  turn(state, motion, a)
  turn(state, motion, b)
  touch.count = 0
  const sa = a * SHAPE
  const sb = b * SHAPE
  const px = state[b * STATE + X] - state[a * STATE + X]
  const py = state[b * STATE + Y] - state[a * STATE + Y]
  const ca = motion[a * MOTION + COS]
  const na = motion[a * MOTION + SIN]
  const cb = motion[b * MOTION + COS]
  const nb = motion[b * MOTION + SIN]
  const hxa = shape[sa + HX]
  const hya = shape[sa + HY]
  const hxb = shape[sb + HX]
  const hyb = shape[sb + HY]
  const ra = shape[sa + RADIUS]
  const rb = shape[sb + RADIUS]
  if ((hxa === 0 || hya === 0) && (hxb === 0 || hyb === 0)) {
    // Half vectors of the two core segments; one along y belongs to a chip taller than wide.
    const ux = hya === 0 ? ca * hxa : -na * hya
    const uy = hya === 0 ? na * hxa : ca * hya
    const vx = hyb === 0 ? cb * hxb : -nb * hyb
    const vy = hyb === 0 ? nb * hxb : cb * hyb
    return collideSegments(px, py, ux, uy, vx, vy, ra, rb, margin)
  }
  return collideBoxes(px, py, ca, na, hxa, hya, cb, nb, hxb, hyb, ra, rb, margin)
}

/** Parameters of the closest points of the segments ±u and p ± v. After Ericson, Real-Time Collision Detection, 5.1.9. */
const nearest = { s: 0, t: 0 }
function closest(px: number, py: number, ux: number, uy: number, vx: number, vy: number): void {
  const uu = ux * ux + uy * uy
  const vv = vx * vx + vy * vy
  const uv = ux * vx + uy * vy
  const up = ux * px + uy * py
  const vp = vx * px + vy * py
  const det = uu * vv - uv * uv
  let s = 0
  let t = 0
  if (uu > 0) {
    s = det > TINY * uu * vv ? (up * vv - uv * vp) / det : up / uu
    s = s > 1 ? 1 : s < -1 ? -1 : s
  }
  if (vv > 0) {
    t = (uv * s - vp) / vv
    t = t > 1 ? 1 : t < -1 ? -1 : t
  }
  if (uu > 0) {
    s = (up + uv * t) / uu
    s = s > 1 ? 1 : s < -1 ? -1 : s
  }
  nearest.s = s
  nearest.t = t
}

/** Two pills (or discs): closest points, and a second point where they lie side by side. */
function collideSegments(
  px: number,
  py: number,
  ux: number,
  uy: number,
  vx: number,
  vy: number,
  ra: number,
  rb: number,
  margin: number,
): number {
  closest(px, py, ux, uy, vx, vy)
  const s = nearest.s
  const t = nearest.t
  let dx = px + t * vx - s * ux
  let dy = py + t * vy - s * uy
  const far = ra + rb + margin
  const square = dx * dx + dy * dy
  if (square > far * far) return Math.sqrt(square) - ra - rb
  const distance = Math.sqrt(square)
  const uu = ux * ux + uy * uy
  const vv = vx * vx + vy * vy
  // The cores cross or touch: leave along the shorter way across one of them.
  const crossed = square < TINY
  let acrossA = s > -1 && s < 1 && uu > 0
  if (crossed) {
    acrossA = uu > 0 && (vv === 0 || uu >= vv)
    const lx = acrossA ? ux : vx
    const ly = acrossA ? uy : vy
    const length = Math.sqrt(lx * lx + ly * ly)
    dx = length > 0 ? -ly / length : 0
    dy = length > 0 ? lx / length : -1
    if (dx * px + dy * py < 0) {
      dx = -dx
      dy = -dy
    }
    touch.nx = dx
    touch.ny = dy
  } else {
    touch.nx = dx / distance
    touch.ny = dy / distance
  }
  const nx = touch.nx
  const ny = touch.ny
  const gap = distance - ra - rb
  const acrossB = !acrossA && t > -1 && t < 1 && vv > 0
  if (uu > 0 && vv > 0 && (acrossA || acrossB)) {
    // The normal stands on one segment, the reference; the other one is cut to its length.
    const rx = acrossA ? ux : vx
    const ry = acrossA ? uy : vy
    const rr = acrossA ? uu : vv
    const ix = acrossA ? vx : ux
    const iy = acrossA ? vy : uy
    const ox = acrossA ? px : -px
    const oy = acrossA ? py : -py
    const mid = (rx * ox + ry * oy) / rr
    const half = (rx * ix + ry * iy) / rr
    let lo = -1
    let hi = 1
    let loFeature = acrossA ? 4 : 0
    let hiFeature = loFeature + 1
    if (half > TINY || half < -TINY) {
      const endLo = half > 0 ? (-1 - mid) / half : (1 - mid) / half
      const endHi = half > 0 ? (1 - mid) / half : (-1 - mid) / half
      const own = acrossA ? 0 : 4
      if (endLo > lo) {
        lo = endLo
        loFeature = own + (half > 0 ? 0 : 1)
      }
      if (endHi < hi) {
        hi = endHi
        hiFeature = own + (half > 0 ? 1 : 0)
      }
    }
    if (hi - lo > 1e-6) {
      const sign = acrossA ? 1 : -1
      for (let k = 0; k < 2; k++) {
        const at = k === 0 ? lo : hi
        const along = mid + at * half
        const apart = sign * ((ox + at * ix) * nx + (oy + at * iy) * ny) - ra - rb
        if (apart > margin) continue
        const feature = k === 0 ? loFeature : hiFeature
        if (acrossA) addPoint(along * rx, along * ry, at * ix, at * iy, ra, rb, apart, feature)
        else addPoint(at * ix, at * iy, along * rx, along * ry, ra, rb, apart, feature)
      }
      if (touch.count > 0)
        return crossed ? Math.min(touch.points[GAP], touch.points[(touch.count - 1) * POINT + GAP]) : gap
    }
  }
  addPoint(s * ux, s * uy, t * vx, t * vy, ra, rb, gap, acrossA ? (t > 0 ? 5 : 4) : s > 0 ? 1 : 0)
  return gap
}

/** Two rounded boxes, or one and a pill or disc: separating axes of the cores, then the features that face each other. */
function collideBoxes(
  px: number,
  py: number,
  ca: number,
  na: number,
  hxa: number,
  hya: number,
  cb: number,
  nb: number,
  hxb: number,
  hyb: number,
  ra: number,
  rb: number,
  margin: number,
): number {
  // Rotation of B seen from A.
  const c = ca * cb + na * nb
  const n = ca * nb - na * cb
  const absC = c < 0 ? -c : c
  const absN = n < 0 ? -n : n
  const far = ra + rb + margin
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
  if (best > far) return best - ra - rb

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

  // Where the cores are apart the closest features may be two corners.
  if (best > 0) {
    closest(mx - fx * depth, my - fy * depth, gx * half, gy * half, ex, ey)
    const s = nearest.s
    const t = nearest.t
    if ((s === 1 || s === -1) && (t === 1 || t === -1 || (ex === 0 && ey === 0))) {
      const rx = fx * depth + gx * half * s
      const ry = fy * depth + gy * half * s
      const dx = mx + ex * t - rx
      const dy = my + ey * t - ry
      const distance = Math.sqrt(dx * dx + dy * dy)
      // Two corners only if the line between them leaves the face: else the face's own normal is the same.
      if (distance > best + 1e-9) {
        const gap = distance - ra - rb
        if (gap > margin) return gap
        touch.nx = (sign * dx) / distance
        touch.ny = (sign * dy) / distance
        const qx = mx + ex * t - ox
        const qy = my + ey * t - oy
        const feature = own + (s > 0 ? 1 : 0)
        if (onA) addPoint(rx, ry, qx, qy, ra, rb, gap, feature)
        else addPoint(qx, qy, rx, ry, ra, rb, gap, feature)
        return gap
      }
    }
  }

  touch.nx = sign * fx
  touch.ny = sign * fy
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
    const gap = apart - ra - rb
    if (gap < least) least = gap
    if (gap > margin) continue
    const feature = k === 0 ? loFeature : hiFeature
    const rx = qx - fx * apart
    const ry = qy - fy * apart
    if (onA) addPoint(rx, ry, qx - ox, qy - oy, ra, rb, gap, feature)
    else addPoint(qx - ox, qy - oy, rx, ry, ra, rb, gap, feature)
  }
  return least
}

/**
 * Distance of body `b` from a wall of the stage, px: all points x with n·x ≥ offset are inside. The wall is shape A,
 * its normal points inwards, and its arms count from the origin (it never turns).
 */
export function collideWall(
  bodies: Bodies,
  b: number,
  nx: number,
  ny: number,
  offset: number,
  margin: number,
): number {
  const { state, motion, shape } = bodies
  turn(state, motion, b)
  touch.count = 0
  touch.nx = nx
  touch.ny = ny
  const c = motion[b * MOTION + COS]
  const s = motion[b * MOTION + SIN]
  const hx = shape[b * SHAPE + HX]
  const hy = shape[b * SHAPE + HY]
  const r = shape[b * SHAPE + RADIUS]
  // How much each half extent leans into the wall.
  const lx = nx * c + ny * s
  const ly = ny * c - nx * s
  const sx = lx > 0 ? -1 : 1
  const sy = ly > 0 ? -1 : 1
  const alongX = sx * lx * hx
  const alongY = sy * ly * hy
  const base = nx * state[b * STATE + X] + ny * state[b * STATE + Y] - offset - r
  const gap = base + alongX + alongY
  if (gap > margin) return gap
  // The lowest corner, then the other end of the lower side.
  wallPoint(c, s, sx * hx, sy * hy, r, gap, (sx > 0 ? 1 : 0) + (sy > 0 ? 2 : 0))
  const flipX = hy === 0 || (hx > 0 && -alongX < -alongY)
  const rise = flipX ? -2 * alongX : -2 * alongY
  if ((flipX ? hx : hy) > 0 && gap + rise <= margin) {
    const kx = flipX ? -sx : sx
    const ky = flipX ? sy : -sy
    wallPoint(c, s, kx * hx, ky * hy, r, gap + rise, (kx > 0 ? 1 : 0) + (ky > 0 ? 2 : 0))
  }
  return gap
}

function wallPoint(
  c: number,
  s: number,
  x: number,
  y: number,
  r: number,
  gap: number,
  feature: number,
): void {
  addPoint(0, 0, c * x - s * y, s * x + c * y, 0, r, gap, feature)
}

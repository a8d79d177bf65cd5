import { IMPACT_TOLERANCE, SLOW_CONTACT } from './constants'
import { updateRotation } from './math'
import { type Bodies, COS, HX, HY, MOTION, RADIUS, SHAPE, SIN, STATE, VX, VY, X, Y } from './state'

/**
 * Two shapes in, contact points out. Both go through `manifold`, which the next call uses again: numbers
 * handed over as arguments or results would be boxed.
 *
 * The normal points from A to B. Each point lies on both surfaces: an arm leads from each body's centre to
 * its own surface, and the separation along the normal is negative where the two overlap.
 */
export const manifold: Float64Array = new Float64Array(20)
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
 * The face of one body and the side of the other that faces it, as the last `collide` found them. The body of
 * the face is the reference body R, the other is the incident body I.
 */
const facing: Float64Array = new Float64Array(8)
/** Normal of the face, outward from R, and px, half of its length. */
const FACE_X = 0
const FACE_Y = 1
const FACE_HALF = 2
/** px, from the middle of the face to the middle of the side. */
const SIDE_X = 3
const SIDE_Y = 4
/** px, from the middle of the side to one of its ends. */
const SIDE_END_X = 5
const SIDE_END_Y = 6
/** px, distance of a corner of R and one of I where these two alone are nearest, else 0. */
const CORNER_DISTANCE = 7

/** px, distance of two cores along the face normals of B, its x axis first, then along those of A. */
const faceGaps: Float64Array = new Float64Array(4)
const GAPS_OF_A = 2

/**
 * Measures the core of body `i` from the faces of body `r` into `faceGaps`, from place `at` on, and returns
 * the larger distance. A side of no length, of a pill or disc, is no face.
 */
function measureFaces({ state, motion, shape }: Bodies, r: number, i: number, at: number): number {
  const cosR = motion[r * MOTION + COS]
  const sinR = motion[r * MOTION + SIN]
  const cosI = motion[i * MOTION + COS]
  const sinI = motion[i * MOTION + SIN]
  const halfIX = shape[i * SHAPE + HX]
  const halfIY = shape[i * SHAPE + HY]
  const offsetX = state[i * STATE + X] - state[r * STATE + X]
  const offsetY = state[i * STATE + Y] - state[r * STATE + Y]
  // Cosine and sine of the angle between the two.
  const cos = Math.abs(cosR * cosI + sinR * sinI)
  const sin = Math.abs(cosR * sinI - sinR * cosI)
  const halfRX = shape[r * SHAPE + HX]
  const halfRY = shape[r * SHAPE + HY]
  faceGaps[at + X] =
    halfRY > 0 ? Math.abs(offsetX * cosR + offsetY * sinR) - halfRX - halfIX * cos - halfIY * sin : -Infinity
  faceGaps[at + Y] =
    halfRX > 0 ? Math.abs(offsetY * cosR - offsetX * sinR) - halfRY - halfIX * sin - halfIY * cos : -Infinity
  return Math.max(faceGaps[at + X], faceGaps[at + Y])
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
  const gapB = measureFaces(bodies, b, a, 0)
  const gapA = measureFaces(bodies, a, b, GAPS_OF_A)
  const onA = gapB <= gapA + 1e-3
  const coreGap = onA ? gapA : gapB
  // The face is that of the axis on which the cores are farthest apart; all is seen from the centre of R.
  const r = onA ? a : b
  const i = onA ? b : a
  const gaps = onA ? GAPS_OF_A : 0
  const onX = faceGaps[gaps + X] >= faceGaps[gaps + Y] && coreGap > -Infinity
  const halfRX = shape[r * SHAPE + HX]
  const halfRY = shape[r * SHAPE + HY]
  const halfIX = shape[i * SHAPE + HX]
  const halfIY = shape[i * SHAPE + HY]
  manifold[DISTANCE] = coreGap - radiusA - radiusB
  // Cores without an inside, of pills and discs, need their closest points even to know their distance.
  const thin = halfRX * halfRY === 0 && halfIX * halfIY === 0
  if (!thin && manifold[DISTANCE] > manifold[WIDEST]) return

  // The face: its outward normal, from R towards I, and where it is along that.
  const offsetX = state[i * STATE + X] - state[r * STATE + X]
  const offsetY = state[i * STATE + Y] - state[r * STATE + Y]
  const cosR = motion[r * MOTION + COS]
  const sinR = motion[r * MOTION + SIN]
  const cosI = motion[i * MOTION + COS]
  const sinI = motion[i * MOTION + SIN]
  let faceX = onX ? cosR : -sinR
  let faceY = onX ? sinR : cosR
  if (faceX * offsetX + faceY * offsetY < 0) {
    faceX = -faceX
    faceY = -faceY
  }
  const faceAt = onX ? halfRX : halfRY
  const faceHalf = onX ? halfRY : halfRX
  const faceEndX = -faceY * faceHalf
  const faceEndY = faceX * faceHalf

  // The incident side is the one whose outward normal is most against that of the face; of a segment, a long
  // one.
  const alongX = faceX * cosI + faceY * sinI
  const alongY = faceY * cosI - faceX * sinI
  const sideOnX = halfIY > 0 && (halfIX === 0 || Math.abs(alongX) > Math.abs(alongY))
  const sideAt = sideOnX ? (alongX > 0 ? -halfIX : halfIX) : alongY > 0 ? -halfIY : halfIY
  const axisX = sideOnX ? cosI : -sinI
  const axisY = sideOnX ? sinI : cosI
  const sideHalf = sideOnX ? halfIY : halfIX
  const sideX = offsetX + sideAt * axisX
  const sideY = offsetY + sideAt * axisY
  let sideEndX = -axisY * sideHalf
  let sideEndY = axisX * sideHalf
  const wayX = sideX - faceX * faceAt
  const wayY = sideY - faceY * faceAt
  facing[FACE_X] = faceX
  facing[FACE_Y] = faceY
  facing[FACE_HALF] = faceHalf
  facing[SIDE_X] = wayX
  facing[SIDE_Y] = wayY
  facing[SIDE_END_X] = sideEndX
  facing[SIDE_END_Y] = sideEndY
  facing[CORNER_DISTANCE] = 0

  // Places on face and side, from -1 to 1, that are nearest: the deepest end where the cores overlap.
  let facePlace = 0
  let sidePlace = sideEndX * faceX + sideEndY * faceY > 0 ? -1 : 1
  let normalX = faceX
  let normalY = faceY
  const apart = coreGap > 0 || thin
  if (apart) {
    // Closest points of two segments, in units of their half lengths.
    const perFace = faceHalf > 0 ? 1 / (faceHalf * faceHalf) : 0
    const perSide = sideHalf > 0 ? 1 / (sideHalf * sideHalf) : 0
    const faceBySide = faceEndX * sideEndX + faceEndY * sideEndY
    const faceByWay = faceEndX * wayX + faceEndY * wayY
    const sideByWay = sideEndX * wayX + sideEndY * wayY
    // The squared sine of the angle between the two: parallel sides have no one place that is nearest.
    const squaredSine = 1 - faceBySide * faceBySide * perFace * perSide
    facePlace = faceByWay * perFace
    if (squaredSine > 1e-9 && perSide > 0)
      facePlace = (facePlace - faceBySide * sideByWay * perFace * perSide) / squaredSine
    // Segments that cross at a right angle are measured at the end that is deeper.
    if (!(coreGap < -1e-6 && squaredSine > 0.999999))
      sidePlace = clampToUnit((faceBySide * clampToUnit(facePlace) - sideByWay) * perSide)
    facePlace = clampToUnit((faceByWay + faceBySide * sidePlace) * perFace)
    const dx = wayX + sideEndX * sidePlace - faceEndX * facePlace
    const dy = wayY + sideEndY * sidePlace - faceEndY * facePlace
    const distance = Math.sqrt(dx * dx + dy * dy)
    // Two corners have a normal of their own only where the line between them leaves the face.
    const atCorners = (faceHalf === 0 || isEnd(facePlace)) && (sideHalf === 0 || isEnd(sidePlace))
    if (atCorners && distance > Math.max(coreGap, 0) + 1e-9) {
      normalX = dx / distance
      normalY = dy / distance
      facing[CORNER_DISTANCE] = distance
    }
  }
  const sign = onA ? 1 : -1
  const outX = sign * normalX
  const outY = sign * normalY
  manifold[MANIFOLD_NX] = outX
  manifold[MANIFOLD_NY] = outY

  // Seen along the normal both sides are intervals: the two touch where these overlap, and at the nearest
  // point.
  const faceMiddle = faceAt * (faceY * normalX - faceX * normalY)
  const faceReach = faceEndY * normalX - faceEndX * normalY
  const sideMiddle = sideY * normalX - sideX * normalY
  let sideReach = sideEndY * normalX - sideEndX * normalY
  if (sideReach < 0) {
    sideEndX = -sideEndX
    sideEndY = -sideEndY
    sideReach = -sideReach
    sidePlace = -sidePlace
  }
  const nearest = sideMiddle + sidePlace * sideReach
  let low = Math.max(faceMiddle - faceReach, sideMiddle - sideReach)
  let high = Math.min(faceMiddle + faceReach, sideMiddle + sideReach)
  const single = high - low < 1e-6
  if (apart) {
    low = Math.min(low, nearest)
    high = Math.max(high, nearest)
  }
  const feature = (onA ? 0 : 4) + (onX ? 0 : 2)
  manifold[DISTANCE] = Infinity
  for (let n = 0; n < (single ? 1 : 2); n++) {
    if (!single) sidePlace = ((n > 0 ? high : low) - sideMiddle) / sideReach
    if (faceReach > 1e-9) facePlace = (sideMiddle + sidePlace * sideReach - faceMiddle) / faceReach
    const pointRX = faceX * faceAt + faceEndX * facePlace
    const pointRY = faceY * faceAt + faceEndY * facePlace
    const pointIX = sideX + sideEndX * sidePlace
    const pointIY = sideY + sideEndY * sidePlace
    const gap = (pointIX - pointRX) * normalX + (pointIY - pointRY) * normalY - radiusA - radiusB
    manifold[DISTANCE] = Math.min(manifold[DISTANCE], gap)
    if (gap > manifold[WIDEST]) continue
    const p = manifold[COUNT]++ * POINT
    manifold[p + ARM_AX] = (onA ? pointRX : pointIX - offsetX) + radiusA * outX
    manifold[p + ARM_AY] = (onA ? pointRY : pointIY - offsetY) + radiusA * outY
    manifold[p + ARM_BX] = (onA ? pointIX - offsetX : pointRX) - radiusB * outX
    manifold[p + ARM_BY] = (onA ? pointIY - offsetY : pointRY) - radiusB * outY
    manifold[p + GAP] = gap
    manifold[p + FEATURE] = (isEnd(sidePlace) ? 12 - feature : feature) + n
  }
}

/**
 * Whether bodies `a` and `b`, as `collide` found them, hit each other by so little that they slide past. The
 * corner of a box sags a little into the surface that it slides on: it would trip over the side of the next
 * box in a level row.
 */
export function grazes({ state, shape }: Bodies, a: number, b: number): boolean {
  const vx = state[b * STATE + VX] - state[a * STATE + VX]
  const vy = state[b * STATE + VY] - state[a * STATE + VY]
  const speed = Math.sqrt(vx * vx + vy * vy)
  const normalX = manifold[MANIFOLD_NX]
  const normalY = manifold[MANIFOLD_NY]
  const approach = -normalX * vx - normalY * vy
  // Slow bodies are pushed apart instead: a jam must not fall asleep while its chips overlap.
  if (!(speed > SLOW_CONTACT && approach > IMPACT_TOLERANCE * speed)) return false
  const against = Math.abs(facing[FACE_X] * vx + facing[FACE_Y] * vy)
  const along = Math.abs(facing[FACE_X] * vy - facing[FACE_Y] * vx)
  // Across the motion: half lengths of the two together, and the distance of their middles.
  const halves = Math.abs(facing[SIDE_END_X] * vy - facing[SIDE_END_Y] * vx) + facing[FACE_HALF] * against
  const middles = Math.abs(facing[SIDE_X] * vy - facing[SIDE_Y] * vx)
  // A motion along the face sees both sides edge on: the distance of two corners counts instead.
  const apart =
    along > against && facing[CORNER_DISTANCE] > 0
      ? facing[CORNER_DISTANCE] * Math.abs(normalX * vy - normalY * vx)
      : middles - halves
  // Only what moves along the face or against it can slide past.
  return (
    Math.min(against, along) <= IMPACT_TOLERANCE * speed &&
    shape[a * SHAPE + RADIUS] + shape[b * SHAPE + RADIUS] - apart / speed < IMPACT_TOLERANCE
  )
}

/**
 * Whether a place on a side is an end of it. It is compared with a fraction, or V8 takes places for integers.
 */
function isEnd(place: number): boolean {
  return Math.abs(place) > 0.999999
}

function clampToUnit(place: number): number {
  return place > 1 ? 1 : Math.max(place, -1)
}

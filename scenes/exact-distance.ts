// Exact signed distance between chips, and between a chip and the stage. Tests, benchmark and docs judge
// every solver by this file, so it shares no code with any of them.

/** A core rectangle swept by `radius`; `width` and `height` include the radius. Lengths in px. */
export type Shape = { width: number; height: number; radius?: number }
/** Centre in px (y down) and angle in radians. */
export type Pose = { x: number; y: number; angle: number }
export type Stage = { width: number; height: number }

/** The radius a shape can really have: at most half its shorter side. */
export function cornerRadius(shape: Shape) {
  return Math.min(shape.radius ?? 0, shape.width / 2, shape.height / 2)
}

// Half edges of the two cores: the Minkowski difference of two rectangles is the polygon these four span.
const ex = new Float64Array(4)
const ey = new Float64Array(4)

function setHalfEdges(at: number, shape: Shape, angle: number) {
  const r = cornerRadius(shape)
  const a = shape.width / 2 - r
  const b = shape.height / 2 - r
  const c = Math.cos(angle)
  const s = Math.sin(angle)
  ex[at] = a * c
  ey[at] = a * s
  ex[at + 1] = -b * s
  ey[at + 1] = b * c
}

/** Turns the half edges to point down or right, in the order of their direction. */
function sortByDirection() {
  for (let i = 0; i < 4; i++) {
    if (ey[i] < 0 || (ey[i] === 0 && ex[i] < 0)) {
      ex[i] = -ex[i]
      ey[i] = -ey[i]
    }
    const x = ex[i]
    const y = ey[i]
    const direction = Math.atan2(y, x)
    let j = i - 1
    while (j >= 0 && Math.atan2(ey[j], ex[j]) > direction) {
      ex[j + 1] = ex[j]
      ey[j + 1] = ey[j]
      j--
    }
    ex[j + 1] = x
    ey[j + 1] = y
  }
}

/** Signed distance of the point (px, py) from the polygon around the origin that the half edges span. */
function polygonDistance(px: number, py: number) {
  let vx = 0
  let vy = 0
  for (let i = 0; i < 4; i++) {
    vx -= ex[i]
    vy -= ey[i]
  }
  let inside = true
  let depth = Number.POSITIVE_INFINITY
  let nearest = Number.POSITIVE_INFINITY
  for (let k = 0; k < 8; k++) {
    const sign = k < 4 ? 2 : -2
    const dx = sign * ex[k & 3]
    const dy = sign * ey[k & 3]
    const qx = px - vx
    const qy = py - vy
    const length2 = dx * dx + dy * dy
    let t = 0
    if (length2 > 0) {
      const cross = dx * qy - dy * qx
      if (cross <= 0) inside = false
      else depth = Math.min(depth, cross / Math.sqrt(length2))
      t = Math.max(0, Math.min(1, (qx * dx + qy * dy) / length2))
    }
    const ox = qx - t * dx
    const oy = qy - t * dy
    nearest = Math.min(nearest, ox * ox + oy * oy)
    vx += dx
    vy += dy
  }
  nearest = Math.sqrt(nearest)
  // Past the end of a polygon without area rounding can put a point "inside": there the edges are far away.
  if (inside && Number.isFinite(depth) && nearest <= depth + 1e-6) return -depth
  return nearest
}

/**
 * Distance in px between the surfaces of two chips; when they overlap, minus the length of the shortest
 * translation that parts them. Exact to rounding: the distance from a point to the Minkowski difference of
 * the cores, less both radii.
 */
export function chipDistance(a: Shape, poseA: Pose, b: Shape, poseB: Pose) {
  setHalfEdges(0, a, poseA.angle)
  setHalfEdges(2, b, poseB.angle)
  sortByDirection()
  return polygonDistance(poseB.x - poseA.x, poseB.y - poseA.y) - cornerRadius(a) - cornerRadius(b)
}

/** Half the width and height of the upright box round a turned chip, px. */
export function halfExtent(shape: Shape, angle: number): [number, number] {
  const r = cornerRadius(shape)
  const a = shape.width / 2 - r
  const b = shape.height / 2 - r
  const c = Math.abs(Math.cos(angle))
  const s = Math.abs(Math.sin(angle))
  return [a * c + b * s + r, a * s + b * c + r]
}

/** Distance in px to the floor and to both walls; negative is how deep the chip reaches into them. */
export function stageDistance(shape: Shape, pose: Pose, stage: Stage) {
  const [ax, ay] = halfExtent(shape, pose.angle)
  return { floor: stage.height - pose.y - ay, left: pose.x - ax, right: stage.width - pose.x - ax }
}

/** px that rounding may take from a bound. */
const slack = 1e-6

/**
 * How far the deepest chip reaches into its neighbour, the floor or a wall, px; 0 when nothing overlaps. Only
 * what is deeper than `known` is looked for: `known` is given back when there is nothing.
 */
export function worstOverlap(shapes: Shape[], poses: Pose[], stage: Stage, known = 0) {
  const n = shapes.length
  let worst = known
  const ax = new Float64Array(n)
  const ay = new Float64Array(n)
  for (let i = 0; i < n; i++) {
    const pose = poses[i]
    if (!Number.isFinite(pose.x + pose.y + pose.angle)) return Number.POSITIVE_INFINITY
    const [hx, hy] = halfExtent(shapes[i], pose.angle)
    ax[i] = hx
    ay[i] = hy
    worst = Math.max(worst, pose.y + hy - stage.height, hx - pose.x, pose.x + hx - stage.width)
  }
  const starts = ax.map((half, i) => poses[i].x - half)
  const order = Array.from({ length: n }, (_, i) => i).sort((i, j) => starts[i] - starts[j])
  for (let k = 0; k < n; k++) {
    const i = order[k]
    const { x, y } = poses[i]
    for (let l = k + 1; l < n; l++) {
      const j = order[l]
      // The upright boxes part along x or y: what is no deeper in one of them has no pair that is.
      const least = worst - slack
      if (starts[j] > x + ax[i] - least) break
      if (ax[i] + ax[j] - Math.abs(poses[j].x - x) <= least) continue
      if (ay[i] + ay[j] - Math.abs(poses[j].y - y) <= least) continue
      worst = Math.max(worst, -chipDistance(shapes[i], poses[i], shapes[j], poses[j]))
    }
  }
  return worst
}

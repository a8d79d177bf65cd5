// Which chips stand upright on a single point. Told by exact geometry, without a word from any solver.
import { cornerRadius, type Pose, type Shape, type Stage } from './exact-distance'

/** px, distance between two surfaces up to which they count as touching. */
const near = 0.1
/** px, distance between two touching points up to which they count as one. */
const same = 1
/** Ratio of the longer side to the shorter up to which a chip counts as round: it has no end to stand on. */
const roundUpTo = 1.2
/** Share of the way from lying to standing on the farthest corner, from which a chip counts as standing. */
const standsFrom = 0.75

type Point = { x: number; y: number }

/** Half sides of the rectangle that the corner radius is swept around. */
function core(shape: Shape) {
  const r = cornerRadius(shape)
  return { a: shape.width / 2 - r, b: shape.height / 2 - r, r }
}

/** The corners of that rectangle, on the stage. */
function corners(shape: Shape, { x, y, angle }: Pose): Point[] {
  const { a, b } = core(shape)
  const c = Math.cos(angle)
  const s = Math.sin(angle)
  return [
    [a, b],
    [-a, b],
    [-a, -b],
    [a, -b],
  ].map(([u, v]) => ({ x: x + c * u - s * v, y: y + s * u + c * v }))
}

/** Points at which corners of the first chip touch the second. */
function cornersOn(shape: Shape, pose: Pose, other: Shape, otherPose: Pose): Point[] {
  const { a, b, r } = core(other)
  const reach = cornerRadius(shape) + r + near
  const c = Math.cos(otherPose.angle)
  const s = Math.sin(otherPose.angle)
  return corners(shape, pose).flatMap((corner) => {
    const dx = corner.x - otherPose.x
    const dy = corner.y - otherPose.y
    const u = c * dx + s * dy
    const v = c * dy - s * dx
    const nearestU = Math.max(-a, Math.min(a, u))
    const nearestV = Math.max(-b, Math.min(b, v))
    const distance = Math.hypot(u - nearestU, v - nearestV)
    if (distance > reach) return []
    // The point of the other chip's outline that lies towards this corner.
    const out = distance > 0 ? r / distance : 0
    const atU = nearestU + out * (u - nearestU)
    const atV = nearestV + out * (v - nearestV)
    return [{ x: otherPose.x + c * atU - s * atV, y: otherPose.y + s * atU + c * atV }]
  })
}

/** Points at which a chip touches floor and walls. */
function pointsOnStage(shape: Shape, pose: Pose, stage: Stage): Point[] {
  const { r } = core(shape)
  return corners(shape, pose).flatMap(({ x, y }) => [
    ...(y + r > stage.height - near ? [{ x, y: stage.height }] : []),
    ...(x - r < near ? [{ x: 0, y }] : []),
    ...(x + r > stage.width - near ? [{ x: stage.width, y }] : []),
  ])
}

/** Whether a chip that touches its surroundings at these points alone is upright on one of them. */
function upright(shape: Shape, pose: Pose, points: Point[]) {
  const short = Math.min(shape.width, shape.height) / 2
  const long = Math.max(shape.width, shape.height) / 2
  if (points.length === 0 || long <= roundUpTo * short) return false
  const [first] = points
  if (points.some(({ x, y }) => Math.hypot(x - first.x, y - first.y) > same)) return false
  const { a, b, r } = core(shape)
  const farthest = Math.hypot(a, b) + r
  return Math.hypot(first.x - pose.x, first.y - pose.y) > short + standsFrom * (farthest - short)
}

/** How many chips stand upright on one point: a pill on its round end, a card on a corner. */
export function standing(shapes: Shape[], poses: Pose[], stage: Stage) {
  const points = shapes.map((shape, i) => pointsOnStage(shape, poses[i], stage))
  const reach = shapes.map(({ width, height }) => Math.hypot(width, height) / 2)
  for (let i = 0; i < shapes.length; i++) {
    for (let j = 0; j < i; j++) {
      const apart = Math.hypot(poses[i].x - poses[j].x, poses[i].y - poses[j].y)
      if (apart > reach[i] + reach[j] + near) continue
      const touching = [
        ...cornersOn(shapes[i], poses[i], shapes[j], poses[j]),
        ...cornersOn(shapes[j], poses[j], shapes[i], poses[i]),
      ]
      points[i].push(...touching)
      points[j].push(...touching)
    }
  }
  return shapes.filter((shape, i) => upright(shape, poses[i], points[i])).length
}

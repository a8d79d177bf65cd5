import { describe, expect, it } from 'vitest'
import {
  chipDistance,
  cornerRadius,
  type Pose,
  type Shape,
  stageDistance,
  worstOverlap,
} from './exact-distance'
import { seeded } from './seeded'

/** How far a chip reaches from its centre in the direction (nx, ny). */
function support(shape: Shape, angle: number, nx: number, ny: number) {
  const r = cornerRadius(shape)
  const c = Math.cos(angle)
  const s = Math.sin(angle)
  return (
    (shape.width / 2 - r) * Math.abs(nx * c + ny * s) +
    (shape.height / 2 - r) * Math.abs(ny * c - nx * s) +
    r * Math.hypot(nx, ny)
  )
}

/** The same distance by search: the widest gap over all directions, negative where there is none. */
function searchedDistance(a: Shape, poseA: Pose, b: Shape, poseB: Pose) {
  const gap = (angle: number) => {
    const nx = Math.cos(angle)
    const ny = Math.sin(angle)
    return (
      (poseB.x - poseA.x) * nx +
      (poseB.y - poseA.y) * ny -
      support(a, poseA.angle, nx, ny) -
      support(b, poseB.angle, nx, ny)
    )
  }
  let best = -Infinity
  const directions = 360
  const turn = (2 * Math.PI) / directions
  const gaps = Array.from({ length: directions }, (_, k) => gap(k * turn))
  const top = Math.max(...gaps)
  for (let k = 0; k < directions; k++) {
    if (gaps[k] < gaps[(k + 1) % directions] || gaps[k] < gaps[(k + directions - 1) % directions]) continue
    if (gaps[k] < top - 8) continue
    let low = (k - 1) * turn
    let high = (k + 1) * turn
    for (let i = 0; i < 60; i++) {
      const p = low + (high - low) / 3
      const q = high - (high - low) / 3
      if (gap(p) < gap(q)) low = p
      else high = q
    }
    best = Math.max(best, gap((low + high) / 2))
  }
  return best
}

function randomShape(random: () => number): Shape {
  const width = 4 + 120 * random()
  const height = random() < 0.3 ? width : 4 + 120 * random() ** 2
  const least = Math.min(width, height) / 2
  const kind = random()
  return { width, height, radius: kind < 0.35 ? least : kind < 0.7 ? least * random() : 0 }
}

describe('the exact distance', () => {
  it('agrees with a search over directions for 10,000 random pairs, apart, touching and deep', () => {
    const random = seeded(7)
    let worst = 0
    for (let i = 0; i < 10_000; i++) {
      const a = randomShape(random)
      const b = randomShape(random)
      const poseA = { x: 50 * random(), y: 50 * random(), angle: 7 * random() }
      const away = 160 * random()
      const round = 7 * random()
      const square = random() < 0.2
      const poseB = {
        x: poseA.x + away * Math.cos(round),
        y: poseA.y + away * Math.sin(round),
        angle: square ? poseA.angle + (Math.PI / 2) * Math.floor(4 * random()) : 7 * random(),
      }
      const error = Math.abs(chipDistance(a, poseA, b, poseB) - searchedDistance(a, poseA, b, poseB))
      worst = Math.max(worst, error)
    }
    expect(worst).toBeLessThan(1e-8)
  })

  it('knows the cases a ruler can check', () => {
    const disc = { width: 20, height: 20, radius: 10 }
    const box = { width: 40, height: 20 }
    const pill = { width: 60, height: 20, radius: 10 }
    const at = (x: number, y: number, angle = 0) => ({ x, y, angle })
    expect(chipDistance(disc, at(0, 0), disc, at(30, 40))).toBeCloseTo(30, 12)
    expect(chipDistance(disc, at(0, 0), disc, at(3, 4))).toBeCloseTo(-15, 12)
    expect(chipDistance(box, at(0, 0), box, at(50, 0))).toBeCloseTo(10, 12)
    expect(chipDistance(box, at(0, 0), box, at(43, 24))).toBeCloseTo(5, 12)
    expect(chipDistance(box, at(0, 0), box, at(10, 15))).toBeCloseTo(-5, 12)
    expect(chipDistance(pill, at(0, 0), pill, at(0, 19))).toBeCloseTo(-1, 12)
    expect(chipDistance(pill, at(0, 0), pill, at(0, 60, Math.PI / 2))).toBeCloseTo(20, 12)
    expect(chipDistance(pill, at(5, 5), pill, at(5, 5))).toBeCloseTo(-20, 12)
    expect(chipDistance(disc, at(0, 0), box, at(23, 14))).toBeCloseTo(-5, 12)
  })

  it('takes no radius for larger than half the shorter side', () => {
    expect(cornerRadius({ width: 10, height: 40, radius: 99 })).toBe(5)
    expect(cornerRadius({ width: 40, height: 10, radius: 99 })).toBe(5)
    expect(cornerRadius({ width: 40, height: 10, radius: 3 })).toBe(3)
    expect(cornerRadius({ width: 40, height: 10 })).toBe(0)
  })

  it('is the same seen from either chip', () => {
    const random = seeded(3)
    for (let i = 0; i < 1000; i++) {
      const a = randomShape(random)
      const b = randomShape(random)
      const poseA = { x: 90 * random(), y: 90 * random(), angle: 7 * random() }
      const poseB = { x: 90 * random(), y: 90 * random(), angle: 7 * random() }
      const difference = chipDistance(a, poseA, b, poseB) - chipDistance(b, poseB, a, poseA)
      expect(Math.abs(difference)).toBeLessThan(1e-10)
    }
  })

  it('sees a chip in the floor and in both walls', () => {
    const stage = { width: 100, height: 50 }
    const pill = { width: 60, height: 20, radius: 10 }
    const upright = stageDistance(pill, { x: 9, y: 22, angle: Math.PI / 2 }, stage)
    expect(upright.left).toBeCloseTo(-1, 12)
    expect(upright.right).toBeCloseTo(81, 12)
    expect(upright.floor).toBeCloseTo(-2, 12)
    expect(worstOverlap([pill], [{ x: 9, y: 22, angle: Math.PI / 2 }], stage)).toBeCloseTo(2, 12)
  })

  it('finds the deepest pair of a crowd, the same as asking every pair', () => {
    const random = seeded(11)
    const wide = { width: 1e5, height: 1e5 }
    let touching = 0
    for (let crowd = 0; crowd < 300; crowd++) {
      const shapes = Array.from({ length: 8 }, () => randomShape(random))
      const poses = shapes.map(() => ({ x: 5000 + 300 * random(), y: 300 * random(), angle: 7 * random() }))
      let worst = 0
      for (let i = 0; i < shapes.length; i++) {
        const { floor } = stageDistance(shapes[i], poses[i], wide)
        expect(floor).toBeGreaterThan(0)
        for (let j = 0; j < i; j++) {
          worst = Math.max(worst, -chipDistance(shapes[i], poses[i], shapes[j], poses[j]))
        }
      }
      if (worst > 0) touching++
      expect(worstOverlap(shapes, poses, wide)).toBeCloseTo(worst, 9)
      expect(worstOverlap(shapes, poses, wide, 0.9 * worst)).toBeCloseTo(worst, 9)
      expect(worstOverlap(shapes, poses, wide, worst + 1)).toBe(worst + 1)
    }
    expect(touching).toBeGreaterThan(200)
  })
})

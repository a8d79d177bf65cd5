import { describe, expect, it } from 'vitest'
import {
  chipDistance,
  cornerRadius,
  type Pose,
  type Shape,
  stageDistance,
} from '../../../scenes/exact-distance'
import { seeded } from '../../../scenes/seeded'
import { setPose, setShape } from './body'
import {
  ARM_AX,
  ARM_AY,
  ARM_BX,
  ARM_BY,
  COUNT,
  collide,
  DISTANCE,
  GAP,
  MANIFOLD_NX,
  MANIFOLD_NY,
  manifold,
  POINT,
  WIDEST,
} from './manifold'
import { Bodies } from './state'

const bodies = new Bodies()

function put(i: number, shape: Shape, pose: Pose) {
  setShape(bodies, i, shape.width, shape.height, shape.radius ?? 0, 1)
  setPose(bodies, i, pose.x, pose.y, pose.angle)
}

/** Contact of two chips as the solver sees it; points in px of the stage. */
function contact(a: Shape, poseA: Pose, b: Shape, poseB: Pose, margin = Infinity) {
  put(1, a, poseA)
  put(2, b, poseB)
  manifold[WIDEST] = margin
  collide(bodies, 1, 2)
  return seen(poseA, poseB)
}

function seen(poseA: Pose, poseB: Pose) {
  return {
    gap: manifold[DISTANCE],
    nx: manifold[MANIFOLD_NX],
    ny: manifold[MANIFOLD_NY],
    points: Array.from({ length: manifold[COUNT] }, (_, k) => ({
      onA: { x: poseA.x + manifold[k * POINT + ARM_AX], y: poseA.y + manifold[k * POINT + ARM_AY] },
      onB: { x: poseB.x + manifold[k * POINT + ARM_BX], y: poseB.y + manifold[k * POINT + ARM_BY] },
      gap: manifold[k * POINT + GAP],
    })),
  }
}

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

/** px from the point to the chip's outline, negative inside. */
function outline(shape: Shape, pose: Pose, at: { x: number; y: number }) {
  const r = cornerRadius(shape)
  const c = Math.cos(pose.angle)
  const s = Math.sin(pose.angle)
  const x = Math.abs(c * (at.x - pose.x) + s * (at.y - pose.y)) - (shape.width / 2 - r)
  const y = Math.abs(c * (at.y - pose.y) - s * (at.x - pose.x)) - (shape.height / 2 - r)
  return Math.hypot(Math.max(x, 0), Math.max(y, 0)) + Math.min(Math.max(x, y), 0) - r
}

/** Discs, pills, rounded boxes and boxes; lying, standing, 12:1, 4 px among 200 px. */
function anyShape(random: () => number): Shape {
  const kind = random()
  const size = random() < 0.15 ? 4 : random() < 0.2 ? 200 : 16 + 80 * random()
  if (kind < 0.2) return { width: size, height: size, radius: size / 2 }
  const long = random() < 0.25 ? 12 : 1 + 3 * random()
  const [width, height] = random() < 0.5 ? [size * long, size] : [size, size * long]
  if (kind < 0.5) return { width, height, radius: size / 2 }
  if (kind < 0.75) return { width, height, radius: size * 0.5 * random() }
  return { width, height, radius: 0 }
}

type Case = { a: Shape; poseA: Pose; b: Shape; poseB: Pose; apart: number }

/** Random pairs, deep inside each other, touching and apart, every fifth with parallel or square sides. */
function cases(count: number, seed: number): Case[] {
  const random = seeded(seed)
  return Array.from({ length: count }, () => {
    const a = anyShape(random)
    const b = anyShape(random)
    const poseA = { x: 900 * random(), y: 900 * random(), angle: 14 * (random() - 0.5) }
    const square = random() < 0.2
    const angle = square ? poseA.angle + (Math.PI / 2) * Math.floor(4 * random()) : 14 * (random() - 0.5)
    const round = 2 * Math.PI * random()
    const [nx, ny] = [Math.cos(round), Math.sin(round)]
    // From the centre of A to a little beyond touching.
    const away = (random() < 0.5 ? random() : 1 + 0.05 * random()) * 1.02
    const touching = support(a, poseA.angle, nx, ny) + support(b, angle, nx, ny)
    const poseB = { x: poseA.x + nx * away * touching, y: poseA.y + ny * away * touching, angle }
    return { a, poseA, b, poseB, apart: chipDistance(a, poseA, b, poseB) }
  })
}

/** px, rounding of coordinates of some thousands. */
const exact = 1e-9
const random10k = cases(10_000, 1)

describe('two chips', () => {
  it('are as far apart, or as deep inside each other, as the exact distance says: 10,000 random pairs', () => {
    const met = { apart: 0, touching: 0, deep: 0 }
    for (const { a, poseA, b, poseB, apart } of random10k) {
      const { gap } = contact(a, poseA, b, poseB)
      met[apart > 0 ? 'apart' : apart > -cornerRadius(a) - cornerRadius(b) ? 'touching' : 'deep']++
      // Of two ways out that differ by less than a thousandth of a pixel either will do.
      expect(Math.abs(gap - apart)).toBeLessThan(apart > 0 ? exact : 1e-3)
    }
    expect(Math.min(met.apart, met.touching, met.deep)).toBeGreaterThan(1500)
  })

  it('are so too where they lie or stand square to each other, flush to within next to nothing: 10,000 pairs', () => {
    const random = seeded(12)
    const tiny = () => (random() < 0.2 ? 0 : (random() < 0.5 ? -1 : 1) * 10 ** (-1 - 11 * random()))
    for (let k = 0; k < 10_000; k++) {
      const a = anyShape(random)
      const b = anyShape(random)
      const standing = random() < 0.5
      const poseA = { x: 100, y: 100, angle: tiny() }
      const [hx, hy] = standing ? [b.height, b.width] : [b.width, b.height]
      // Its core's end over the end of the other's core, or its outline's over the outline's.
      const side = random() < 0.5 ? 1 : -1
      const inset = random() < 0.5 ? cornerRadius(a) : 0
      const own =
        random() < 0.5 ? 0 : (hx / 2 - (inset > 0 ? cornerRadius(b) : 0)) * (random() < 0.5 ? 1 : -1)
      const poseB = {
        x: 100 + side * (a.width / 2 - inset) + own + tiny(),
        y: 100 - (a.height + hy) / 2 + (random() < 0.5 ? tiny() : 20 * (random() - 0.7)),
        angle: (standing ? Math.PI / 2 : 0) + tiny(),
      }
      const off = contact(a, poseA, b, poseB).gap - chipDistance(a, poseA, b, poseB)
      expect(Math.abs(off)).toBeLessThan(1e-3)
    }
  })

  it('part along the normal by just their gap, and no other of 360 directions parts them sooner', () => {
    for (const { a, poseA, b, poseB } of random10k) {
      const { gap, nx, ny } = contact(a, poseA, b, poseB)
      const apartAlong = (x: number, y: number) =>
        (poseB.x - poseA.x) * x +
        (poseB.y - poseA.y) * y -
        support(a, poseA.angle, x, y) -
        support(b, poseB.angle, x, y)
      expect(Math.hypot(nx, ny)).toBeCloseTo(1, 12)
      expect(Math.abs(apartAlong(nx, ny) - gap)).toBeLessThan(exact)
      let most = -Infinity
      for (let k = 0; k < 360; k++) {
        most = Math.max(most, apartAlong(Math.cos((k * Math.PI) / 180), Math.sin((k * Math.PI) / 180)))
      }
      expect(most).toBeLessThan(gap + 1e-3)
    }
  })

  it('have one point or two, the deepest of them on both outlines and none outside of either', () => {
    let pairs = 0
    for (const { a, poseA, b, poseB } of random10k) {
      const { gap, nx, ny, points } = contact(a, poseA, b, poseB)
      expect([1, 2]).toContain(points.length)
      pairs += points.length - 1
      expect(Math.abs(Math.min(...points.map((point) => point.gap)) - gap)).toBeLessThan(exact)
      for (const { onA, onB, gap: own } of points) {
        expect(Math.abs((onB.x - onA.x) * nx + (onB.y - onA.y) * ny - own)).toBeLessThan(exact)
        expect(Math.abs((onB.y - onA.y) * nx - (onB.x - onA.x) * ny)).toBeLessThan(exact)
        const [offA, offB] = [outline(a, poseA, onA), outline(b, poseB, onB)]
        expect(Math.max(offA, offB)).toBeLessThan(exact)
        // Cores that cross have their deepest corner inside; all others lie on both outlines.
        if (own === gap && gap > -cornerRadius(a) - cornerRadius(b)) {
          expect(Math.min(offA, offB)).toBeGreaterThan(-exact)
        }
      }
    }
    expect(pairs).toBeGreaterThan(1000)
  })

  it.each([14, 8])(
    'that lie almost in line on one another have a point at either end: corners of %i px',
    (radius) => {
      const shape = { width: 80, height: 28, radius }
      for (const tilt of [-0.02, -0.005, 0.005, 0.02]) {
        // Where neither end of the nearer side lies beside the other chip, two ends are nearest.
        for (let shift = -0.6; shift < 0.61; shift += 0.05) {
          const { points } = contact(
            shape,
            { x: 0, y: 0, angle: 0 },
            shape,
            { x: shift, y: -28.5, angle: tilt },
            2.5,
          )
          const [left, right] = points.map(({ onA }) => onA.x).sort((a, b) => a - b)
          expect(right - left).toBeGreaterThan(2 * (40 - radius) - 2)
        }
      }
    },
  )

  it('see the same contact from either side', () => {
    for (const { a, poseA, b, poseB, apart } of random10k.slice(0, 3000)) {
      if (apart < 0) continue
      const one = contact(a, poseA, b, poseB)
      const other = contact(b, poseB, a, poseA)
      expect(other.gap).toBeCloseTo(one.gap, 9)
      expect(other.nx).toBeCloseTo(-one.nx, 6)
      expect(other.ny).toBeCloseTo(-one.ny, 6)
    }
  })

  it('make no point beyond the margin, and the gap is then no more than it is', () => {
    let far = 0
    for (const { a, poseA, b, poseB, apart } of random10k) {
      const { gap, points } = contact(a, poseA, b, poseB, 2)
      if (apart > 2 + exact) {
        far++
        expect(points).toHaveLength(0)
        expect(gap).toBeGreaterThan(2)
        expect(gap).toBeLessThan(apart + exact)
      } else if (apart < 2 - exact) {
        expect(points.length).toBeGreaterThan(0)
        for (const point of points) expect(point.gap).toBeLessThanOrEqual(2)
      }
    }
    expect(far).toBeGreaterThan(1000)
  })

  it.each([
    ['pill', { width: 80, height: 30, radius: 15 }],
    ['standing pill', { width: 30, height: 80, radius: 15 }],
    ['rounded box', { width: 80, height: 30, radius: 8 }],
    ['box', { width: 80, height: 30 }],
    ['12:1 pill', { width: 240, height: 20, radius: 10 }],
  ])('stand on two points where their sides are parallel: %s', (_, shape) => {
    const standing = shape.height > shape.width
    const long = standing ? shape.height : shape.width
    const thick = standing ? shape.width : shape.height
    for (const angle of [0, 0.4, 2, -1.2]) {
      const along = standing ? angle + Math.PI / 2 : angle
      const [ux, uy] = [Math.cos(along), Math.sin(along)]
      for (const shift of [0, 0.2 * long, -0.1 * long]) {
        const poseA = { x: 300, y: 200, angle }
        const above = thick - 0.01
        const poseB = { x: 300 + shift * ux + above * uy, y: 200 + shift * uy - above * ux, angle }
        const { points, gap, nx, ny } = contact(shape, poseA, shape, poseB, 0.5)
        expect(gap).toBeCloseTo(-0.01, 9)
        expect(nx).toBeCloseTo(uy, 9)
        expect(ny).toBeCloseTo(-ux, 9)
        expect(points).toHaveLength(2)
        const [one, two] = points
        const sides = long - 2 * ((shape as { radius?: number }).radius ?? 0) - Math.abs(shift)
        expect(Math.hypot(one.onA.x - two.onA.x, one.onA.y - two.onA.y)).toBeCloseTo(sides, 6)
        for (const point of points) expect(point.gap).toBeCloseTo(-0.01, 9)
      }
    }
  })

  it('at the very same place get a normal and numbers', () => {
    const random = seeded(4)
    for (let i = 0; i < 500; i++) {
      const a = anyShape(random)
      const b = random() < 0.5 ? a : anyShape(random)
      const pose = { x: 100, y: 100, angle: 3 * random() }
      const poseB = random() < 0.5 ? pose : { ...pose, angle: 3 * random() }
      const { gap, nx, ny, points } = contact(a, pose, b, poseB)
      expect(Math.hypot(nx, ny)).toBeCloseTo(1, 12)
      expect(Math.abs(gap - chipDistance(a, pose, b, poseB))).toBeLessThan(1e-3)
      expect(points.length).toBeGreaterThan(0)
      const numbers = points.flatMap(({ onA, onB, gap: own }) => [onA.x, onA.y, onB.x, onB.y, own])
      expect(numbers.every(Number.isFinite)).toBe(true)
    }
  })
})

describe('a chip and a wall', () => {
  const stage = { width: 900, height: 700 }
  // Walls are boxes, far larger than any chip.
  const wide = { width: 1000, height: 1e6 }
  const walls: [Shape, Pose][] = [
    [
      { width: 1e6, height: 1000 },
      { x: 450, y: 1200, angle: 0 },
    ],
    [wide, { x: -500, y: 0, angle: 0 }],
    [wide, { x: 1400, y: 0, angle: 0 }],
  ]
  const meet = (shape: Shape, pose: Pose, wall: number, widest: number) =>
    contact(walls[wall][0], walls[wall][1], shape, pose, widest)
  const names = ['floor', 'left', 'right'] as const
  const normals = { floor: [0, -1], left: [1, 0], right: [-1, 0] }

  it('are as far apart as the exact distance says, with their points on the outline: 3,000 random poses', () => {
    const random = seeded(5)
    for (let i = 0; i < 3000; i++) {
      const shape = anyShape(random)
      const quarter = random() < 0.3 ? (Math.PI / 2) * Math.floor(8 * random() - 4) : 14 * (random() - 0.5)
      const pose = { x: 900 * random(), y: 700 * random(), angle: quarter }
      const want = stageDistance(shape, pose, stage)
      names.forEach((name, wall) => {
        const [nx, ny] = normals[name]
        const { gap, points, ...normal } = meet(shape, pose, wall, Infinity)
        expect(normal.nx).toBeCloseTo(nx, 12)
        expect(normal.ny).toBeCloseTo(ny, 12)
        expect(Math.abs(gap - want[name])).toBeLessThan(exact)
        const from = name === 'floor' ? stage.height : name === 'right' ? stage.width : 0
        const depths = points.map(({ onB, gap: own }) => {
          const off = outline(shape, pose, onB)
          expect(off).toBeLessThan(exact)
          if (own === gap) expect(off).toBeGreaterThan(-exact)
          const depth = name === 'floor' ? from - onB.y : name === 'left' ? onB.x : from - onB.x
          expect(Math.abs(depth - own)).toBeLessThan(exact)
          return depth
        })
        expect(Math.abs(Math.min(...depths) - gap)).toBeLessThan(exact)
      })
    }
  })

  it('touch at the two ends of a side that lies flat, at one point of a disc', () => {
    const flat = { x: 300, y: 685.2, angle: 0 }
    const pill = { width: 80, height: 30, radius: 15 }
    const { points } = meet(pill, flat, 0, 0.5)
    const ends = points.map(({ onB }) => onB.x).sort()
    expect(ends).toEqual([expect.closeTo(275, 9), expect.closeTo(325, 9)])
    for (const point of points) expect(point.gap).toBeCloseTo(-0.2, 9)
    expect(meet({ ...pill, width: 30 }, flat, 0, 0.5).points).toHaveLength(1)
    expect(meet(pill, { ...flat, y: 684 }, 0, 0.5).points).toHaveLength(0)
  })
})

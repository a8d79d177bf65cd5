import { describe, expect, it } from 'vitest'
import { cornerRadius, type Shape } from './exact-distance'
import { bouncingDisc, flight, massOf, pillsImpact, strike, topple } from './references'
import { seeded } from './seeded'

/** Mass and inertia by cutting the shape into thin slices. */
function slicedMass(shape: Shape, slices = 20_000) {
  const r = cornerRadius(shape)
  const h = shape.height / slices
  let mass = 0
  let inertia = 0
  for (let i = 0; i < slices; i++) {
    const y = -shape.height / 2 + (i + 0.5) * h
    const up = Math.max(0, Math.abs(y) - (shape.height / 2 - r))
    const half = shape.width / 2 - r + Math.sqrt(r * r - up * up)
    mass += 2 * half * h
    inertia += h * ((2 * half ** 3) / 3 + 2 * half * y * y)
  }
  return { mass, inertia }
}

describe('the references', () => {
  it('weigh every shape as slices of it do', () => {
    const shapes = [
      { width: 40, height: 20 },
      { width: 80, height: 30, radius: 15 },
      { width: 30, height: 90, radius: 15 },
      { width: 50, height: 50, radius: 25 },
      { width: 90, height: 44, radius: 8 },
    ]
    for (const shape of shapes) {
      const exact = massOf(shape)
      const sliced = slicedMass(shape)
      expect(exact.mass / sliced.mass).toBeCloseTo(1, 5)
      expect(exact.inertia / sliced.inertia).toBeCloseTo(1, 5)
    }
    expect(massOf({ width: 10, height: 10, density: 3 }).mass).toBe(300)
  })

  it('fly as small steps through the air do', () => {
    let x = 0
    let v = -300
    const steps = 1_000_000
    const h = 1 / steps
    for (let i = 0; i < steps; i++) {
      const middle = v + (h / 2) * (2600 - 0.35 * v)
      x += h * middle
      v += h * (2600 - 0.35 * middle)
    }
    const exact = flight(-300, 2600, 0.35, 1)
    expect(exact.moved).toBeCloseTo(x, 6)
    expect(exact.speed).toBeCloseTo(v, 6)
    expect(flight(-300, 2600, 1e-9, 1).moved).toBeCloseTo(flight(-300, 2600, 0, 1).moved, 4)
  })

  it('strike by Newton and Coulomb: the normal speed is returned, friction holds or slides at its bound', () => {
    const random = seeded(5)
    let held = 0
    let slid = 0
    for (let i = 0; i < 2000; i++) {
      const { mass, inertia } = massOf({ width: 80, height: 30, radius: 15 })
      const body = {
        mass,
        inertia,
        rx: 60 * (random() - 0.5),
        ry: 15 + 20 * random(),
        vx: 1000 * (random() - 0.5),
        vy: 600 * random(),
        spin: 10 * (random() - 0.5),
      }
      const e = random()
      const friction = random()
      const un = -(body.vy + body.spin * body.rx)
      if (un >= 0) continue
      const after = strike(body, 0, -1, e, friction)
      const jn = -mass * (after.vy - body.vy)
      const jt = mass * (after.vx - body.vx)
      expect(-(after.vy + after.spin * body.rx)).toBeCloseTo(-e * un, 6)
      expect(Math.abs(jt)).toBeLessThanOrEqual(friction * jn * (1 + 1e-9))
      const slip = after.vx - after.spin * body.ry
      if (Math.abs(jt) < friction * jn * (1 - 1e-9)) {
        held++
        expect(slip).toBeCloseTo(0, 6)
      } else {
        slid++
        expect(slip * jt).toBeLessThanOrEqual(1e-6 * mass)
      }
      const turn = body.rx * (mass * (after.vy - body.vy)) - body.ry * jt
      expect((after.spin - body.spin) * inertia).toBeCloseTo(turn, 2)
    }
    expect(held).toBeGreaterThan(50)
    expect(slid).toBeGreaterThan(50)
  })

  it('strike a wall as they strike the floor', () => {
    const body = { ...massOf({ width: 80, height: 30 }), rx: 11, ry: 15, vx: 300, vy: 420, spin: 6 }
    for (const friction of [0.1, 2]) {
      const floor = strike(body, 0, -1, 0.3, friction)
      // All of it turned by a quarter: right becomes down, down becomes left.
      const turned = { ...body, rx: -body.ry, ry: body.rx, vx: -body.vy, vy: body.vx }
      const wall = strike(turned, 1, 0, 0.3, friction)
      expect(wall.vx).toBeCloseTo(-floor.vy, 9)
      expect(wall.vy).toBeCloseTo(floor.vx, 9)
      expect(wall.spin).toBeCloseTo(floor.spin, 9)
    }
  })

  it('bounce a disc without loss at e = 1, and keep it on the stage', () => {
    const start = { x: 100, y: 100, vx: 700, vy: 0, spin: 0, radius: 20 }
    const end = bouncingDisc(
      start,
      { width: 640, height: 340 },
      { gravity: 2600, bounce: 1, friction: 0 },
      7.3,
    )
    const energy = (s: { y: number; vx: number; vy: number }) => (s.vx ** 2 + s.vy ** 2) / 2 - 2600 * s.y
    expect(energy(end)).toBeCloseTo(energy(start), 4)
    // To and fro between 20 and 620, as far as without walls.
    const way = (80 + 700 * 7.3) % 1200
    expect(end.x).toBeCloseTo(20 + Math.min(way, 1200 - way), 6)
  })

  it('spin a disc that bounces off a wall with friction, as much as what rolls there takes up', () => {
    const start = { x: 500, y: 100, vx: 800, vy: 90, spin: 0, radius: 20 }
    const end = bouncingDisc(
      start,
      { width: 640, height: 340 },
      { gravity: 0, bounce: 0.5, friction: 2 },
      0.3,
    )
    // A disc that strikes without slip keeps two thirds of its speed along the wall, and rolls on it.
    expect(end.vx).toBeCloseTo(-400, 9)
    expect(end.vy).toBeCloseTo(60, 9)
    expect(Math.abs(end.spin)).toBeCloseTo(60 / 20, 9)
    expect(end.x).toBeCloseTo(620 - 400 * (0.3 - 120 / 800), 9)
  })

  it('bounce a disc as high as e² says', () => {
    const fall = Math.sqrt((2 * 200) / 2600)
    const rise = 0.5 * fall
    const start = { x: 300, y: 120, vx: 0, vy: 0, spin: 0, radius: 20 }
    const stage = { width: 640, height: 340 }
    const top = bouncingDisc(start, stage, { gravity: 2600, bounce: 0.5, friction: 0.4 }, fall + rise)
    expect(top.y).toBeCloseTo(320 - 50, 8)
    expect(top.vy).toBeCloseTo(0, 8)
  })

  it('hit one pill with another keeping momentum, angular momentum and the bounce', () => {
    const pill = { width: 80, height: 30, radius: 15 }
    const { mass, inertia } = massOf(pill)
    const { struck, striker } = pillsImpact(500, 23, pill, pill, 0.5)
    expect(struck.speed + striker.speed).toBeCloseTo(500, 9)
    expect(struck.spin * inertia).toBeCloseTo(23 * mass * (500 - striker.speed), 4)
    expect(struck.speed + 23 * struck.spin - striker.speed).toBeCloseTo(250, 9)
  })

  it('topple a pill to 1e-10 px, keeping its energy, without asking for more friction than there is', () => {
    const pill = { width: 30, height: 90, radius: 15 }
    const { mass, inertia } = massOf(pill)
    const end = topple(pill, 0.2, 2600, 28 / 60)
    const coarse = topple(pill, 0.2, 2600, 28 / 60, 24_000)
    expect(Math.abs(end.x - coarse.x)).toBeLessThan(1e-10)
    const vx = (15 + 30 * Math.cos(end.angle)) * end.spin
    const vy = 30 * Math.sin(end.angle) * end.spin
    const kinetic = (mass * (vx ** 2 + vy ** 2) + inertia * end.spin ** 2) / 2
    const fallen = mass * 2600 * (topple(pill, 0.2, 2600, 0).height - end.height)
    expect(kinetic / fallen).toBeCloseTo(1, 9)
    const h = 1e-4
    for (let t = 1 / 60; t <= 28 / 60; t += 1 / 60) {
      const at = topple(pill, 0.2, 2600, t)
      const [before, after] = [t - h, t + h].map((t) => topple(pill, 0.2, 2600, t))
      // It moves as its place does, and needs what its motion asks of the floor.
      expect((after.x - before.x) / (2 * h)).toBeCloseTo((15 + 30 * Math.cos(at.angle)) * at.spin, 2)
      const ax = (after.x - 2 * at.x + before.x) / h ** 2
      const ay = (after.height - 2 * at.height + before.height) / h ** 2
      expect(at.frictionNeeded).toBeCloseTo(Math.abs(ax) / (2600 + ay), 4)
      expect(at.frictionNeeded).toBeLessThan(0.9)
    }
  })
})

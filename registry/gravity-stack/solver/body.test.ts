import { describe, expect, it } from 'vitest'
import { massOf } from '../../../scenes/references'
import { seeded } from '../../../scenes/seeded'
import { MAX_DAMPING } from '../world'
import { setShape } from './body'
import { STEP } from './constants'
import { dampingOver, updateRotation } from './math'
import { ANGLE, Bodies, COS, INV_INERTIA, INV_MASS, SIN, STATE } from './state'

/** Area and second moment as the solver has them, for density 1. */
function weigh(width: number, height: number, radius: number, density = 1) {
  const bodies = new Bodies()
  setShape(bodies, 1, width, height, radius, density)
  return { mass: 1 / bodies.state[STATE + INV_MASS], inertia: 1 / bodies.state[STATE + INV_INERTIA] }
}

/** The same by cutting the shape into thin slices. */
function sliced(width: number, height: number, radius: number, slices = 100_000) {
  const h = height / slices
  let mass = 0
  let inertia = 0
  for (let i = 0; i < slices; i++) {
    const y = -height / 2 + (i + 0.5) * h
    const up = Math.max(0, Math.abs(y) - (height / 2 - radius))
    const half = width / 2 - radius + Math.sqrt(radius * radius - up * up)
    mass += 2 * half * h
    inertia += h * ((2 * half ** 3) / 3 + 2 * half * y * y)
  }
  return { mass, inertia }
}

describe('mass and inertia', () => {
  it('of a disc, a box and a pill are the closed forms', () => {
    const disc = weigh(50, 50, 25)
    expect(disc.mass / (Math.PI * 625)).toBeCloseTo(1, 13)
    expect(disc.inertia / ((Math.PI * 25 ** 4) / 2)).toBeCloseTo(1, 13)

    const box = weigh(80, 30, 0)
    expect(box.mass / 2400).toBeCloseTo(1, 13)
    expect(box.inertia / ((2400 * (80 ** 2 + 30 ** 2)) / 12)).toBeCloseTo(1, 13)

    const [d, r] = [25, 15]
    const [plate, caps] = [4 * d * r, Math.PI * r * r]
    const pill = weigh(2 * (d + r), 2 * r, r)
    expect(pill.mass / (plate + caps)).toBeCloseTo(1, 13)
    const inertia =
      (plate * (4 * d * d + 4 * r * r)) / 12 + caps * ((r * r) / 2 + d * d + (8 * d * r) / (3 * Math.PI))
    expect(pill.inertia / inertia).toBeCloseTo(1, 13)
  })

  it('of any rounded box are what thin slices of it add up to, tall, flat and 12:1', () => {
    for (const [width, height, radius] of [
      [90, 44, 8],
      [44, 90, 8],
      [28, 80, 14],
      [240, 20, 10],
      [20, 240, 3],
      [4, 4, 1],
    ]) {
      const exact = weigh(width, height, radius)
      const cut = sliced(width, height, radius)
      expect(exact.mass / cut.mass).toBeCloseTo(1, 6)
      expect(exact.inertia / cut.inertia).toBeCloseTo(1, 6)
    }
  })

  it('agree with the parts a shape is made of, for a thousand shapes, and scale with the density', () => {
    const random = seeded(1)
    for (let i = 0; i < 1000; i++) {
      const shape = { width: 1 + 200 * random(), height: 1 + 200 * random(), radius: 120 * random() }
      const density = 0.1 + 20 * random()
      const got = weigh(shape.width, shape.height, shape.radius, density)
      const want = massOf({ ...shape, density })
      expect(got.mass / want.mass).toBeCloseTo(1, 12)
      expect(got.inertia / want.inertia).toBeCloseTo(1, 12)
    }
  })

  it('are the same for a chip that lies and one that stands', () => {
    expect(weigh(90, 30, 10).inertia / weigh(30, 90, 10).inertia).toBeCloseTo(1, 14)
  })
})

describe('rotation', () => {
  it('is cosine and sine to 1e-15 all the way round', () => {
    const bodies = new Bodies()
    const { state, motion } = bodies
    let worst = 0
    for (let i = 0; i <= 100_000; i++) {
      const angle = -Math.PI + (2 * Math.PI * i) / 100_000
      state[ANGLE] = angle
      updateRotation(bodies, 0)
      worst = Math.max(
        worst,
        Math.abs(motion[COS] - Math.cos(angle)),
        Math.abs(motion[SIN] - Math.sin(angle)),
      )
    }
    expect(worst).toBeLessThanOrEqual(1e-15)
  })

  it('loses no more than the angle itself has lost after hundreds of turns', () => {
    const bodies = new Bodies()
    const { state, motion } = bodies
    const random = seeded(2)
    for (let i = 0; i < 10_000; i++) {
      const angle = 4000 * (random() - 0.5)
      state[ANGLE] = angle
      updateRotation(bodies, 0)
      const rounding = 1e-15 + 2.3e-16 * Math.abs(angle)
      expect(Math.abs(motion[COS] - Math.cos(angle))).toBeLessThan(rounding)
      expect(Math.abs(motion[SIN] - Math.sin(angle))).toBeLessThan(rounding)
    }
  })
})

describe('damping', () => {
  it('slows and carries as the exponential says, for any drag and any step', () => {
    for (const damping of [0.01, 0.35, 1.4, 7, MAX_DAMPING]) {
      for (const h of [STEP, STEP / 4, STEP / 16]) {
        const { fade, reach, fall } = dampingOver(damping, h)
        const lost = -Math.expm1(-damping * h)
        expect(fade).toBeCloseTo(Math.exp(-damping * h), 14)
        expect(reach / (lost / damping)).toBeCloseTo(1, 13)
        // (h − reach) / c, whose difference cancels for weak drag: compared as far as that leaves digits.
        expect(Math.abs(fall - (h - lost / damping) / damping) / (h * h)).toBeLessThan(1e-15 / (damping * h))
      }
    }
  })

  it('without drag is the parabola', () => {
    expect(dampingOver(0, 0.01)).toEqual({ fade: 1, reach: 0.01, fall: 0.01 * 0.01 * 0.5 })
  })

  it('gives the same fall in sixteen parts as in one', () => {
    const whole = dampingOver(1.4, STEP)
    const part = dampingOver(1.4, STEP / 16)
    let [x, v] = [0, 300]
    for (let k = 0; k < 16; k++) {
      x += v * part.reach + 2600 * part.fall
      v = v * part.fade + 2600 * part.reach
    }
    expect(x).toBeCloseTo(300 * whole.reach + 2600 * whole.fall, 11)
    expect(v).toBeCloseTo(300 * whole.fade + 2600 * whole.reach, 11)
  })
})

import { describe, expect, it } from 'vitest'
import type { Shape } from '../../../scenes/exact-distance'

import { massOf } from '../../../scenes/references'
import { type Chip, frame } from '../../../scenes/scene'
import { seeded } from '../../../scenes/seeded'
import { energy, overlap, readAll, run, settle, stage, worldOf } from '../testing/worlds'

function anyShape(random: () => number): Shape {
  const height = 16 + 60 * random()
  const width = random() < 0.3 ? height : 16 + 100 * random()
  const round = Math.min(width, height) / 2
  const kind = random()
  return { width, height, radius: kind < 0.5 ? round : kind < 0.75 ? round * random() : 0 }
}

/** Two chips on course for each other, far from every wall. */
function collision(random: () => number, a: Shape = anyShape(random)): [Chip, Chip] {
  const b = anyShape(random)
  const round = 2 * Math.PI * random()
  const apart = Math.hypot(a.width, a.height) / 2 + Math.hypot(b.width, b.height) / 2 + 4
  const aim = 0.5 * (random() - 0.5) * apart
  const speed = 200 + 1400 * random()
  const [nx, ny] = [Math.cos(round), Math.sin(round)]
  const drift = { vx: 400 * (random() - 0.5), vy: 400 * (random() - 0.5) }
  const chip = (shape: Shape, side: number, density: number) => ({
    ...shape,
    density,
    angle: 7 * random(),
    spin: 16 * (random() - 0.5),
    x: 5000 + (side * apart * nx - side * aim * ny) / 2,
    y: 5000 + (side * apart * ny + side * aim * nx) / 2,
    vx: drift.vx - (side * speed * nx) / 2,
    vy: drift.vy - (side * speed * ny) / 2,
  })
  return [chip(a, -1, 1), chip(b, 1, 0.1 + 5 * random() * random())]
}

type Motion = { x: number; y: number; vx: number; vy: number; spin: number }

/** Linear and angular momentum about the middle of the stage, with what they are to be compared with. */
function momentum(chips: Chip[], motions: Motion[]) {
  let [px, py, spin, size, arm] = [0, 0, 0, 0, 0]
  chips.forEach((chip, i) => {
    const { mass, inertia } = massOf(chip)
    const { x, y, vx, vy, spin: turns } = motions[i]
    px += mass * vx
    py += mass * vy
    spin += mass * ((x - 5000) * vy - (y - 5000) * vx) + inertia * turns
    size += mass * Math.hypot(vx, vy)
    arm += mass * Math.hypot(x - 5000, y - 5000) * Math.hypot(vx, vy) + inertia * Math.abs(turns)
  })
  return { px, py, spin, size, arm }
}

const space = { width: 10_000, height: 10_000, gravity: 0, linearDamping: 0, angularDamping: 0, sleep: false }

/** Plays a collision to its end and tells what it did to the momenta, as shares of what there is of them. */
function play(chips: Chip[], options: { bounce: number; friction: number }) {
  const { world, ids } = worldOf(chips, { ...space, ...options, bounceThreshold: 0 })
  const before = momentum(chips, readAll(world, ids))
  let kinetic = energy(world, ids, chips, 0)
  let was = world.read(ids[0])
  let hits = 0
  for (let k = 0; k < 30; k++) {
    world.step(frame)
    const is = world.read(ids[0])
    if (is.vx !== was.vx || is.vy !== was.vy || is.spin !== was.spin) hits++
    was = is
    const now = energy(world, ids, chips, 0)
    expect(now / kinetic).toBeLessThan(1 + 1e-12)
    kinetic = now
  }
  const after = momentum(chips, readAll(world, ids))
  return {
    hits,
    linear: Math.hypot(after.px - before.px, after.py - before.py) / before.size,
    angular: Math.abs(after.spin - before.spin) / before.arm,
  }
}

describe('two free chips that collide', () => {
  it('keep their momentum to 1e-9 and gain no energy, whatever bounce and friction: 500 collisions', () => {
    const random = seeded(1)
    const angular: number[] = []
    for (let i = 0; i < 500; i++) {
      const result = play(collision(random), { bounce: random(), friction: random() })
      if (result.hits === 0) continue
      expect(result.linear).toBeLessThan(1e-9)
      angular.push(result.angular)
    }
    expect(angular.length).toBeGreaterThan(400)
    // Corners that turn fast come a little deep within a sub-step: to push two apart moves them, and their
    // momenta with them.
    expect(angular.filter((error) => error < 1e-9).length / angular.length).toBeGreaterThan(0.93)
    expect(Math.max(...angular)).toBeLessThan(5e-3)
  })

  it('keep their angular momentum to 1e-9 where they hit in one point: 300 discs into anything', () => {
    const random = seeded(2)
    let met = 0
    for (let i = 0; i < 300; i++) {
      const chips = collision(random, { width: 40, height: 40, radius: 20 })
      const { hits, linear, angular } = play(chips, { bounce: random(), friction: random() })
      if (hits !== 1) continue
      met++
      expect(linear).toBeLessThan(1e-9)
      expect(angular).toBeLessThan(1e-9)
    }
    expect(met).toBeGreaterThan(200)
  })

  it('part as fast as they met at e = 1, and at half that speed at e = 0.5', () => {
    for (const bounce of [1, 0.5]) {
      const disc = { width: 30, height: 30, radius: 15, angle: 0, y: 5000 }
      const chips = [
        { ...disc, x: 4900, vx: 700 },
        { ...disc, x: 5100, vx: -300, density: 3 },
      ]
      const { world, ids } = worldOf(chips, { ...space, bounce })
      for (let k = 0; k < 30; k++) world.step(frame)
      expect(world.read(ids[1]).vx - world.read(ids[0]).vx).toBeCloseTo(1000 * bounce, 9)
    }
  })
})

describe('a chip that lands', () => {
  it('bounces above the threshold and not below it', () => {
    for (const [speed, up] of [
      [100, 50],
      [80, 0],
    ]) {
      const { world, ids } = worldOf(
        [{ width: 30, height: 30, radius: 15, x: 300, y: 324.9, angle: 0, vy: speed }],
        {
          gravity: 0,
          bounce: 0.5,
          bounceThreshold: 90,
          linearDamping: 0,
        },
      )
      world.step(frame)
      expect(world.read(ids[0]).vy).toBeCloseTo(-up, 6)
    }
  })

  it.each([
    ['loses no energy', 1, 1 - 1e-9],
    ['loses a tenth of its energy at most', 2, 0.9],
    ['loses a tenth of its energy at most', 3, 0.9],
  ])('%s and gains none in 10 s at e = 1 without friction, %i discs in a box', (_, count, least) => {
    const chips = Array.from({ length: count }, (_, i) => ({
      width: 40,
      height: 40,
      radius: 20,
      x: 120 + 180 * i,
      y: 100 + 20 * i,
      angle: 0,
      vx: 300 - 200 * i,
    }))
    const options = { bounce: 1, friction: 0, bounceThreshold: 0, linearDamping: 0, angularDamping: 0 }
    const { world, ids } = worldOf(chips, { ...options, sleep: false })
    const put = energy(world, ids, chips)
    for (let k = 0; k < 600; k++) {
      world.step(frame)
      expect(energy(world, ids, chips) / put).toBeLessThan(1 + 1e-9)
    }
    expect(energy(world, ids, chips) / put).toBeGreaterThan(least)
  })
})

describe('a box that falls over onto its long side', () => {
  it.each([0.3, 0.5, 0.8])(
    'comes up again about the end it stood on, by e² of the height, e = %d',
    (bounce) => {
      const angle = 0.5
      const rise = (turn: number) => 50 * Math.sin(turn) + 10 * (Math.cos(turn) - 1)
      const box = { width: 100, height: 20, x: 320, y: stage.height - 10 - rise(angle), angle }
      const options = { bounce, friction: 5, linearDamping: 0, angularDamping: 0, sleep: false }
      const { world, ids } = worldOf([box], options)
      while (world.read(ids[0]).angle > 0.1) world.step(frame)
      while (world.read(ids[0]).spin < 0) world.step(frame)
      let highest = 0
      while (world.read(ids[0]).spin > 0) {
        highest = Math.max(highest, world.read(ids[0]).angle)
        world.step(frame)
      }
      // Frames may miss its highest turn.
      expect(rise(highest) / (bounce ** 2 * rise(angle))).toBeCloseTo(0.96, 1)
      expect(rise(highest)).toBeLessThan(1.01 * bounce ** 2 * rise(angle))
    },
  )
})

describe('a box that slides on one corner and comes down on its side', () => {
  // Friction follows every push: a solver that over-relaxes each push would swing between two answers.
  it.each([90, -90, 200])('does so on a chip of 180 times its weight as on the floor, at %i px/s', (vx) => {
    const floor = stage.height - 65
    const [cos, sin] = [Math.cos(0.05), Math.sin(0.05)]
    const spin = -7
    const box = { width: 15, height: 13, x: 320, angle: 0.05, vx, spin }
    // On its lower right corner, which goes along the floor.
    const landing = { ...box, y: floor - 7.5 * sin - 6.5 * cos, vy: -spin * (7.5 * cos - 6.5 * sin) }
    const options = { linearDamping: 0, angularDamping: 0 }
    const alone = worldOf([landing], { ...options, height: floor })
    const large = worldOf([{ width: 545, height: 65, x: 320, y: floor + 32.5, angle: 0 }], options)
    settle(large.world)
    const id = large.world.add(landing)
    for (let k = 1; k <= 3; k++) {
      alone.world.step(frame)
      large.world.step(frame)
      const there = alone.world.read(alone.ids[0])
      const here = large.world.read(id)
      expect(Math.abs(here.spin - there.spin), `after ${k} frames`).toBeLessThan(0.5)
      expect(Math.hypot(here.x - there.x, here.y - there.y), `after ${k} frames`).toBeLessThan(0.02)
    }
  })
})

describe('within one sub-step', () => {
  it('eight pills that fall upon each other at 1400 to 1800 px/s, turning, go 1.4 px into each other at worst of 100 times', () => {
    const random = seeded(8)
    const depths = Array.from({ length: 100 }, () =>
      deepest(
        Array.from({ length: 8 }, (_, i) => ({
          width: 60 + 60 * random(),
          height: 28,
          radius: 14,
          x: 320 + 60 * (random() - 0.5),
          y: 300 - 45 * i,
          angle: 0.6 * (random() - 0.5),
          vy: 1400 + 400 * random(),
          spin: 40 * (random() - 0.5),
        })),
      ),
    )
    expect(Math.max(...depths)).toBeLessThan(1.4)
    expect(depths.sort((a, b) => a - b)[50]).toBeLessThan(0.35)
  })

  it('a chip that comes along with another is stopped after it, 0.1 px deep at most', () => {
    for (let from = 0; from < 8; from++) {
      const box = { width: 60, height: 30, angle: 0, vy: 1900 }
      const chips = [0, 1].map((i) => ({ ...box, x: 320, y: 250 + from - 31.5 * i }))
      expect(deepest(chips)).toBeLessThan(0.1)
    }
  })

  it('a chip that comes along with a pill is stopped after both its ends have hit, 0.2 px deep at most', () => {
    for (let from = 0; from < 30; from += 2) {
      const chips = [
        { width: 106, height: 28, radius: 14, x: 320, y: 270 + from, angle: 0.01, vy: 1780 },
        { width: 58, height: 28, radius: 14, x: 305, y: 232.3 + from, angle: -0.52, vy: 1780 },
      ]
      expect(deepest(chips, 3), `from ${from} px on`).toBeLessThan(0.2)
    }
  })

  it('a pill that comes down nearly flat hits with its lower end first, and turns as in sub-steps an eighth as long', () => {
    for (const angle of [0.02, 0.05, 0.1, -0.1]) {
      const pill = { width: 47, height: 28, radius: 14, x: 320, y: 300, angle, vy: 1280 }
      const [[as], [fine]] = afterTwoFrames([pill], stage)
      expect(Math.abs(as.spin - fine.spin), `at ${angle} rad`).toBeLessThan(1)
      expect(Math.hypot(as.vx - fine.vx, as.vy - fine.vy), `at ${angle} rad`).toBeLessThan(5)
    }
  })

  it('a box that comes down on one corner is held back by friction there, wherever its next corner is', () => {
    const [bounce, friction] = [0.18, 0.4]
    for (const angle of [0.2, 0.36, 0.5, 1.2]) {
      const box = { width: 12, height: 13, x: 320, y: 280, angle, vy: 1720 }
      const { world, ids } = worldOf([box], {
        bounce,
        friction,
        gravity: 0,
        linearDamping: 0,
        angularDamping: 0,
      })
      const { mass, inertia } = massOf(box)
      // Its lowest corner, from its centre.
      const x = 6 * Math.cos(angle) - 6.5 * Math.sin(angle)
      const y = 6 * Math.sin(angle) + 6.5 * Math.cos(angle)
      const kn = 1 / mass + (x * x) / inertia
      const kt = 1 / mass + (y * y) / inertia
      const coupling = (x * y) / inertia
      // Share of the push up that friction gives aside: what stops the corner, or as much as Coulomb allows.
      const share = Math.max(-friction, Math.min(friction, -coupling / kt))
      const push = ((1 + bounce) * box.vy) / (kn + share * coupling)
      while (world.read(ids[0]).vy === box.vy) world.step(frame)
      const { vx, spin } = world.read(ids[0])
      expect(vx, `at ${angle} rad`).toBeCloseTo((share * push) / mass, 6)
      expect(spin, `at ${angle} rad`).toBeCloseTo((-push * (x + share * y)) / inertia, 6)
    }
  })

  it('a pill that hits another chip and then the floor is turned by the first hit before it comes to the second', () => {
    const chips = [
      {
        width: 47,
        height: 29,
        radius: 14.5,
        x: 385.33,
        y: 411.86,
        angle: 4.4475,
        vx: -245.4,
        vy: 1997.3,
        spin: 1.13,
      },
      { width: 374, height: 10, radius: 5, x: 189.95, y: 439, angle: 0 },
    ]
    const [as, fine] = afterTwoFrames(chips, { width: 880, height: 444 })
    expect(fine[0].spin).toBeGreaterThan(9)
    expect(Math.abs(as[0].spin - fine[0].spin)).toBeLessThan(1)
    expect(Math.hypot(as[0].vx - fine[0].vx, as[0].vy - fine[0].vy)).toBeLessThan(20)
  })

  it('a chip that has parted from another feels nothing of what that one hits next', () => {
    const chips = [
      {
        width: 49,
        height: 75,
        radius: 24.5,
        x: 813.814,
        y: 539.404,
        angle: 1.33631,
        vx: -220.43,
        vy: -131.29,
        spin: -8.057,
      },
      {
        width: 39,
        height: 16,
        radius: 8,
        x: 775.72,
        y: 500.104,
        angle: 0.951707,
        vx: -167.05,
        vy: 1024.71,
        spin: 0.348,
      },
    ]
    const [as, fine] = afterTwoFrames(chips, { width: 885, height: 567 })
    expect(Math.abs(as[1].spin - fine[1].spin)).toBeLessThan(0.5)
    expect(Math.hypot(as[1].vx - fine[1].vx, as[1].vy - fine[1].vy)).toBeLessThan(10)
  })

  it('a pill that is struck into a spin above the floor meets the floor with its end, and is not pressed into what struck it', () => {
    for (let over = 6; over < 20; over += 2) {
      const pill = { width: 86, height: 28, radius: 14, x: 320, y: stage.height - 14 - over, angle: 0 }
      const bullet = { width: 28, height: 28, radius: 14, x: 350, y: pill.y - 40, angle: 0, vy: 3000 }
      expect(deepest([pill, bullet], 3), `${over} px over it`).toBeLessThan(0.1)
    }
  })

  it('a pill that lands on one end lands on the other, 0.1 px deep at most', () => {
    const plate = { width: 300, height: 40, density: 1000, angle: 0, x: 320, y: stage.height - 20 }
    for (let from = 0; from < 16; from++) {
      const pill = { width: 110, height: 28, radius: 14, x: 320, y: 200 + 1.7 * from, angle: 0.02, vy: 2000 }
      expect(deepest([plate, pill])).toBeLessThan(0.1)
    }
  })
})

/** A bullet that is `61 + from` px short of a box, and a plate `gap` px behind that. */
function bulletBoxPlate(from: number, gap: number) {
  const box = { width: 30, height: 30, y: 200, angle: 0 }
  return [
    { ...box, x: 500 - 91 - from, vx: 3600 },
    { ...box, x: 500 },
    { width: 4, height: 200, x: 517 + gap, y: 200, angle: 0 },
  ]
}

describe('what a bullet knocks away', () => {
  it.each([17, 20, 30])(
    'meets a plate that stands %i px behind it within the same step, and goes 1 px into it at most',
    (gap) => {
      for (let from = 0; from < 60; from += 5) {
        const chips = bulletBoxPlate(from, gap)
        const still = { gravity: 0, bounce: 1, linearDamping: 0 }
        const { world, ids } = worldOf(chips, { width: 2000, height: 400, ...still })
        // The bullet is there after 61 px and some, and 60 px is a step.
        world.step(2 * frame)
        expect(world.read(ids[1]).x).toBeGreaterThan(500)
        expect(overlap(world, ids, chips, { width: 2000, height: 400 })).toBeLessThan(1)
      }
    },
  )

  it.each([9, 17, 20, 30])('does not go through a plate of 4 px that stands %i px behind it', (gap) => {
    for (const bounce of [0.18, 1]) {
      for (let from = 0; from < 60; from += 5) {
        const chips = bulletBoxPlate(from, gap)
        const { world, ids } = worldOf(chips, { width: 2000, height: 400, gravity: 0, bounce })
        for (let k = 0; k < 12; k++) {
          world.step(frame)
          const [, knocked, plate] = readAll(world, ids)
          expect(knocked.x).toBeLessThan(plate.x)
        }
      }
    }
  })
})

it('a chip thrown into a row sets off one after the other and none goes into the next, in whatever order they were added', () => {
  for (const gap of [2.5, 4, 6]) {
    const box = { width: 40, height: 40, y: 320, angle: 0 }
    const row = [0, 1, 2, 3, 4, 5].map((n) => ({ ...box, x: 600 + n * (40 + gap) }))
    const chips = [{ ...box, x: 559, vx: 1800 }, ...row]
    for (const order of [chips, chips.toReversed()]) {
      const wide = { width: 2000, height: 340 }
      const { world, ids } = worldOf(order, { ...wide, gravity: 0, linearDamping: 0 })
      for (let k = 0; k < 20; k++) {
        world.step(frame)
        expect(overlap(world, ids, order, wide), `${gap} px apart`).toBeLessThan(0.2)
      }
    }
  }
})

it('a card thrown at a chip with another behind it goes into neither, and what flies close behind the card not into that', () => {
  const card = { width: 240, height: 160, radius: 8, y: 400, angle: 0 }
  const pill = { width: 60, height: 36, radius: 18, y: 400, angle: 0 }
  const wide = { width: 3000, height: 800 }
  for (const vx of [1800, 3000]) {
    for (let gap = 1; gap < 40; gap += 3) {
      for (const short of [0.5, 7, 22]) {
        const x = 800 + 150 + short
        const pills = [
          { ...pill, x },
          { ...pill, x: x + 60 + gap },
        ]
        const chips = [{ ...card, x: 559, vx }, { ...card, x: 800, vx }, ...pills]
        const { world, ids } = worldOf(chips, { ...wide, gravity: 0 })
        let most = 0
        for (let k = 0; k < 8; k++) {
          world.step(frame)
          most = Math.max(most, overlap(world, ids, chips, wide))
        }
        expect(most, `${gap} px behind, at ${vx} px/s`).toBeLessThan(0.5)
      }
    }
  }
})

it('a large card that lands on a small one goes 1 px into it at most, however it comes', () => {
  const small = { width: 24, height: 24, radius: 6, x: 320, y: stage.height - 12, angle: 0 }
  for (let drop = 0; drop <= 120; drop += 15) {
    for (const vy of [0, 600]) {
      for (const aside of [0, 7]) {
        const y = stage.height - 24 - drop - 80
        const chips = [small, { width: 160, height: 160, radius: 6, x: 320 + aside, y, angle: 0, vy }]
        expect(deepest(chips, 60), `from ${drop} px at ${vy} px/s`).toBeLessThan(1)
      }
    }
  }
})

it('a chip thrown at a row is stopped by it, and passes through none of its chips', () => {
  const long = { width: 2000, height: 300 }
  const rows = [
    { width: 60, height: 80, radius: 0, angle: 0, into: 8, vx: 1800 },
    { width: 120, height: 28, radius: 14, angle: 0, into: 28, vx: 3600 },
  ]
  for (const { into, vx, ...thrown } of rows) {
    for (let gap = 8; gap < 28; gap += 1.7) {
      for (const x of [100, 113, 131, 148]) {
        const y = 300 - thrown.height / 2
        const radius = Math.min(thrown.radius, into / 2)
        const row = [0, 1, 2, 3, 4].map((n) => ({
          ...thrown,
          width: into,
          radius,
          x: 320 + n * (into + gap),
          y,
        }))
        const chips = [{ ...thrown, x, y: y - 3, vx }, ...row]
        const { world, ids } = worldOf(chips, long)
        for (let k = 0; k < 18; k++) {
          world.step(frame)
          expect(overlap(world, ids, chips, long), `${into} px wide, ${gap} px apart`).toBeLessThan(1.2)
        }
      }
    }
  }
})

/** Bars, plates, specks and chips, one above the other. */
function oddPour(seed: number) {
  const r = seeded(seed * 97)
  const pick = (values: number[]) => values[Math.floor(values.length * r())]
  const options = { friction: pick([0.4, 0.4, 0.2, 1]), bounce: pick([0.18, 0, 0.4]) }
  let top = 320
  const chips: Chip[] = Array.from({ length: 5 + Math.floor(25 * r()) }, () => {
    const kind = r()
    const width = kind < 0.2 ? 2 + 6 * r() : kind < 0.4 ? 100 + 200 * r() : 10 + 80 * r()
    const height = kind < 0.4 && r() < 0.5 ? 1 + 3 * r() : kind < 0.2 ? 2 + 6 * r() : 8 + 50 * r()
    const reach = Math.hypot(width, height) / 2
    top -= 2 * reach + 2
    const radius = Math.min(pick([0, 1000, 3]), width / 2, height / 2)
    return { width, height, radius, x: reach + (640 - 2 * reach) * r(), y: top + reach, angle: 6.3 * r() }
  })
  return { chips, options }
}

it.each([177, 38])(
  'a bar struck into a spin is not put back behind what it has bounced off: pour %i',
  (seed) => {
    const { chips, options } = oddPour(seed)
    const { world, ids } = worldOf(chips, options)
    for (let k = 0; k < 120; k++) {
      world.step(frame)
      expect(overlap(world, ids, chips), `frame ${k}`).toBeLessThan(3)
    }
  },
)

it('a card that strikes a flat chip into the floor at 2400 px/s goes 4 px into it at most', () => {
  const tall = { width: 640, height: 700 }
  for (const vx of [-600, 0, 600]) {
    for (const above of [4, 8, 14, 20]) {
      for (const short of [1, 14, 27]) {
        const chip = { width: 120, height: 18, radius: 6, x: 320, y: 700 - 9 - above, angle: 0 }
        // Half as high as it stands on a corner.
        const high = 160 * Math.sin(1) + 115 * Math.cos(1)
        const card = { width: 320, height: 230, radius: 10, angle: -1, vx, vy: 2400 }
        const chips = [chip, { ...card, x: 320, y: chip.y - 9 - high - short }]
        const { world, ids } = worldOf(chips, tall)
        for (let k = 0; k < 20; k++) {
          world.step(frame)
          const deep = overlap(world, ids, chips, tall)
          expect(deep, `${above} px above the floor, ${short} px below the card`).toBeLessThan(4)
        }
      }
    }
  }
})

it('a chip that falls ever faster meets the floor in the step that takes it there', () => {
  // Each starts a little higher: some come down to where their speed alone would just not take them.
  for (let from = 0; from < 40; from++) {
    const chip = { width: 60, height: 30, x: 320, y: 100 - from, angle: 0 }
    const { world, ids } = worldOf([chip], { gravity: 18_000, linearDamping: 0 })
    const put = energy(world, ids, [chip], 18_000)
    for (let k = 0; k < 20; k++) {
      world.step(frame)
      expect(energy(world, ids, [chip], 18_000) / put).toBeLessThan(1 + 1e-9)
    }
  }
})

/**
 * What chips in a stage of this size come to in two frames, in usual sub-steps and in ones an eighth as long.
 */
function afterTwoFrames(chips: Chip[], size: { width: number; height: number }) {
  return [6, 48].map((substeps) => {
    const { world, ids } = worldOf(chips, { ...size, substeps })
    run(world, 2 * frame)
    return readAll(world, ids)
  })
}

/** px, the deepest that these chips are in each other or a wall after any of the first frames. */
function deepest(chips: Chip[], frames = 8) {
  const { world, ids } = worldOf(chips)
  let most = 0
  for (let k = 0; k < frames; k++) {
    world.step(frame)
    most = Math.max(most, overlap(world, ids, chips))
  }
  return most
}

describe('a box on a level row of boxes', () => {
  const block = { width: 60, height: 40, radius: 0, angle: 0 }
  const still = { linearDamping: 0, angularDamping: 0 }

  /**
   * A row with joints of `joint` px, a box with corners of `radius` px that slides along it, and how much
   * slower it gets than friction makes it.
   */
  function slide(speed: number, friction: number, joint: number, radius: number) {
    const row = Array.from({ length: 12 }, (_, i) => ({ ...block, x: 40 + i * (60 + joint), y: 320 }))
    const slider = { width: 50, height: 30, radius, angle: 0, x: 40, y: 285, vx: speed }
    const { world, ids } = worldOf([slider, ...row], { ...still, width: 1000, friction })
    let slowed = 0
    for (let k = 1; k <= 120 && world.read(ids[0]).x < row[11].x; k++) {
      world.step(frame)
      slowed = Math.max(slowed, speed - friction * 2600 * k * frame - world.read(ids[0]).vx)
      if (speed < friction * 2600 * (k + 1) * frame) break
    }
    return slowed
  }

  it.each([0, 3, 10])('slides over joints of %i px as over a floor, however sharp its corners', (joint) => {
    for (const radius of [0, 0.25, 1, 2])
      for (const friction of [0, 0.4])
        for (const speed of [150, 500, 1250]) {
          const slowed = slide(speed, friction, joint, radius)
          expect(slowed, `${speed} px/s, ${friction}, ${radius} px`).toBeLessThan(radius > 0 ? 25 : 8)
        }
  })

  it('falls along a wall of boxes as through the air', () => {
    const wall = Array.from({ length: 15 }, (_, i) => ({
      ...block,
      x: 500 + 0.02 * (i % 2),
      y: 780 - 40 * i,
    }))
    const { world, ids } = worldOf(wall, { ...still, width: 1000, height: 800, friction: 0 })
    run(world, 1)
    const id = world.add({ ...block, x: world.read(ids[14]).x - 60, y: 220, vy: 100 })
    run(world, 0.5)
    expect(Math.abs(world.read(id).vy - 1400)).toBeLessThan(15)
  })

  it('still hits the next one that stands a pixel higher', () => {
    const row = Array.from({ length: 6 }, (_, i) => ({
      ...block,
      height: i > 2 ? 41 : 40,
      x: 40 + 60 * i,
      y: i > 2 ? 319.5 : 320,
      density: 1000,
    }))
    const { world, ids } = worldOf([...row, { ...block, x: 44, y: 280, vx: 400 }], { ...still, friction: 0 })
    run(world, 1)
    expect(world.read(ids[6]).vx).toBeLessThan(30)
  })

  it('hits another corner to corner, and does not go into it', () => {
    for (const off of [-0.1, -0.05, 0, 0.05, 0.1])
      for (const slope of [0, 0.05, 0.2, 1])
        for (const speed of [300, 3000]) {
          const chips = [
            { ...block, x: 2000, y: 2000 },
            { ...block, x: 1890, y: 1960 + off - 50 * slope, vx: speed, vy: slope * speed },
          ]
          const { world, ids } = worldOf(chips, { ...still, gravity: 0, width: 4000, height: 4000 })
          for (let k = 0; k < 20; k++) {
            world.step(frame)
            expect(overlap(world, ids, chips, { width: 4000, height: 4000 })).toBeLessThan(1)
          }
        }
  })
})

import { describe, expect, it } from 'vitest'
import { halfExtent } from '../../../scenes/exact-distance'
import { hardScenes } from '../../../scenes/hard'
import { pourChips, pourStage } from '../../../scenes/piles'
import { type Chip, frame } from '../../../scenes/scene'
import { seeded } from '../../../scenes/seeded'
import { standing } from '../../../scenes/standing'
import { overlap, readAll, run, settle, stage, worldOf } from '../testing/worlds'

const box = { width: 60, height: 40, angle: 0 }
const pill = { width: 80, height: 30, radius: 15, angle: 0 }
const floor = stage.height

/** Boxes on each other, the lowest first. */
const tower = (count: number, x = 320) =>
  Array.from({ length: count }, (_, i) => ({ ...box, x, y: floor - 40 * (i + 0.5) }))

function asleep(chips: Parameters<typeof worldOf>[0]) {
  const made = worldOf(chips)
  expect(settle(made.world)).toBeLessThan(360)
  return made
}

/**
 * Frames of 300 in which a chip is slower than 20 px/s and does not stand, that sets out on a card with a
 * slope of `rise` in 400, `along` px from its middle, at `speed` px/s. `walled` cards have their lower end at
 * a wall: steep ones would slide.
 */
function creeping(
  rise: number,
  chip: Omit<Chip, 'x' | 'y' | 'angle'>,
  along: number,
  speed: number,
  walled = false,
) {
  const angle = Math.atan(rise / 400)
  const [c, s] = [Math.cos(angle), Math.sin(angle)]
  // From the middle of the card's top side: `along` it and `up` from it.
  const at = (along: number, up: number) => ({
    x: 340 + 20 * s + along * c + up * s,
    y: floor - 60 - rise / 2 - 20 * c + along * s - up * c,
    angle,
  })
  const { world, ids } = worldOf(
    [
      { width: 40, height: 60 + rise, x: 120, y: floor - (60 + rise) / 2, angle: 0, density: 100 },
      { width: 40, height: 60, x: 520, y: floor - 30, angle: 0, density: 100 },
      { width: 460, height: 20, ...at(0, -10), density: 20 },
      { ...chip, ...at(along, chip.height / 2), vx: speed * c, vy: speed * s },
    ],
    walled ? { width: at(230, 0).x } : {},
  )
  let slow = 0
  for (let k = 0; k < 300; k++) {
    world.step(frame)
    const { vx, vy } = world.read(ids[3])
    const now = Math.hypot(vx, vy)
    if (now > 0.5 && now < 10) slow++
  }
  return slow
}

describe('a pile falls asleep', () => {
  it('as a whole: a tower is either awake or asleep', () => {
    const { world, ids } = worldOf([...tower(4), { ...pill, x: 320, y: 60 }])
    for (let k = 0; k < 360 && !world.resting; k++) {
      world.step(frame)
      const sleeping = readAll(world, ids.slice(0, 4)).filter((body) => body.asleep).length
      expect([0, 4]).toContain(sleeping)
    }
    expect(world.resting).toBe(true)
  })

  it('but for a chip that was struck in that very moment, which flies off as any other', () => {
    const lying = { ...pill, x: 1000, y: floor - 15 }
    const struckAfter = (frames: number) => {
      const { world, ids } = worldOf([lying], { width: 5000 })
      for (let k = 0; k < frames; k++) world.step(frame)
      world.add({ ...lying, x: 920 - 1500 * frame * 2.9, vx: 1500 })
      run(world, 2)
      return world.read(ids[0]).x - lying.x
    }
    const far = struckAfter(10)
    expect(far).toBeGreaterThan(200)
    for (let frames = 20; frames < 34; frames++) expect(struckAfter(frames) / far).toBeCloseTo(1, 1)
  })

  it('but not a chip on one corner or end, leaning on nothing', () => {
    const corner = Math.PI / 2 - Math.atan2(28, 80)
    for (const [radius, balance, lean] of [
      [0, corner, 1],
      [8, corner, 2],
      [14, Math.PI / 2, 2],
    ]) {
      const shape = { width: 80, height: 28, radius }
      const angle = balance - (lean * Math.PI) / 180
      const y = stage.height - halfExtent(shape, angle)[1]
      const { world, ids } = worldOf([{ ...shape, x: 320, y, angle }])
      settle(world)
      expect(Math.abs(Math.sin(world.read(ids[0]).angle)), `radius ${radius}`).toBeLessThan(0.01)
    }
  })

  it('nor a badge about to topple in a pile, nor a word that leans on another one there', () => {
    for (const [kind, count, seed] of [
      ['badges', 60, 47],
      ['words', 300, 8],
    ] as const) {
      const chips = pourChips(kind, count, seed)
      const { world, ids } = worldOf(chips, pourStage(count))
      settle(world)
      expect(world.resting, kind).toBe(true)
      expect(standing(chips, readAll(world, ids), pourStage(count)), kind).toBe(0)
    }
  })

  it('nor one that stands on another chip, on a round end or on a corner', () => {
    const lying = { width: 200, height: 36, radius: 18, x: 320, y: floor - 18, angle: 0 }
    for (const [width, radius] of [
      [63, 18],
      [100, 18],
      [63, 8],
    ])
      for (const lean of [-4, -2, -0.5, 0.5, 2, 4]) {
        const shape = { width, height: 36, radius }
        const balance = radius < 18 ? Math.atan2(width - 2 * radius, 36 - 2 * radius) : Math.PI / 2
        const angle = balance + (lean * Math.PI) / 180
        const y = floor - 36 - halfExtent(shape, angle)[1]
        const { world, ids } = worldOf([lying, { ...shape, x: 320, y, angle }])
        expect(settle(world)).toBeLessThan(240)
        const off = Math.abs(Math.sin(world.read(ids[1]).angle - balance))
        expect(off, `${width} px long, corners of ${radius}, ${lean}° off its balance`).toBeGreaterThan(0.3)
      }
  })

  it('but what rolls down a slope, which stops or rolls away at any slope: one as steep as rolling resistance is strong let it creep for ever', () => {
    const disc = { width: 36, height: 36, radius: 18, spin: 5 / 18 }
    for (let rise = 16; rise <= 40; rise++)
      expect(creeping(rise, disc, -100, 5), `a slope of ${rise} in 400`).toBeLessThan(150)
  })

  it('and what slides down one, at any slope: one as steep as friction is strong let it creep for ever', () => {
    const badge = { width: 60, height: 30, radius: 8 }
    for (let rise = 150; rise <= 190; rise += 0.5)
      expect(creeping(rise, badge, -150, 10, true), `a slope of ${rise} in 400`).toBeLessThan(60)
  })

  it('with all its speed gone', () => {
    const { world, ids } = asleep(tower(3))
    for (const { vx, vy, spin } of readAll(world, ids)) expect([vx, vy, spin]).toEqual([0, 0, 0])
  })

  it('but not in the air, at the top of its way up', () => {
    const { world, ids } = worldOf([{ ...pill, x: 320, y: 200, vy: -300 }], { gravity: 300 })
    run(world, 1.2)
    expect(world.read(ids[0]).asleep).toBe(false)
  })

  it('within 5 s, though nearly round chips rock on each other in it: 36 narrow stages', () => {
    for (let seed = 153; seed <= 188; seed++) {
      const random = seeded(seed)
      const options = { width: 110 + 80 * random() }
      const chips = Array.from({ length: 30 }, (_, i) => {
        const size = 26 + 20 * random()
        const disc = random() < 0.5
        const height = disc ? size : size * (0.7 + 0.6 * random())
        const radius = disc ? size / 2 : 4 + 8 * random()
        return { width: size, height, radius, x: 30 + 50 * random(), y: 300 - 40 * i, angle: 6 * random() }
      })
      expect(settle(worldOf(chips, options).world)).toBeLessThan(300)
    }
  })

  it('within 6 s, and no chip in another, though twice its area was crammed into the stage: jams that crept apart for ten', () => {
    const { build, conditions, width, height } = hardScenes.find(({ name }) => name === 'crammed')!
    for (const seed of [88, 331]) {
      const chips = build(seed)
      const { world, ids } = worldOf(chips, { ...conditions, width, height })
      expect(settle(world), `seed ${seed}`).toBeLessThan(360)
      expect(overlap(world, ids, chips, { width, height }), `seed ${seed}`).toBeLessThan(0.05)
    }
  })

  it('though its chips are a hair higher than their round ends: fractions of a pixel, as browsers lay out', () => {
    for (const more of [1e-13, 1e-3, 1 / 64, 1 / 16, 1 / 2]) {
      for (let seed = 1; seed <= 6; seed++) {
        const chips = pourChips('pills', 40, seed).map((chip) => ({
          ...chip,
          height: chip.height + more,
          radius: chip.height / 2,
        }))
        const { world, ids } = worldOf(chips)
        expect(settle(world), `${more} px higher, seed ${seed}`).toBeLessThan(360)
        expect(overlap(world, ids, chips), `${more} px higher, seed ${seed}`).toBeLessThan(0.05)
      }
    }
  })

  it('though the stage has become narrower than any of its chips at any turn', () => {
    const chips = [60, 180, 300, 420].map((x) => ({ ...pill, x, y: floor - 15 }))
    const disc = { width: 30, height: 30, radius: 15, x: 560, y: floor - 15, angle: 0 }
    for (const width of [29, 10, 1]) {
      const { world } = worldOf([...chips, disc])
      world.resize(width, stage.height)
      expect(settle(world, 600), `${width} px`).toBeLessThan(600)
    }
  })

  it('not where it leans, when what held it up goes just before it would', () => {
    for (let frames = 24; frames < 33; frames++) {
      const { world, ids } = worldOf([
        { width: 60, height: 60, x: 290, y: floor - 30, angle: 0 },
        { width: 20, height: 60, x: 410, y: floor - 30, angle: 0 },
        { width: 200, height: 20, x: 326, y: floor - 70, angle: 0 },
      ])
      for (let k = 0; k < frames; k++) world.step(frame)
      world.remove(ids[1])
      settle(world)
      expect(world.read(ids[2]).angle, `after ${frames} frames`).toBeGreaterThan(0.1)
    }
  })

  it('not where it leans on a chip in a hand, once the hand lets go', () => {
    for (let width = 220; width < 280; width += 5) {
      const { world, ids } = worldOf([
        { width: 60, height: 60, radius: 30, x: 320, y: 160, angle: 0 },
        { width, height: 40, radius: 20, x: 380, y: 120 - width / 2, angle: 1.2 },
      ])
      const hand = world.grab(ids[0], 320, 160)
      run(world, 4)
      hand.release()
      settle(world, 600)
      const { x, y } = world.read(ids[1])
      // Awake again it stays: it lies on the floor, or against a wall, and not in the air.
      world.configure({})
      run(world, 1)
      const after = world.read(ids[1])
      expect(Math.hypot(after.x - x, after.y - y), `${width} px`).toBeLessThan(1)
    }
  })

  it('without gravity too, wherever its chips float', () => {
    const chips = [100, 400].map((x) => ({ ...pill, x, y: 100 }))
    expect(settle(worldOf(chips, { gravity: 0 }).world, 120)).toBeLessThan(120)
  })

  it('even a chip that fits between the walls at no turn', () => {
    const { world } = worldOf([{ width: 700, height: 660, x: 320, y: 0, angle: 0.1 }])
    expect(settle(world, 600)).toBeLessThan(600)
  })

  it('by and by and not at a stroke, though its chips bounce: nothing takes a slow pile’s speed in one step', () => {
    for (let seed = 1; seed <= 12; seed++) {
      const { world, ids } = worldOf(pourChips('mixed', 60, seed), { ...pourStage(60), bounce: 0.5 })
      let before = readAll(world, ids)
      for (let k = 0; k < 400 && !world.resting; k++) {
        world.step(frame)
        const after = readAll(world, ids)
        const awake = ids.map((_, i) => i).filter((i) => !before[i].asleep && !after[i].asleep)
        const speeds = (of: typeof after) => awake.map((i) => Math.hypot(of[i].vx, of[i].vy))
        const sum = (of: typeof after) => speeds(of).reduce((all, speed) => all + speed, 0)
        const most = Math.max(...speeds(before))
        // What creeps at 3 px/s may stand in the next step.
        if (awake.length > 5 && most > 3 && most < 100 && sum(before) > 20)
          expect(sum(after) / sum(before), `pour ${seed}, frame ${k}`).toBeGreaterThan(0.1)
        before = after
      }
    }
  })

  it('and stays awake with sleep switched off', () => {
    const { world } = worldOf(tower(2), { sleep: false })
    run(world, 3)
    expect(world.resting).toBe(false)
  })
})

describe('a sleeping pile wakes', () => {
  it('what a chip is knocked into that merely lay beside it, before it is gone into', () => {
    let most = 0
    for (let gap = 0; gap < 24; gap += 2) {
      const chips = [0, 1].map((i) => ({ ...box, x: 300 + 60 * i, y: floor - 20 }))
      const { world, ids } = asleep(chips)
      const hammer = { ...box, x: 240 - gap, y: floor - 20 }
      ids.push(world.add({ ...hammer, vx: 1500 }))
      world.step(frame)
      most = Math.max(most, overlap(world, ids, [...chips, hammer]))
      if (gap < 12) expect(world.read(ids[1]).asleep).toBe(false)
    }
    expect(most).toBeLessThan(0.2)
  })

  it('those above, when their support is taken out, and they fall', () => {
    const { world, ids } = asleep(tower(4))
    world.remove(ids[0])
    expect(world.resting).toBe(false)
    for (const id of ids.slice(1)) expect(world.read(id).asleep).toBe(false)
    expect(settle(world)).toBeLessThan(360)
    ids.slice(1).forEach((id, i) => {
      expect(world.read(id).y).toBeCloseTo(floor - 40 * (i + 0.5), 1)
    })
  })

  it('those above, when their support is put elsewhere', () => {
    const { world, ids } = asleep(tower(3))
    world.place(ids[0], { x: 80, y: 100 })
    settle(world)
    expect(world.read(ids[1]).y).toBeCloseTo(floor - 20, 1)
    expect(world.read(ids[0]).y).toBeCloseTo(floor - 20, 1)
  })

  it('when a chip in it is taken hold of', () => {
    const { world, ids } = asleep(tower(3))
    const grab = world.grab(ids[0], 320, floor - 20)
    for (const id of ids) expect(world.read(id).asleep).toBe(false)
    grab.release()
    expect(settle(world)).toBeLessThan(360)
  })

  it('when the floor moves up or down, and stands on it again', () => {
    const { world, ids } = asleep(tower(3))
    for (const height of [240, 460]) {
      world.resize(stage.width, height)
      expect(world.resting).toBe(false)
      expect(settle(world, 600)).toBeLessThan(600)
      expect(world.read(ids[0]).y).toBeCloseTo(height - 20, 1)
    }
  })

  it('when the floor goes down by less than two pixels, and stands on it again', () => {
    for (const down of [0.2, 0.6, 1, 1.4, 1.9]) {
      const chips = [
        { width: 60, height: 30, radius: 15, x: 120, y: 325, angle: 0 },
        { width: 30, height: 30, radius: 15, x: 300, y: 325, angle: 0 },
        { width: 60, height: 30, radius: 0, x: 480, y: 325, angle: 0 },
        { width: 40, height: 30, radius: 6, x: 480, y: 295, angle: 0 },
      ]
      const { world, ids } = worldOf(chips)
      settle(world)
      world.resize(640, 340 + down)
      settle(world)
      const tops = readAll(world, ids).map(({ y }) => y - down)
      for (const [i, y] of tops.entries()) expect(y, `chip ${i}, ${down} px`).toBeCloseTo(chips[i].y, 1)
    }
  })

  it('when a wall comes in', () => {
    const { world, ids } = asleep([{ ...box, x: 600, y: floor - 20 }])
    world.resize(500, floor)
    expect(settle(world, 600)).toBeLessThan(600)
    expect(world.read(ids[0]).x).toBeLessThan(470.1)
  })

  it('not when the stage is told the size it has', () => {
    const { world } = asleep(tower(2))
    world.resize(stage.width, stage.height)
    expect(world.resting).toBe(true)
  })

  it('when a chip in it grows, and makes room', () => {
    const { world, ids } = asleep(tower(3))
    world.reshape(ids[0], { width: 60, height: 60, radius: 0 })
    expect(world.resting).toBe(false)
    expect(settle(world, 600)).toBeLessThan(600)
    expect(world.read(ids[0]).y).toBeCloseTo(floor - 30, 1)
    expect(world.read(ids[2]).y).toBeCloseTo(floor - 120, 1)
  })

  it('when gravity turns round', () => {
    const { world, ids } = asleep(tower(2))
    world.configure({ gravity: -500 })
    run(world, 0.5)
    expect(world.read(ids[1]).y).toBeLessThan(floor - 60 - 50)
  })

  it('when a chip lands on it', () => {
    const { world, ids } = asleep(tower(2))
    world.add({ ...box, x: 320, y: 60 })
    let woke = false
    for (let k = 0; k < 60; k++) {
      world.step(frame)
      woke ||= !world.read(ids[0]).asleep
    }
    expect(woke).toBe(true)
    expect(settle(world)).toBeLessThan(360)
  })

  it('when a chip is thrown at it', () => {
    const { world, ids } = asleep(tower(1))
    world.add({ ...pill, x: 100, y: floor - 15, vx: 1800 })
    run(world, 0.4)
    expect(world.read(ids[0]).x).toBeGreaterThan(330)
  })
})

describe('a pile at rest but awake', () => {
  it('follows the floor a few px down at once, even under a chip wider than the stage', () => {
    const below = [60, 320].map((x) => ({ ...box, x, y: floor - 20 }))
    const wide = { width: 700, height: 20, x: 320, y: -1000, angle: 0 }
    const { world, ids } = worldOf([...below, wide], { sleep: false })
    run(world, 0.5)
    world.resize(stage.width, stage.height + 4)
    run(world, 0.1)
    for (const id of ids.slice(0, 2)) expect(world.read(id).y).toBeCloseTo(floor + 4 - 20, 1)
  })
})

describe('a sleeping chip sleeps on', () => {
  it('beside a tower that is taken away', () => {
    const { world, ids } = asleep([...tower(2, 200), ...tower(2, 440)])
    world.remove(ids[0])
    for (let k = 0; k < 60; k++) {
      world.step(frame)
      expect(world.read(ids[2]).asleep).toBe(true)
      expect(world.read(ids[3]).asleep).toBe(true)
    }
  })

  it('and does not hop when gravity is turned down', () => {
    const { world, ids } = worldOf(tower(5), { gravity: 20_000 })
    settle(world)
    const before = readAll(world, ids)
    world.configure({ gravity: 100 })
    for (let k = 0; k < 60; k++) {
      world.step(frame)
      for (const [i, { y }] of readAll(world, ids).entries()) expect(before[i].y - y).toBeLessThan(1)
    }
  })

  it('beside one that comes to rest against it', () => {
    const { world, ids } = asleep([{ ...box, x: 320, y: floor - 20 }])
    world.add({ ...box, x: 380, y: floor - 20 })
    for (let k = 0; k < 120; k++) {
      world.step(frame)
      expect(world.read(ids[0]).asleep).toBe(true)
    }
    expect(world.resting).toBe(true)
  })

  it('and costs nothing while others fall', () => {
    const { world } = asleep(tower(5))
    world.add({ ...pill, x: 80, y: -4000 })
    run(world, 0.5)
    expect(world.stats.awake).toBe(1)
    expect(world.stats.rows).toBe(0)
  })
})

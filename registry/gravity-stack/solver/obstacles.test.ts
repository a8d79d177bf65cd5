import { describe, expect, it } from 'vitest'
import { chipDistance } from '../../../scenes/exact-distance'
import { pourChips } from '../../../scenes/piles'
import type { Chip } from '../../../scenes/scene'
import { seeded } from '../../../scenes/seeded'
import { finite, outside, overlap, readAll, run, settle, stage, worldOf } from '../testing/worlds'
import { createWorld, type World } from '../world'

type Placed = { width: number; height: number; radius?: number; x: number; y: number; angle?: number }

const shelf: Placed = { width: 260, height: 20, x: 320, y: 200 }
const pill = (x: number, y: number, more: Partial<Chip> = {}): Chip => ({
  width: 90,
  height: 34,
  radius: 17,
  x,
  y,
  angle: 0,
  ...more,
})

const obstacle = (world: World, body: Placed) => world.add({ ...body, density: Infinity })

/** px, the deepest that a chip reaches into an obstacle. */
function inObstacles(world: World, ids: number[], chips: Chip[], obstacles: Placed[]) {
  const gaps = ids.flatMap((id, i) =>
    obstacles.map((body) =>
      chipDistance(chips[i], world.read(id), { radius: 0, ...body }, { angle: 0, ...body }),
    ),
  )
  return Math.max(0, ...gaps.map((gap) => -gap))
}

describe('an obstacle', () => {
  const shapes: [string, Placed][] = [
    ['a box', shelf],
    ['a rounded box', { ...shelf, height: 60, radius: 16 }],
    ['a pill', { ...shelf, height: 40, radius: 20 }],
    ['a plank that is turned', { ...shelf, angle: 0.3 }],
    ['a plank on its end', { ...shelf, angle: Math.PI / 2 }],
    ['a disc', { width: 120, height: 120, radius: 60, x: 320, y: 220 }],
  ]
  for (const [name, body] of shapes)
    it(`that is ${name} carries a pour of 30 chips: none is deeper than 0.05 px in it, and all sleep`, () => {
      const chips = pourChips('mixed', 30, 7)
      const { world, ids } = worldOf(chips)
      obstacle(world, body)
      expect(settle(world, 600)).toBeLessThan(600)
      expect(inObstacles(world, ids, chips, [body])).toBeLessThan(0.05)
      expect(overlap(world, ids, chips)).toBeLessThan(0.05)
    })

  it('stays where it was put to the last bit, while chips lie on it', () => {
    const chips = pourChips('pills', 20, 2)
    const { world } = worldOf(chips)
    const id = obstacle(world, { ...shelf, angle: 0.2 })
    settle(world, 600)
    expect(world.read(id)).toMatchObject({ x: 320, y: 200, angle: 0.2, vx: 0, vy: 0, spin: 0 })
  })

  it('that takes the place of a chip which fell is not drawn as that chip', () => {
    const { world, ids } = worldOf([pill(320, 50)])
    run(world, 0.1)
    world.remove(ids[0])
    expect(obstacle(world, shelf)).toBe(ids[0])
    world.eachMoved((id) => expect.unreachable(`body ${id} is drawn`))
  })

  for (const axis of ['down', 'right'])
    it(`is passed by nothing that flies ${axis} at 3600 px/s, however thin it is`, () => {
      for (let angle = 0; angle < 3; angle += 0.25) {
        const down = axis === 'down'
        const thin = { width: down ? 200 : 4, height: down ? 4 : 200, x: 320, y: 170 }
        const { world, ids } = worldOf([
          pill(down ? 320 : 60, down ? -150 : 170, { angle, [down ? 'vy' : 'vx']: 3600 }),
        ])
        obstacle(world, thin)
        // Until it has come back from it.
        let side = Number.NEGATIVE_INFINITY
        for (let n = 0; n < 20; n++) {
          world.step(1 / 120)
          const at = world.read(ids[0])
          side = Math.max(side, down ? at.y - 170 : at.x - 320)
        }
        expect(side, `turned by ${angle}`).toBeLessThan(-15)
      }
    })

  it('that lies beside another one makes a floor without a seam: a box slides over it, a disc rolls over it', () => {
    const floors = [
      [{ width: 640, height: 20, x: 320, y: 300 }],
      [
        { width: 400, height: 20, x: 200, y: 300 },
        { width: 240, height: 20, x: 520, y: 300 },
      ],
    ]
    for (const chip of [
      { width: 60, height: 40, radius: 0, x: 120, y: 270, vx: 900, angle: 0 },
      { width: 40, height: 40, radius: 20, x: 120, y: 270, vx: 500, spin: 25, angle: 0 },
    ]) {
      const ends = floors.map((floor) => {
        const { world, ids } = worldOf([chip], { friction: 0.3 })
        for (const body of floor) obstacle(world, body)
        run(world, 0.9)
        return world.read(ids[0])
      })
      expect(ends[0].x).toBeGreaterThan(410)
      expect(ends[1].x).toBeCloseTo(ends[0].x, 0)
      expect(ends[1].y).toBeCloseTo(ends[0].y, 1)
    }
  })

  it('that is moved into a pile pushes it aside without throwing it, and the pile rests beside it', () => {
    const chips = pourChips('pills', 24, 4)
    const { world, ids } = worldOf(chips)
    const id = obstacle(world, { width: 120, height: 120, radius: 60, x: 320, y: -200 })
    settle(world)
    expect(world.resting).toBe(true)
    let fastest = 0
    for (let y = -200; y < 250; y += 5) {
      world.place(id, { y })
      world.step(1 / 60)
      for (const { vx, vy } of readAll(world, ids)) fastest = Math.max(fastest, Math.hypot(vx, vy))
    }
    expect(fastest).toBeLessThan(700)
    expect(settle(world, 600)).toBeLessThan(600)
    const at = { width: 120, height: 120, radius: 60, x: 320, y: 245 }
    expect(inObstacles(world, ids, chips, [at])).toBeLessThan(0.05)
    expect(outside(world, ids, chips)).toBeLessThan(0.05)
  })

  for (const [name, act] of [
    ['moves', (world: World, id: number) => world.place(id, { y: 260 })],
    ['turns', (world: World, id: number) => world.place(id, { angle: 0.8 })],
    ['grows', (world: World, id: number) => world.reshape(id, { width: 260, height: 40 })],
    ['shrinks', (world: World, id: number) => world.reshape(id, { width: 40, height: 20 })],
    ['goes', (world: World, id: number) => world.remove(id)],
  ] as const)
    it(`that ${name} wakes the chips that lie on it, and they come to rest again`, () => {
      const chips = [pill(280, 170), pill(370, 170), pill(320, 130)]
      const { world, ids } = worldOf(chips)
      const id = obstacle(world, shelf)
      settle(world)
      const before = readAll(world, ids)
      expect(before.every(({ asleep, y }) => asleep && y < 190)).toBe(true)
      act(world, id)
      expect(readAll(world, ids).some(({ asleep }) => !asleep)).toBe(true)
      expect(settle(world, 400)).toBeLessThan(400)
      for (const [i, { y }] of readAll(world, ids).entries())
        expect(Math.abs(y - before[i].y)).toBeGreaterThan(5)
      expect(overlap(world, ids, chips)).toBeLessThan(0.05)
    })

  it('that comes into a pile moves aside what is in it, and wakes no chip that is far away', () => {
    const chips = [pill(60, 322), pill(560, 322)]
    const { world, ids } = worldOf(chips)
    settle(world)
    const block = { width: 80, height: 80, x: 560, y: 300 }
    const id = obstacle(world, block)
    expect(readAll(world, ids).map(({ asleep }) => asleep)).toEqual([true, false])
    expect(settle(world, 600)).toBeLessThan(600)
    expect(inObstacles(world, ids, chips, [block])).toBeLessThan(0.05)
    // Nobody can take hold of it.
    world.grab(id, 560, 300).moveTo(100, 100, 1)
    run(world, 0.5)
    expect(world.read(id).x).toBe(560)
  })

  it('costs nothing at rest, and nothing is asked of it while what moves is far away', () => {
    const { world } = worldOf([pill(60, 322)])
    for (let n = 0; n < 20; n++) obstacle(world, { width: 20, height: 20, x: 200 + 20 * n, y: 100 })
    settle(world)
    world.step(1 / 60)
    expect(Object.values(world.stats).slice(0, 3)).toEqual([0, 0, 0])
  })
})

describe('gravity', () => {
  it('to the right lets the pile rest on the right wall, all of it inside', () => {
    const chips = pourChips('mixed', 24, 3)
    const { world, ids } = worldOf(chips)
    settle(world, 600)
    world.configure({ gravity: { x: 2600, y: 0 } })
    expect(world.resting).toBe(false)
    expect(settle(world, 900)).toBeLessThan(900)
    expect(overlap(world, ids, chips)).toBeLessThan(0.05)
    const xs = readAll(world, ids).map(({ x }) => x)
    expect(xs.reduce((a, b) => a + b) / xs.length).toBeGreaterThan(480)
  })

  it('upwards lets the pile rest under the ceiling, all of it inside', () => {
    const chips = pourChips('mixed', 24, 3)
    const { world, ids } = worldOf(chips, { ceiling: true })
    settle(world, 600)
    world.configure({ gravity: { x: 0, y: -2600 } })
    expect(settle(world, 900)).toBeLessThan(900)
    const all = readAll(world, ids)
    expect(overlap(world, ids, chips)).toBeLessThan(0.05)
    expect(Math.min(...all.map(({ y }) => y))).toBeGreaterThan(10)
    expect(all.reduce((sum, { y }) => sum + y, 0) / all.length).toBeLessThan(150)
  })

  it('that turns over and over leaves every chip within walls, floor and ceiling', () => {
    const chips = pourChips('mixed', 40, 5)
    const { world, ids } = worldOf(chips, { ceiling: true })
    settle(world, 600)
    const { random } = { random: seeded(3) }
    for (let n = 0; n < 60; n++) {
      world.configure({ gravity: { x: 8000 * random() - 4000, y: 8000 * random() - 4000 } })
      run(world, 0.25)
      expect(finite(world, ids)).toBe(true)
      for (const [i, { y }] of readAll(world, ids).entries())
        expect(y, `${n}`).toBeGreaterThan(Math.min(chips[i].width, chips[i].height) / 2 - 1)
      expect(outside(world, ids, chips)).toBeLessThan(1)
    }
    world.configure({ gravity: 2600 })
    expect(settle(world, 600)).toBeLessThan(600)
    expect(overlap(world, ids, chips)).toBeLessThan(0.05)
  })

  for (const gravity of [
    { x: 2600, y: 0 },
    { x: -2600, y: 300 },
    { x: 0, y: -2600 },
  ])
    it(`of ${gravity.x}, ${gravity.y} still has chips come in from above, past those that lie under the ceiling`, () => {
      const world = createWorld({ ...stage, gravity, ceiling: true })
      const chips: Chip[] = []
      const ids: number[] = []
      for (let n = 0; n < 24; n++) {
        const chip = pill(60 + ((n * 0.618) % 1) * 520, -60)
        chips.push(chip)
        ids.push(world.add(chip))
        run(world, 0.5)
      }
      expect(settle(world, 900)).toBeLessThan(900)
      for (const { y } of readAll(world, ids)) expect(y).toBeGreaterThan(16)
      expect(overlap(world, ids, chips)).toBeLessThan(0.05)
    })
})

describe('a ceiling', () => {
  it('lets in what comes from above, and nothing out', () => {
    const chips = [pill(320, -60)]
    const { world, ids } = worldOf(chips, { ceiling: true })
    settle(world)
    expect(world.read(ids[0]).y).toBeCloseTo(323, 0)
    world.place(ids[0], { vy: -3000 })
    let top = Infinity
    for (let n = 0; n < 60; n++) {
      world.step(1 / 120)
      top = Math.min(top, world.read(ids[0]).y)
    }
    expect(top).toBeGreaterThan(16)
    expect(top).toBeLessThan(30)
  })

  it('that closes while chips are above it lets those in', () => {
    const { world, ids } = worldOf([pill(320, 300)])
    settle(world)
    world.place(ids[0], { vy: -1800 })
    run(world, 0.4)
    expect(world.read(ids[0]).y).toBeLessThan(-30)
    world.configure({ ceiling: true })
    settle(world)
    expect(world.read(ids[0]).y).toBeCloseTo(323, 0)
  })
})

describe('a push', () => {
  it('sends a chip off as fast as the disc goes, and never faster than a toss', () => {
    for (const [seconds, speed] of [
      [0.2, 500],
      [0.001, 1800],
    ]) {
      const { world, ids } = worldOf([pill(320, 323)])
      settle(world)
      world.push(40, 200, 323, 100, 0, seconds)
      const { vx, vy } = world.read(ids[0])
      expect(Math.hypot(vx, vy)).toBeCloseTo(speed, 0)
      expect(vx).toBeGreaterThan(0.99 * speed)
    }
  })

  it('wakes nothing that it does not reach, and nothing that it moves away from', () => {
    const { world } = worldOf([pill(320, 323)])
    settle(world)
    world.push(40, 200, 200, 200, 0, 0.1)
    world.push(40, 250, 323, -100, 0, 0.1)
    expect(world.resting).toBe(true)
  })

  it('ten thousand times, wildly, loses no chip of a pile; it rests as soon as the pushes end', () => {
    const chips = pourChips('mixed', 24, 6)
    const { world, ids } = worldOf(chips, { ceiling: true })
    const random = seeded(11)
    obstacle(world, { width: 140, height: 24, radius: 12, x: 320, y: 180, angle: 0.4 })
    let at = [0, 0]
    for (let n = 0; n < 10_000; n++) {
      const to = [700 * random() - 30, 400 * random() - 30]
      world.push(60, at[0], at[1], to[0] - at[0], to[1] - at[1], 1 / 60)
      at = to
      if (n % 16 === 0) world.step(1 / 60)
    }
    expect(finite(world, ids)).toBe(true)
    expect(outside(world, ids, chips)).toBeLessThan(1)
    expect(settle(world, 600)).toBeLessThan(600)
    expect(overlap(world, ids, chips)).toBeLessThan(0.05)
  })
})

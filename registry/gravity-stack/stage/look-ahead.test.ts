import { describe, expect, it } from 'vitest'
import { type Kind, pourChips } from '../../../scenes/piles'
import { frame } from '../../../scenes/scene'
import { run, stage, worldOf } from '../testing/worlds'
import { createWorld } from '../world'
import { createLookAhead, uprightTurn } from './look-ahead'
import { addReleased, type Release, reach, releaseTime } from './release'

describe('a world that follows another', () => {
  for (const kind of ['pills', 'badges', 'mixed'] as Kind[])
    it(`takes the same steps as the other, bit for bit, wherever in the drop of ${kind} it starts`, () => {
      const { world } = worldOf(pourChips(kind, 40, 3))
      const other = createWorld({ width: 1, height: 1 })
      for (let part = 0; part < 12; part++) {
        other.follow(world)
        expect(other.hash()).toBe(world.hash())
        // Turn and turn about, so that each would see what the other left behind.
        for (let n = 0; n < 20; n++) {
          world.step(frame)
          other.step(frame)
        }
        expect(other.hash()).toBe(world.hash())
        // A step handed in by halves is not lost on the way.
        world.step(frame / 2)
      }
    })

  it('gives a new body the same id, that of a removed one', () => {
    const { world, ids } = worldOf(pourChips('pills', 12, 1))
    run(world, 1)
    world.remove(ids[4])
    const other = createWorld({ width: 1, height: 1 })
    other.follow(world)
    const late = { width: 60, height: 30, radius: 15, x: 300, y: -40 }
    expect(other.add(late)).toBe(world.add(late))
    run(world, 1)
    run(other, 1)
    expect(other.hash()).toBe(world.hash())
  })

  it('tells when the other world was changed by more than time', () => {
    const { world, ids } = worldOf(pourChips('pills', 6, 1))
    const other = createWorld({ width: 1, height: 1 })
    const follows = () => {
      const yes = other.follows(world)
      other.follow(world)
      return yes
    }
    follows()
    run(world, 0.5)
    world.add({ width: 60, height: 30, x: 300, y: -40 })
    expect(follows()).toBe(true)
    const grab = world.grab(ids[0], 100, 100)
    expect(follows()).toBe(false)
    grab.release()
    expect(follows()).toBe(false)
    world.place(ids[1], { vy: -300 })
    expect(follows()).toBe(false)
    world.reshape(ids[1], { width: 80, height: 30 })
    expect(follows()).toBe(false)
    world.resize(500, 300)
    expect(follows()).toBe(false)
    world.configure({ gravity: 500 })
    expect(follows()).toBe(false)
    world.remove(ids[1])
    expect(follows()).toBe(false)
  })

  it('comes to rest though a pointer holds a chip of the other world', () => {
    const { world, ids } = worldOf(pourChips('pills', 1, 1))
    world.grab(ids[0], 320, 100)
    run(world, 1)
    const other = createWorld({ width: 1, height: 1 })
    other.follow(world)
    run(other, 6)
    expect(other.resting).toBe(true)
  })
})

describe('how a body is turned', () => {
  const over = Math.PI - 0.1
  it('a pill and a box by half turns, a square by quarters, a disc as far as it needs', () => {
    const drawn = (width: number, height: number, radius: number, angle: number) =>
      angle + uprightTurn({ width, height, radius }, angle)
    expect(drawn(90, 30, 15, over)).toBeCloseTo(-0.1)
    expect(drawn(90, 30, 0, 5 * Math.PI + 0.2)).toBeCloseTo(0.2)
    expect(drawn(90, 30, 0, 0.3)).toBe(0.3)
    expect(drawn(30, 90, 8, -Math.PI)).toBeCloseTo(0)
    expect(drawn(40, 40, 8, 2)).toBeCloseTo(2 - Math.PI / 2)
    expect(drawn(40, 40, 20, 2.345)).toBe(0)
  })
})

/** What is released, and the clock that says when. */
function releases(kind: Kind, count: number, stagger: number) {
  const chips = pourChips(kind, count, 1).map(({ width, height, radius }, order): Release => {
    const due = releaseTime(order, (order * stagger) / 1000)
    return { width, height, radius: radius ?? 0, reach: reach(width, height), order, due, id: -1 }
  })
  return { chips, clock: 0, revision: 0 }
}

it('a look-ahead, in any number of slices, tells the angle at which each chip will lie', () => {
  const coming = releases('mixed', 30, 60)
  const shown = { world: createWorld(stage), chips: [] as Release[] }
  let told = 0
  const lookAhead = createLookAhead<Release>(() => told++)
  const expected = new Map<Release, number>()
  const all = [...coming.chips]
  while (coming.chips.length > 0 || !shown.world.resting) {
    while (!lookAhead.advance(shown, coming)) {
      // Another slice.
    }
    coming.clock += frame
    while (coming.chips[0] && coming.chips[0].due < coming.clock) {
      const chip = coming.chips.shift()!
      chip.id = addReleased(shown, chip)
      expected.set(chip, lookAhead.expectedAngle(chip)!)
    }
    shown.world.step(frame)
  }
  expect(told).toBe(30)
  const right = all.filter((chip) => Math.abs(shown.world.read(chip.id).angle - expected.get(chip)!) < 0.01)
  // What lies for three seconds may still be knocked over by what comes then.
  expect(right.length).toBeGreaterThan(20)
  for (const chip of all) {
    const { angle } = shown.world.read(chip.id)
    const drawn = angle + uprightTurn(chip, expected.get(chip)!)
    if (chip.width !== chip.height) expect(Math.cos(drawn)).toBeGreaterThan(-0.02)
  }
})

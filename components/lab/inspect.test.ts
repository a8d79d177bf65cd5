import { describe, expect, it } from 'vitest'
import { settle, stage, worldOf } from '@/registry/gravity-stack/testing/worlds'
import { inspect, meanMass } from './inspect'

const gravity = 2600
const box = { width: 60, height: 40, angle: 0 }
const floor = stage.height

describe('what the overlay shows', () => {
  it('of a box on the floor: its two lower corners, which carry its weight', () => {
    const { world, ids } = worldOf([{ ...box, x: 200, y: floor - 20.5 }])
    settle(world)
    const { touches, contacts } = inspect(world)
    expect(contacts).toBe(1)
    expect(touches.map(({ x }) => x).toSorted((a, b) => a - b)).toEqual([
      expect.closeTo(170, 0),
      expect.closeTo(230, 0),
    ])
    for (const { y } of touches) expect(y).toBeCloseTo(floor, 0)
    const weight = world.mass(ids[0]).mass * gravity
    const up = touches.reduce((sum, { forceY }) => sum - forceY, 0)
    expect(up / weight).toBeCloseTo(1, 2)
    expect(meanMass(world)).toBeCloseTo(world.mass(ids[0]).mass, 6)
  })

  it('of a tower: each floor of it carries what is above', () => {
    const { world, ids } = worldOf([0, 1, 2].map((i) => ({ ...box, x: 200, y: floor - 20 - 40 * i })))
    settle(world)
    const weight = world.mass(ids[0]).mass * gravity
    const loads = [0, 1, 2].map((i) =>
      inspect(world)
        .touches.filter(({ y }) => Math.abs(y - (floor - 40 * i)) < 1)
        .reduce((sum, { forceY }) => sum + Math.abs(forceY), 0),
    )
    loads.forEach((load, i) => {
      expect(load / weight).toBeCloseTo(3 - i, 1)
    })
  })

  it('of a box half over another: the two ends of where they meet', () => {
    const { world } = worldOf([
      { ...box, x: 200, y: floor - 20 },
      { ...box, x: 225, y: floor - 60 },
    ])
    settle(world)
    const upper = inspect(world).touches.filter(({ y }) => Math.abs(y - (floor - 40)) < 1)
    expect(upper.map(({ x }) => x).toSorted((a, b) => a - b)).toEqual([
      expect.closeTo(195, 0),
      expect.closeTo(230, 0),
    ])
  })

  it('chips that touch as one island, those apart as two', () => {
    const { world, ids } = worldOf([
      { ...box, x: 100, y: floor - 20 },
      { ...box, x: 400, y: floor - 20 },
      { ...box, x: 400, y: floor - 60 },
    ])
    settle(world)
    const { islands } = inspect(world)
    expect(ids.map((id) => islands.get(id))).toEqual([ids[0], ids[1], ids[1]])
  })

  it('nothing of chips in the air', () => {
    const { world } = worldOf([
      { ...box, x: 100, y: 50 },
      { ...box, x: 400, y: 50 },
    ])
    world.step(1 / 60)
    expect(inspect(world)).toMatchObject({ touches: [], contacts: 0 })
  })
})

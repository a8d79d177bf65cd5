import { describe, expect, it } from 'vitest'
import { sceneNamed, scenes } from '.'
import { worstOverlap } from './exact-distance'
import { hardScenes } from './hard'
import { pourChips, pourStage } from './piles'
import { contactResidual } from './residual'
import { Trajectory } from './scene'

describe('the scenes', () => {
  it('have names of their own, and one measure at least', () => {
    expect(new Set(scenes.map((scene) => scene.name)).size).toBe(scenes.length)
    for (const scene of scenes) expect(scene.measures.length).toBeGreaterThan(0)
  })

  it('start without any chip in another, in the floor or in a wall', () => {
    for (const scene of scenes) {
      const chips = scene.build(1)
      expect(worstOverlap(chips, chips, scene), scene.name).toBeLessThan(1e-9)
    }
  })

  it('start hard only where hard means chips in one another', () => {
    const overlapping = ['crammed', 'same-place', 'random-poses']
    for (const scene of hardScenes) {
      const chips = scene.build(1)
      const deep = worstOverlap(chips, chips, scene)
      if (overlapping.includes(scene.name)) expect(deep, scene.name).toBeGreaterThan(10)
      else expect(deep, scene.name).toBeLessThan(1e-6)
    }
  })

  it('pour the same chips from the same seed, and others from another', () => {
    expect(pourChips('mixed', 60, 4)).toEqual(pourChips('mixed', 60, 4))
    expect(pourChips('mixed', 60, 4)).not.toEqual(pourChips('mixed', 60, 5))
  })

  it('fill larger stages as full', () => {
    for (const count of [12, 250, 1000]) {
      const { width, height } = pourStage(count)
      expect((width * height) / count).toBeCloseTo((640 * 340) / 60, -2)
    }
  })

  it('read bounce heights off the frames, whatever their phase', () => {
    const scene = sceneNamed('bounce-0.5')
    const trajectory = new Trajectory(scene, scene.build(1), 30)
    for (let k = 0; k <= 30; k++) trajectory.at(k)[1] = 100 + 1300 * ((k - 14.37) / 60) ** 2
    expect(trajectory.apexes()).toHaveLength(1)
    expect(trajectory.apexes()[0]).toBeCloseTo(100, 10)
  })

  it('see when the last chip calms down', () => {
    const scene = sceneNamed('stack-10')
    const trajectory = new Trajectory(scene, scene.build(1), 60)
    for (let k = 0; k <= 60; k++) trajectory.at(k)[6 * 9 + 3] = k <= 33 ? 8 : 6
    expect(trajectory.timeToRest()).toBeCloseTo(33 / 60, 12)
  })

  it('measure drift at the corner that moved furthest', () => {
    const scene = sceneNamed('stack-10')
    const trajectory = new Trajectory(scene, scene.build(1), 1)
    trajectory.at(1).set(trajectory.at(0))
    expect(trajectory.drift()).toBe(0)
    trajectory.at(1)[0] += 3
    trajectory.at(1)[1] += 4
    expect(trajectory.drift()).toBeCloseTo(5, 12)
    trajectory.at(1).set(trajectory.at(0))
    // A box of 80 by 40 px that has only turned.
    trajectory.at(1)[2] = 0.2
    expect(trajectory.drift()).toBeCloseTo(2 * Math.hypot(40, 20) * Math.sin(0.1), 12)
  })

  it('find a stack at rest in balance, one in the air a weight short, and one that sinks at fault', () => {
    const scene = sceneNamed('stack-10')
    const trajectory = new Trajectory(scene, scene.build(1), 1)
    trajectory.at(1).set(trajectory.at(0))
    expect(contactResidual(trajectory, 1, 40_000)).toBeLessThan(1e-3)
    // Pressed into one another by a hundredth of a pixel the sharp corners are inside.
    const pressed = new Trajectory(scene, scene.build(1), 1)
    for (const k of [0, 1]) for (let i = 0; i < 10; i++) pressed.at(k)[6 * i + 1] += 0.01 * (i + 1)
    pressed.at(1).set(pressed.at(0))
    expect(contactResidual(pressed, 1, 40_000)).toBeLessThan(1e-3)
    const sinking = new Trajectory(scene, scene.build(1), 1)
    sinking.at(1).set(sinking.at(0))
    for (const k of [0, 1]) for (let i = 0; i < 10; i++) sinking.at(k)[6 * i + 4] = 20
    expect(contactResidual(sinking, 1, 40_000)).toBeGreaterThan(0.1)
    const flying = new Trajectory(scene, scene.build(1), 1)
    flying.at(1).set(flying.at(0))
    for (let i = 0; i < 10; i++) flying.at(1)[6 * i + 1] -= 100 * (i + 1)
    expect(contactResidual(flying, 1)).toBeCloseTo(1, 6)
  })
})

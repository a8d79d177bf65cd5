import { readFileSync } from 'node:fs'
import { describe, expect, it } from 'vitest'
import { chipDistance, type Pose } from '../../../scenes/exact-distance'
import { STEP } from '../solver/constants'
import type { Box } from '../solver/input'
import { reach, releasePose, releaseTime, scatter } from './release'

const pose = (index: number, width = 80, height = 36, stage = 640, gravity = 2600) =>
  releasePose(index, width, height, stage, gravity, [])
const all = Array.from({ length: 400 }, (_, i) => i)

describe('the drop', () => {
  it('is the same at every visit and in every browser: pinned to the last bit', () => {
    expect([scatter(0, 0), scatter(41, 5)]).toEqual([0.6180339887498949, 0.39964898327889387])
    expect(pose(7)).toEqual({
      x: 370.63069082996134,
      y: -97.15778060609591,
      angle: 0.2111797498107535,
      vx: 16.357771068724105,
      vy: 0,
      spin: 0.5343666110300546,
    })
    const source = readFileSync(new URL('./release.ts', import.meta.url), 'utf8')
    expect(source).not.toMatch(/Math\.(random|sin|cos|tan|exp|log|pow|hypot|atan2?)|Date| \*\* /)
  })

  it('scatters evenly and without a pattern between neighbours', () => {
    for (let channel = 0; channel < 6; channel++) {
      const values = all.map((i) => scatter(i, channel))
      const mean = values.reduce((sum, value) => sum + value, 0) / values.length
      expect(Math.abs(mean - 0.5)).toBeLessThan(0.05)
      const alike = values.slice(1).reduce((sum, value, i) => sum + (value - 0.5) * (values[i] - 0.5), 0)
      expect(Math.abs(alike / values.length)).toBeLessThan(0.02)
    }
  })

  it('starts each chip upright or nearly so, just above the stage, between its walls', () => {
    for (const i of all) {
      const { x, y, angle, vx, vy, spin } = pose(i)
      const sin = Math.abs(Math.sin(angle))
      const cos = Math.cos(angle)
      expect(Math.abs(angle)).toBeLessThanOrEqual(0.25)
      expect(x - (40 * cos + 18 * sin)).toBeGreaterThanOrEqual(0)
      expect(x + (40 * cos + 18 * sin)).toBeLessThanOrEqual(640)
      const clearance = -(y + 18 * cos + 40 * sin)
      expect(clearance).toBeGreaterThanOrEqual(24)
      expect(clearance).toBeLessThanOrEqual(144 + 11)
      expect(Math.abs(vx)).toBeLessThanOrEqual(40)
      expect(vy).toBe(0)
      expect(Math.abs(spin)).toBeLessThanOrEqual(1.2)
    }
  })

  it('covers the width evenly with any number of chips', () => {
    for (const count of [8, 20, 60]) {
      const quarters = [0, 0, 0, 0]
      for (const i of all.slice(0, count)) quarters[Math.min(3, Math.floor(pose(i, 20, 20).x / 160))]++
      for (const chips of quarters) expect(Math.abs(chips - count / 4)).toBeLessThanOrEqual(1 + count / 20)
    }
  })

  it('puts a chip wider than the stage in its middle', () => {
    for (const i of all.slice(0, 20)) expect(pose(i, 900).x).toBe(320)
  })

  it('lets a chip that can’t turn between the walls fall level, so that it does not jam above the stage', () => {
    for (const i of all.slice(0, 20))
      expect(pose(i, 640)).toMatchObject({ x: 320, angle: 0, vx: 0, vy: 0, spin: 0 })
  })

  it('keeps clear of what is still above the stage, even when all fall at once', () => {
    const chip = { width: 80, height: 36 }
    const far = reach(80, 36)
    const there: Pose[] = []
    for (const i of all.slice(0, 60)) {
      const taken = there.map(({ x, y }): Box => [x - far, y - far, x + far, y + far])
      const pose = releasePose(i, 80, 36, 320, 2600, taken)
      for (const other of there) expect(chipDistance(chip, pose, chip, other)).toBeGreaterThan(0)
      there.push(pose)
    }
  })

  it('sends chips down when gravity alone would not', () => {
    expect(pose(3, 80, 36, 640, 0).vy).toBeGreaterThan(100)
    expect(pose(3, 80, 36, 640, 90).vy).toBeGreaterThan(100)
  })

  it('releases some chips at once and others a tenth of a second late', () => {
    const late = all.map((i) => releaseTime(i, i * 0.15) - i * 0.15)
    expect(Math.max(...late) - Math.min(...late)).toBeGreaterThan(0.1)
  })

  it('releases at most 0.12 s late, in the middle of a step, where no rounding of frame times reaches', () => {
    for (const i of all) {
      const slot = i * 0.15
      const time = releaseTime(i, slot)
      expect(time).toBeGreaterThan(slot - STEP)
      expect(time).toBeLessThan(slot + 0.12 + STEP)
      const phase = (time / STEP) % 1
      expect(Math.abs(phase - 0.5)).toBeLessThan(1e-6)
    }
  })
})

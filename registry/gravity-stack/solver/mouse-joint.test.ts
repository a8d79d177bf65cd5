import { describe, expect, it } from 'vitest'
import { chipDistance } from '../../../scenes/exact-distance'
import { pourChips } from '../../../scenes/piles'
import { type Chip, frame } from '../../../scenes/scene'
import { finite, outside, overlap, readAll, run, settle, stage, worldOf } from '../testing/worlds'
import { createJoint } from './mouse-joint'

const pill = { width: 80, height: 30, radius: 15, angle: 0 }
const floor = stage.height

/** A pile that rests. */
function pile(chips: Chip[]) {
  const made = worldOf(chips)
  settle(made.world)
  return made
}

describe('a held chip', () => {
  it('hangs still with its centre below the pointer, and less than 4 px from it', () => {
    const { world, ids } = worldOf([{ ...pill, x: 320, y: 100 }])
    const grab = world.grab(ids[0], 350, 100)
    for (let k = 1; k <= 1200; k++) {
      grab.moveTo(350, 100, k * frame)
      world.step(frame)
    }
    const { x, y, angle, vx, vy, spin } = world.read(ids[0])
    expect(Math.hypot(vx, vy)).toBeLessThan(1)
    expect(Math.abs(spin)).toBeLessThan(0.05)
    expect(x).toBeCloseTo(350, 0)
    expect(y).toBeGreaterThan(125)
    // The point held was 30 px right of the centre.
    const held = { x: x + 30 * Math.cos(angle), y: y + 30 * Math.sin(angle) }
    expect(Math.hypot(held.x - 350, held.y - 100)).toBeLessThan(4)
  })

  it('goes into nothing when it is pulled away at once, however near the next one stands', () => {
    for (let gap = 0.5; gap < 8; gap++) {
      const chips = [0, 1].map((i) => ({ ...pill, radius: 0, x: 200 + (80 + gap) * i, y: floor - 15 }))
      const { world, ids } = pile(chips)
      const grab = world.grab(ids[0], 200, floor - 15)
      for (let k = 1; k <= 6; k++) {
        grab.moveTo(600, floor - 15, k * frame)
        world.step(frame)
        expect(overlap(world, ids, chips)).toBeLessThan(0.5)
      }
    }
  })

  it('swings at first, round the pointer', () => {
    const { world, ids } = worldOf([{ ...pill, x: 320, y: 100 }])
    world.grab(ids[0], 350, 100)
    let most = 0
    for (let k = 0; k < 60; k++) {
      world.step(frame)
      most = Math.max(most, world.read(ids[0]).x)
    }
    expect(most).toBeGreaterThan(354)
  })

  it('swings less and less: nothing feeds it', () => {
    for (const drag of [undefined, 0]) {
      const { world, ids } = worldOf([{ ...pill, x: 320, y: 100 }], {
        linearDamping: drag,
        angularDamping: drag,
      })
      world.grab(ids[0], 350, 100)
      const widest = Array.from({ length: 8 }, () => {
        let most = 0
        for (let k = 0; k < 60; k++) {
          world.step(frame)
          most = Math.max(most, Math.abs(world.read(ids[0]).x - 350))
        }
        return most
      })
      for (let second = 1; second < 8; second++) expect(widest[second]).toBeLessThan(widest[second - 1])
      if (drag === undefined) expect(widest[7]).toBeLessThan(8)
    }
  })

  it('hangs still against wall or floor when a hand far beyond them pulls and stands still', () => {
    const disc = { width: 36, height: 36, radius: 18, angle: 0 }
    for (const shape of [disc, pill])
      for (const [toX, toY] of [
        [800, 200],
        [-150, 100],
        [320, 500],
      ]) {
        const chip = { ...shape, x: 400, y: floor - shape.height / 2 }
        const { world, ids } = pile([chip])
        const grab = world.grab(ids[0], 412, chip.y - 10)
        for (let k = 1; k <= 30; k++) {
          grab.moveTo(412 + ((toX - 412) * k) / 30, chip.y - 10 + ((toY - chip.y + 10) * k) / 30, k * frame)
          world.step(frame)
        }
        run(world, 5)
        const { vx, vy, spin } = world.read(ids[0])
        expect(Math.hypot(vx, vy) + (shape.width / 2) * Math.abs(spin), `to ${toX}, ${toY}`).toBeLessThan(1)
      }
  })

  it.each([
    ['right', 150],
    ['right', 300],
    ['left', 150],
    ['left', 300],
    ['floor', 150],
    ['floor', 300],
  ])('slides along the edge, level with a hand that moves along it outside: %s, %i px off', (edge, off) => {
    const chip = { width: 120, height: 36, radius: 18, angle: 0, x: 320, y: floor - 18 }
    for (const grabbed of [-50, 0, 50]) {
      const { world, ids } = pile([chip])
      const grab = world.grab(ids[0], 320 + grabbed, chip.y)
      const along = (k: number) => Math.min(100, (100 * k) / 30)
      const point = (k: number) => {
        if (edge === 'floor') return [250 + along(k), floor + off] as const
        return [edge === 'left' ? -off : stage.width + off, 280 - along(k)] as const
      }
      for (let k = 1; k <= 60; k++) {
        grab.moveTo(...point(0), k * frame)
        world.step(frame)
      }
      for (let k = 1; k <= 120; k++) {
        grab.moveTo(...point(k), 1 + k * frame)
        world.step(frame)
        expect(outside(world, ids, [chip])).toBeLessThan(1)
      }
      const { x, y, angle } = world.read(ids[0])
      const level = edge === 'floor' ? x + grabbed * Math.cos(angle) : y + grabbed * Math.sin(angle)
      expect(Math.abs(level - (edge === 'floor' ? 350 : 180)), `grabbed at ${grabbed}`).toBeLessThan(4)
    }
  })

  it('lies in the corner that a hand outside is nearest to, and hangs from one above the open top', () => {
    const chip = { width: 60, height: 40, radius: 8, angle: 0, x: 320, y: floor - 20 }
    const { world, ids } = pile([chip])
    const grab = world.grab(ids[0], 320, chip.y)
    const hold = (x: number, y: number, from: number) => {
      for (let k = 1; k <= 120; k++) {
        grab.moveTo(x, y, from + k * frame)
        world.step(frame)
      }
      return world.read(ids[0])
    }
    const corner = hold(stage.width + 400, floor + 400, 0)
    expect(corner.x).toBeGreaterThan(stage.width - 31)
    expect(corner.y).toBeGreaterThan(floor - 21)
    expect(Math.abs(hold(320, -300, 2).y + 300)).toBeLessThan(4)
  })

  it('stays level with a hand outside when the wall comes nearer', () => {
    const { world, ids } = worldOf([{ ...pill, x: 320, y: 100 }])
    const grab = world.grab(ids[0], 320, 100)
    for (let k = 1; k <= 240; k++) {
      if (k === 120) world.resize(400, 340)
      grab.moveTo(900, Math.max(100, 250 - 2 * k), k * frame)
      world.step(frame)
    }
    expect(Math.abs(world.read(ids[0]).y - 100)).toBeLessThan(4)
    expect(outside(world, ids, [pill], { width: 400, height: 340 })).toBeLessThan(0.1)
  })

  it('follows the pointer across the stage and comes to rest where it stops', () => {
    const { world, ids } = worldOf([{ ...pill, x: 100, y: 100 }])
    const grab = world.grab(ids[0], 100, 100)
    for (let k = 1; k <= 180; k++) {
      const x = Math.min(500, 100 + 10 * k)
      grab.moveTo(x, 100, k * frame)
      world.step(frame)
    }
    const { x, y } = world.read(ids[0])
    expect(Math.hypot(x - 500, y - 100)).toBeLessThan(4)
  })

  it.each([
    ['floor', 320, 5000],
    ['left wall', -5000, 200],
    ['right wall', 6000, 200],
    ['corner', 6000, 5000],
  ])('can not be dragged through the %s', (_, x, y) => {
    const { world, ids } = worldOf([{ ...pill, x: 320, y: 200 }])
    const grab = world.grab(ids[0], 320, 200)
    for (let k = 1; k <= 120; k++) {
      grab.moveTo(x, y, k * frame)
      world.step(frame)
      expect(outside(world, ids, [pill])).toBeLessThan(3)
      expect(finite(world, ids)).toBe(true)
    }
    grab.release()
    settle(world)
    expect(world.resting).toBe(true)
    expect(outside(world, ids, [pill])).toBeLessThan(0.05)
  })

  it('can not be dragged through the pile, and the pile heals when it is let go', () => {
    for (let seed = 1; seed <= 3; seed++) {
      const chips = pourChips('pills', 40, seed)
      const { world, ids } = pile(chips)
      const top = ids.reduce((a, b) => (world.read(a).y < world.read(b).y ? a : b))
      const { x, y } = world.read(top)
      const grab = world.grab(top, x, y)
      let worst = 0
      for (let k = 1; k <= 120; k++) {
        const at = 320 + 280 * Math.sin(k / 12)
        grab.moveTo(at, floor + 200, k * frame)
        world.step(frame)
        worst = Math.max(worst, overlap(world, ids, chips))
        expect(finite(world, ids)).toBe(true)
      }
      expect(worst).toBeLessThan(10)
      grab.release()
      settle(world, 600)
      expect(world.resting).toBe(true)
      expect(overlap(world, ids, chips)).toBeLessThan(0.05)
    }
  })

  it('can not be pulled through a row of standing chips', () => {
    const wall = Array.from({ length: 8 }, (_, i) => ({
      width: 40,
      height: 40,
      angle: 0,
      x: 320,
      y: floor - 40 * (i + 0.5),
      density: 200,
    }))
    const chips = [{ ...pill, x: 100, y: 300 }, ...wall]
    const { world, ids } = worldOf(chips)
    const grab = world.grab(ids[0], 100, 300)
    for (let k = 1; k <= 120; k++) {
      grab.moveTo(600, 300, k * frame)
      world.step(frame)
      const [held, ...stones] = readAll(world, ids)
      stones.forEach((stone, i) => {
        expect(chipDistance(pill, held, wall[i], stone)).toBeGreaterThan(-3)
      })
    }
    expect(world.read(ids[0]).x).toBeLessThan(320)
  })

  it('lifts a chip out from under others without a jolt', () => {
    const chips = pourChips('badges', 30, 2)
    const { world, ids } = pile(chips)
    const low = ids.reduce((a, b) => (world.read(a).y > world.read(b).y ? a : b))
    const from = world.read(low)
    const grab = world.grab(low, from.x, from.y)
    for (let k = 1; k <= 120; k++) {
      grab.moveTo(from.x, Math.max(40, from.y - 4 * k), k * frame)
      world.step(frame)
    }
    expect(world.read(low).y).toBeLessThan(from.y - 60)
    for (const { vx, vy } of readAll(world, ids)) expect(Math.hypot(vx, vy)).toBeLessThan(1800)
  })
})

describe('a chip let go', () => {
  /** Moves the pointer to the right at `speed` with `rate` events a second and lets go. */
  function throwAt(speed: number, rate: number, frames = 30) {
    const { world, ids } = worldOf([{ ...pill, x: 200, y: 100 }], { width: 4000, height: 2000, gravity: 0 })
    const grab = world.grab(ids[0], 200, 100)
    let event = 0
    for (let k = 1; k <= frames; k++) {
      while (event < k * frame * rate) {
        grab.moveTo(200 + (speed * event) / rate, 100, event / rate)
        event++
      }
      world.step(frame)
    }
    grab.release()
    return world.read(ids[0])
  }

  it('leaves with the speed of the pointer, the same at 30, 60, 120 and 240 events a second', () => {
    for (const speed of [200, 600, 1200]) {
      for (const rate of [30, 60, 120, 240]) {
        expect(throwAt(speed, rate).vx / speed).toBeCloseTo(1, 1)
        expect(Math.abs(throwAt(speed, rate).vx / throwAt(speed, 240).vx - 1)).toBeLessThan(0.03)
      }
    }
  })

  it('leaves with the speed of the pointer, though the button comes up a little after the last move', () => {
    for (const rate of [60, 120])
      for (const late of [0.004, 0.008, 0.016, 0.02]) {
        const { world, ids } = worldOf([{ ...pill, x: 200, y: 100 }], { width: 4000 })
        const grab = world.grab(ids[0], 200, 100)
        for (let k = 0; k <= rate / 3; k++) {
          grab.moveTo(200 + (1000 * k) / rate, 100, k / rate)
          world.step(1 / rate)
        }
        grab.moveTo(200 + 1000 / 3, 100, 1 / 3 + late)
        grab.release()
        expect(world.read(ids[0]).vx, `${1000 * late} ms at ${rate} Hz`).toBeCloseTo(1000, 3)
      }
  })

  it('leaves with the speed of a pointer that flies along a wall far outside', () => {
    for (const off of [150, 300]) {
      const { world, ids } = worldOf([{ ...pill, x: 100, y: 1500 }], { width: 640, height: 2000 })
      const grab = world.grab(ids[0], 100, 1500)
      for (let k = 0; k <= 90; k++) {
        // It flies off within a tenth of a second.
        grab.moveTo(-off, 1500 - (1200 * Math.max(0, k - 84)) / 60, k * frame)
        world.step(frame)
      }
      grab.release()
      const { vx, vy } = world.read(ids[0])
      expect(vy, `${off} px off`).toBeCloseTo(-1200, 3)
      expect(Math.abs(vx)).toBeLessThan(50)
    }
  })

  it('leaves with the speed of a pointer that has just left the stage', () => {
    const { world, ids } = worldOf([{ ...pill, x: 200, y: 100 }])
    const grab = world.grab(ids[0], 200, 100)
    for (let k = 0; 200 + 20 * k < stage.width + 20; k++) {
      grab.moveTo(200 + 20 * k, 100, k * frame)
      world.step(frame)
    }
    grab.release()
    expect(world.read(ids[0]).vx).toBeCloseTo(1200, 3)
  })

  it('leaves with the speed of the pointer when it is flicked by its end between two frames', () => {
    const { world, ids } = worldOf([{ ...pill, width: 240, x: 320, y: 100 }])
    const grab = world.grab(ids[0], 430, 100)
    for (let k = 0; k < 4; k++) grab.moveTo(430 + 2 * k, 100, k * 0.004)
    grab.release()
    expect(world.read(ids[0]).vx).toBeCloseTo(500, 6)
  })

  it('keeps its own speed when the pointer has told of two places only, in the same tenth of a millisecond', () => {
    const { world, ids } = worldOf([{ ...pill, x: 320, y: 100 }])
    const grab = world.grab(ids[0], 320, 100)
    run(world, 1)
    const { vx } = world.read(ids[0])
    grab.moveTo(321, 100, 1)
    grab.moveTo(321.5, 100, 1.0001)
    grab.release()
    expect(world.read(ids[0]).vx).toBe(vx)
  })

  it('never leaves faster than 1800 px/s', () => {
    for (const speed of [2000, 2500]) {
      const { vx, vy } = throwAt(speed, 60, 40)
      expect(Math.hypot(vx, vy)).toBeLessThanOrEqual(1800 + 1e-9)
      expect(vx).toBeGreaterThan(1700)
    }
  })

  it('keeps its own speed when the pointer has stood still, or its clock has gone back', () => {
    for (const back of [false, true]) {
      const { world, ids } = worldOf([{ ...pill, x: 320, y: 100 }])
      const grab = world.grab(ids[0], 320, 100)
      for (let k = 0; k < 10; k++) {
        grab.moveTo(320 + 16 * k, 100, k * frame)
        world.step(frame)
      }
      if (back) grab.moveTo(464, 100, 0)
      else run(world, 0.5)
      const { vx } = world.read(ids[0])
      grab.release()
      expect(world.read(ids[0]).vx).toBe(vx)
    }
  })

  it('leaves with the speed of the pointer though its clock is too coarse to tell its moves apart, and keeps no more samples than it tells', () => {
    const { world, ids } = worldOf([{ ...pill, x: 120, y: 100 }])
    const grab = world.grab(ids[0], 120, 100)
    for (let k = 0; k < 24; k++) {
      for (let n = 1; n <= 20; n++) grab.moveTo(120 + 8 * (k + n / 20), 100, k * frame)
      world.step(frame)
    }
    expect(world.scene.joints[0].samples.length).toBeLessThan(8)
    grab.release()
    expect(world.read(ids[0]).vx).toBeCloseTo(480, 6)
  })

  it('swings on as it did when a hand that stands still lets go of it', () => {
    for (const seconds of [0.2, 0.4, 1, 2]) {
      const { world, ids } = worldOf([{ ...pill, width: 200, height: 24, radius: 12, x: 320, y: 100 }])
      const grab = world.grab(ids[0], 410, 100)
      grab.moveTo(410, 100, 0)
      run(world, seconds)
      const before = world.read(ids[0])
      // As a page tells of it: where the pointer is when the button goes up is where it was.
      grab.moveTo(410, 100, seconds)
      grab.release()
      const after = world.read(ids[0])
      expect(Math.hypot(before.vx, before.vy)).toBeGreaterThan(100)
      expect([after.vx, after.vy]).toEqual([before.vx, before.vy])
      expect(after.spin).toBe(before.spin)
    }
  })

  it('leaves with the speed of the pointer however it swings below a hand that tosses it', () => {
    for (const frames of [6, 12, 18, 24]) {
      const { world, ids } = worldOf([{ ...pill, x: 320, y: 100 }])
      const grab = world.grab(ids[0], 350, 100)
      grab.moveTo(350, 100, 0)
      run(world, 1)
      for (let k = 1; k <= frames; k++) {
        grab.moveTo(350 + 500 * k * frame, 100, 1 + k * frame)
        world.step(frame)
      }
      grab.release()
      expect(world.read(ids[0]).vx).toBeCloseTo(500, 0)
    }
  })

  it('bounces off the floor that it lay on when it is flicked at it', () => {
    const { world, ids } = worldOf([{ ...pill, x: 320, y: floor - 15 }], { bounce: 0.8 })
    settle(world)
    const grab = world.grab(ids[0], 320, floor - 15)
    for (let k = 0; k < 5; k++) {
      grab.moveTo(320, floor - 15 + 800 * k * frame, k * frame)
      world.step(frame)
    }
    grab.release()
    expect(world.read(ids[0]).vy).toBeGreaterThan(700)
    world.step(frame)
    expect(world.read(ids[0]).vy).toBeLessThan(-500)
  })

  it('hangs from a hand that is as strong where gravity points upwards', () => {
    const { world, ids } = worldOf([{ ...pill, x: 320, y: 100 }], { gravity: -20_000 })
    const grab = world.grab(ids[0], 320, 100)
    grab.moveTo(320, 100, 0)
    run(world, 2)
    expect(Math.abs(world.read(ids[0]).y - 100)).toBeLessThan(40)
    expect(Math.abs(world.read(ids[0]).vy)).toBeLessThan(1)
  })

  it('is not thrown by a hand that stood still for a fifth of a second', () => {
    const { world, ids } = worldOf([{ ...pill, x: 200, y: 100 }], { width: 4000, gravity: 0 })
    const grab = world.grab(ids[0], 200, 100)
    for (let k = 0; k < 15; k++) {
      grab.moveTo(200 + 16 * k, 100, k * frame)
      world.step(frame)
    }
    run(world, 0.2)
    const { vx } = world.read(ids[0])
    grab.release()
    expect(world.read(ids[0]).vx).toBe(vx)
  })

  it('follows at once after it was held still where it lay for seconds', () => {
    const { world, ids } = pile([{ ...pill, x: 320, y: floor - 15 }])
    const grab = world.grab(ids[0], 320, floor - 15)
    run(world, 3)
    for (let k = 1; k <= 60; k++) {
      grab.moveTo(320, floor - 15 - 2 * k, 3 + k * frame)
      world.step(frame)
    }
    expect(world.read(ids[0]).y).toBeLessThan(floor - 115)
  })

  it('falls straight down if it hung still', () => {
    const { world, ids } = worldOf([{ ...pill, x: 320, y: 100 }])
    const grab = world.grab(ids[0], 320, 100)
    for (let k = 1; k <= 120; k++) {
      grab.moveTo(320, 100, k * frame)
      world.step(frame)
    }
    grab.release()
    const { vx, vy } = world.read(ids[0])
    expect(Math.hypot(vx, vy)).toBeLessThan(5)
  })

  it('does not fly off if it was stuck while the pointer flew by', () => {
    const { world, ids } = worldOf([{ ...pill, x: 320, y: floor - 15 }])
    const grab = world.grab(ids[0], 320, floor - 15)
    for (let k = 1; k <= 30; k++) {
      grab.moveTo(320, floor - 15 + 60 * k, k * frame)
      world.step(frame)
    }
    grab.release()
    const { vx, vy } = world.read(ids[0])
    expect(Math.hypot(vx, vy)).toBeLessThan(300)
  })

  it('may be let go twice, and its pointer may move on: nothing happens', () => {
    const { world, ids } = worldOf([{ ...pill, x: 320, y: 100 }])
    const grab = world.grab(ids[0], 320, 100)
    run(world, 0.5)
    grab.release()
    const before = world.hash()
    grab.release()
    grab.moveTo(0, 0, 9)
    expect(world.hash()).toBe(before)
    expect(settle(world)).toBeLessThan(360)
    expect(world.read(ids[0]).y).toBeCloseTo(floor - 15, 1)
  })

  it('may be taken out of the world while it is held', () => {
    const { world, ids } = worldOf([{ ...pill, x: 320, y: 100 }])
    const grab = world.grab(ids[0], 320, 100)
    world.remove(ids[0])
    const id = world.add({ ...pill, x: 100, y: 100 })
    grab.moveTo(600, 20, 1)
    run(world, 0.5)
    grab.release()
    settle(world)
    expect(world.resting).toBe(true)
    expect(world.read(id).x).toBeCloseTo(100, 3)
  })

  it('is not to be had once it is out of the world', () => {
    const { world, ids } = worldOf([{ ...pill, x: 320, y: 100 }])
    world.remove(ids[0])
    const grab = world.grab(ids[0], 320, 100)
    world.add({ ...pill, x: 100, y: 100 })
    grab.moveTo(600, 20, 1)
    run(world, 0.5)
    grab.release()
    settle(world)
    expect(world.resting).toBe(true)
    expect(world.read(ids[0]).x).toBeCloseTo(100, 3)
  })

  it('may be caught again, at the very point, however fast it spins', () => {
    const { world, ids } = worldOf([{ ...pill, x: 320, y: 100, spin: 20 }])
    run(world, 0.1)
    const { x, y, angle } = world.read(ids[0])
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)]
    const joint = createJoint(world.scene.bodies, ids[0], x + 30 * cos - 5 * sin, y + 30 * sin + 5 * cos)
    expect(joint.localX).toBeCloseTo(30, 6)
    expect(joint.localY).toBeCloseTo(5, 6)
  })

  it('is not thrown by one of two hands while the other holds it', () => {
    const { world, ids } = worldOf([{ ...pill, width: 160, x: 320, y: 200 }])
    const [still, moving] = [world.grab(ids[0], 250, 200), world.grab(ids[0], 390, 200)]
    for (let k = 0; k <= 10; k++) {
      still.moveTo(250, 200, k * frame)
      moving.moveTo(390, 200 - 600 * k * frame, k * frame)
      world.step(frame)
    }
    const before = world.read(ids[0])
    moving.release()
    const after = world.read(ids[0])
    expect([after.vx, after.vy]).toEqual([before.vx, before.vy])
  })

  it('is held by two pointers until both let go', () => {
    const { world, ids } = worldOf([{ ...pill, x: 320, y: 100 }])
    const [left, right] = [world.grab(ids[0], 290, 100), world.grab(ids[0], 350, 100)]
    run(world, 2)
    expect(world.read(ids[0]).y).toBeCloseTo(100, -1)
    expect(world.read(ids[0]).angle).toBeCloseTo(0, 1)
    left.release()
    run(world, 3)
    expect(world.read(ids[0]).y).toBeGreaterThan(120)
    right.release()
    settle(world)
    expect(world.resting).toBe(true)
  })
})

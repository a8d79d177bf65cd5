import type { Page } from '@playwright/test'
import { seeded } from '../scenes/seeded'
import { takeFrames } from './fixtures/frames'
import { hideTab } from './fixtures/hide-tab'
import { expect, test } from './fixtures/stage'

/** The pile that a page's drop ends in when its frames are this long, ms. */
async function pileOf(page: Page, frame: (random: () => number) => number) {
  const random = seeded(11)
  const times = Array.from({ length: 5000 }, () => frame(random))
  await page.evaluate((times) => window.drive(times), times)
  return page.evaluate(() =>
    [...document.querySelectorAll<HTMLElement>('[data-slot=gravity-stack-chip]')].map((chip) => {
      const m = new DOMMatrix(getComputedStyle(chip).transform)
      return [m.e, m.f, Math.atan2(m.b, m.a)]
    }),
  )
}

test.describe('whatever the display does', () => {
  test.beforeEach(async ({ page }) => {
    await page.addInitScript(takeFrames)
  })

  const displays: Record<string, (random: () => number) => number> = {
    'at 120 Hz': () => 1000 / 120,
    'at 144 Hz': () => 1000 / 144,
    'at 20 Hz': () => 50,
    'with frames of 4 to 50 ms in any order': (random) => 4 + 46 * random(),
    'where every frame takes 200 ms, in slow motion': () => 200,
    'with a gap of five seconds now and then': (random) => (random() < 0.05 ? 5000 : 16),
  }

  test('the pile is the one that steady frames give', async ({ stage, page }) => {
    const open = async () => {
      await stage.open('pile', { chips: 16, shape: 'all', stagger: 40 })
      await stage.reaches('running')
    }
    await open()
    const steady = await pileOf(page, () => 1000 / 60)
    await stage.reaches('resting')
    for (const [name, frames] of Object.entries(displays)) {
      await open()
      const pile = await pileOf(page, frames)
      await stage.reaches('resting')
      for (const [i, [x, y, angle]] of pile.entries()) {
        // What moves by less than a tenth of a pixel is not drawn again.
        expect(Math.hypot(x - steady[i][0], y - steady[i][1]), `${name}, chip ${i}`).toBeLessThan(0.3)
        expect(Math.abs(Math.sin((angle - steady[i][2]) / 2)), `${name}, chip ${i}`).toBeLessThan(0.01)
      }
    }
  })

  for (const rate of [60, 120, 144, 240]) {
    test(`a chip falls smoothly at ${rate} Hz: what is drawn follows one parabola`, async ({
      stage,
      page,
    }) => {
      await stage.open('pile', { chips: 1, box: 'h-[700px] w-[640px]', stagger: 0 })
      await stage.reaches('running')
      const drawn = await page.evaluate(
        (rate) => window.drive(Array.from({ length: Math.round(rate / 2) }, () => 1000 / rate)),
        rate,
      )
      const heights = drawn.map((transform) => Number(/translate\(.+?px, (.+?)px/.exec(transform)?.[1]))
      const falling = heights.filter((y, k) => k > rate / 20 && y < 600)
      expect(falling.length).toBeGreaterThan(rate / 5)
      // A parabola has no third differences, at any rate. A chip drawn one step late would show tens of px.
      for (let k = 3; k < falling.length; k++) {
        const [a, b, c, d] = falling.slice(k - 3, k + 1)
        expect(Math.abs(d - 3 * c + 3 * b - a)).toBeLessThan(1.5)
      }
    })
  }

  test('a display that stalls for 200 ms a frame shows slow motion, and full speed after that', async ({
    stage,
    page,
  }) => {
    await stage.open('pile', { chips: 1, box: 'h-[700px] w-[640px]', stagger: 0 })
    await stage.reaches('running')
    const drawn = await page.evaluate(() => window.drive([200, 200, 200, 200, 200, 16, 16, 16]))
    const y = drawn.map((transform) => Number(/translate\(.+?px, (.+?)px/.exec(transform)?.[1]))
    // Three steps a frame at most: 2600 px/s² add 130 px/s in each, and 6.5 px of way.
    for (let k = 2; k < 5; k++) expect(y[k] - 2 * y[k - 1] + y[k - 2]).toBeLessThan(8)
    const speed = (y[4] - y[3]) / 0.05
    expect((y[7] - y[6]) / 0.016 / speed).toBeGreaterThan(0.9)
    expect((y[7] - y[6]) / 0.016 / speed).toBeLessThan(1.5)
  })
})

test('after five seconds in a hidden tab a chip falls on from where it was, as if none had passed', async ({
  stage,
  page,
}) => {
  await page.addInitScript(takeFrames)
  const open = async () => {
    await stage.open('pile', { chips: 1, box: 'h-[700px] w-[640px]', stagger: 0 })
    await stage.reaches('running')
  }
  const drive = (frames: number) =>
    page.evaluate((frames) => window.drive(Array(frames).fill(1000 / 60)), frames)
  await open()
  const whole = await drive(30)
  expect(new Set(whole).size).toBeGreaterThan(25)
  await open()
  const before = await drive(15)
  await page.evaluate(hideTab, true)
  await page.evaluate(() => window.drive([5000]))
  await page.evaluate(hideTab, false)
  const [again, ...after] = await drive(16)
  expect([...before, ...after]).toEqual(whole)
  expect(again).toBe(before.at(-1))
})

test('ten thousand wild pointer events lose no chip and leave none held', async ({ stage, page }) => {
  await stage.settled('pile', { chips: 12, shape: 'all' })
  await page.evaluate(async () => {
    let seed = 7
    const random = () => {
      seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0
      return seed / 2 ** 32
    }
    const types = ['pointerdown', 'pointermove', 'pointermove', 'pointermove', 'pointerup', 'pointercancel']
    const chips = [...document.querySelectorAll('[data-slot=gravity-stack-chip]')]
    for (let i = 0; i < 10_000; i++) {
      const target = random() < 0.7 ? chips[Math.floor(random() * chips.length)] : document.body
      const box = target.getBoundingClientRect()
      const near = random() < 0.8
      target.dispatchEvent(
        new PointerEvent(types[Math.floor(random() * types.length)], {
          bubbles: true,
          composed: true,
          pointerId: random() < 0.5 ? 31 : 32,
          pointerType: random() < 0.2 ? 'touch' : 'mouse',
          clientX: near ? box.x + random() * box.width : (random() - 0.5) * 8000,
          clientY: near ? box.y + random() * box.height : (random() - 0.5) * 8000,
        }),
      )
      if (i % 50 === 0) await window.probe.pass(1)
    }
    for (const pointerId of [31, 32])
      document.body.dispatchEvent(new PointerEvent('pointerup', { bubbles: true, pointerId }))
  })
  await stage.reaches('resting')
  expect(new Set(await stage.states())).toEqual(new Set(['resting']))
  expect(await stage.overlap()).toBeLessThan(1)
  expect(await stage.outside()).toBeLessThan(1)
  expect(await stage.during('frames')).toBe(0)
})

test('five hundred children come and go at random, and those who stay lie still and apart', async ({
  stage,
  page,
}) => {
  await page.setViewportSize({ width: 1000, height: 600 })
  await stage.open('crowd')
  await page.waitForFunction(() => 'show' in window)
  await page.evaluate(async () => {
    let seed = 3
    const random = () => {
      seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0
      return seed / 2 ** 32
    }
    let there: number[] = []
    for (let next = 0; next < 500; ) {
      if (there.length < 70 && random() < 0.6) {
        const at = Math.floor(random() * (there.length + 1))
        there = there.toSpliced(at, 0, next++)
      } else there = there.filter(() => random() > 0.1)
      window.show(there)
      await window.probe.pass(random() < 0.3 ? 1 : 0)
    }
  })
  await stage.reaches('resting')
  expect(new Set(await stage.states())).toEqual(new Set(['resting']))
  expect(await stage.overlap()).toBeLessThan(1)
  expect(await stage.outside()).toBeLessThan(1)
  expect(await stage.hovering()).toBeLessThan(0.5)
  await page.evaluate(() => window.show([]))
  await expect(stage.chips).toHaveCount(0)
  await stage.reaches('resting')
  expect(await stage.during('frames')).toBe(0)
})

test('resized with each of 600 frames, collapsed to nothing and back, the pile ends at rest inside', async ({
  stage,
}) => {
  await stage.settled('pile', { chips: 14, shape: 'all' })
  await stage.root.evaluate(async (root) => {
    for (let i = 0; i < 600; i++) {
      root.style.width = `${330 + 300 * Math.sin(i / 9)}px`
      root.style.height = `${200 + 150 * Math.cos(i / 7)}px`
      // Now and then it is not there at all.
      root.style.display = i % 90 < 80 ? '' : 'none'
      if (i % 70 > 60) root.style.height = root.style.width = '0'
      await window.probe.pass(1)
    }
    root.style.cssText = 'width: 460px; height: 300px'
    await window.probe.pass(2)
  })
  await stage.reaches('resting')
  expect(new Set(await stage.states())).toEqual(new Set(['resting']))
  expect(await stage.overlap()).toBeLessThan(1)
  expect(await stage.outside()).toBeLessThan(1)
  expect(await stage.hovering()).toBeLessThan(0.5)
})

test('zoomed to 400 % in the middle of the fall, and back, the pile ends at rest inside', async ({
  stage,
  page,
}) => {
  const session = await page.context().newCDPSession(page)
  const zoom = (times: number) =>
    session.send('Emulation.setDeviceMetricsOverride', {
      width: Math.round(1280 / times),
      height: Math.round(1024 / times),
      deviceScaleFactor: times,
      mobile: false,
    })
  await zoom(1)
  await stage.open('pile', { chips: 20, box: 'h-[240px] w-full', stagger: 60 })
  await expect(stage.chips.nth(9)).toHaveAttribute('data-state', 'falling')
  for (const times of [4, 1, 4]) {
    await zoom(times)
    await expect.poll(() => page.evaluate(() => devicePixelRatio)).toBe(times)
    await page.evaluate(() => window.probe.pass(5))
  }
  await stage.reaches('resting')
  expect(await stage.overlap()).toBeLessThan(1)
  expect(await stage.outside()).toBeLessThan(1)
  await zoom(1)
  await stage.reaches('running')
  await stage.reaches('resting')
  expect(await stage.overlap()).toBeLessThan(1)
  expect(await stage.outside()).toBeLessThan(1)
})

for (const seed of [1, 2, 3]) {
  test(`whatever is done to a stage, in any order, its chips end at rest, apart and in reach (${seed})`, async ({
    stage,
    page,
  }) => {
    await page.setViewportSize({ width: 1000, height: 700 })
    await stage.open('anything')
    await page.waitForFunction(() => 'disturb' in window)
    for (const [part, reducedMotion] of (['no-preference', 'reduce', 'no-preference'] as const).entries()) {
      await page.emulateMedia({ reducedMotion })
      await page.evaluate((seed) => window.disturb(seed, 60), 3 * seed + part)
    }
    await page.evaluate(() => window.tidy())
    await stage.reaches('resting')
    expect(new Set(await stage.states())).toEqual(new Set(['resting']))
    expect(await stage.overlap()).toBeLessThan(0.3)
    expect(await stage.outside()).toBeLessThan(0.3)
    expect(await stage.hovering()).toBeLessThan(0.5)
    expect(await stage.during('frames')).toBe(0)
    expect(await stage.probe(({ timers }) => timers)).toBe(0)
    const chip = stage.chips.filter({ hasNot: page.locator('input') }).first()
    await stage.drag(chip, 0, -60)
    await expect(chip).toHaveAttribute('data-state', 'held')
    await page.mouse.up()
    await stage.reaches('resting')
    await page.evaluate(() => window.leave())
    await expect(stage.root).toHaveCount(0)
    await stage.isGone()
  })
}

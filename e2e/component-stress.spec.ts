import { expect, test } from './fixtures/stage'

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

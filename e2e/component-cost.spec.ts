import type { Page } from '@playwright/test'
import { expect, test } from './fixtures/stage'

test('before the stage is near the view nothing runs: no frame, no layout read, one shared observer', async ({
  stage,
  page,
}) => {
  await page.setViewportSize({ width: 800, height: 500 })
  await stage.open('pile', { above: 1500, below: 500 })
  await page.waitForLoadState('networkidle')
  await page.evaluate(() => window.probe.pass(20))
  const cost = await stage.probe(({ frames, layoutReads, styleWrites, timers, observed, listeners }) => ({
    frames,
    layoutReads,
    styleWrites,
    timers,
    observed: { ...observed },
    listeners: { ...listeners },
  }))
  expect(cost).toEqual({
    frames: 0,
    layoutReads: 0,
    styleWrites: 0,
    timers: 0,
    observed: { intersection: 1, resize: 0, mutation: 0 },
    listeners: {},
  })
})

test('waiting for the next release while all others sleep, a timer runs and no frames', async ({ stage }) => {
  await stage.open('pile', { chips: 2, stagger: 60000 })
  await expect(stage.chips.first()).toHaveAttribute('data-state', 'resting')
  expect(await stage.during('frames')).toBe(0)
  expect(await stage.probe((probe) => probe.timers)).toBe(1)
  await stage.reaches('running')
})

test('after that wait the next chip falls as ever', async ({ stage }) => {
  await stage.settled('pile', { chips: 3, stagger: 2500 })
  expect(await stage.overlap()).toBeLessThan(1)
})

test('a chip is drawn again only when one of its corners has gone a tenth of a pixel', async ({ stage }) => {
  await stage.settled('pile', { chips: 40, shape: 'all' })
  const { writes, smallest } = await stage.probe((probe) => ({
    writes: probe.styleWrites,
    smallest: probe.smallestMove,
  }))
  expect(writes).toBeGreaterThan(500)
  expect(smallest).toBeGreaterThanOrEqual(0.1)
})

test('a frame writes each moved chip once, its transform alone, and reads no layout', async ({
  stage,
  page,
}) => {
  await stage.open('pile', { chips: 30, stagger: 0 })
  await stage.reaches('running')
  const worst = await page.evaluate(async () => {
    await window.probe.pass(2)
    const reads = window.probe.layoutReads
    let most = 0
    for (let i = 0; i < 30; i++) {
      const before = window.probe.styleWrites
      await window.probe.pass(1)
      most = Math.max(most, window.probe.styleWrites - before)
    }
    const styles = [...document.querySelectorAll<HTMLElement>('[data-slot=gravity-stack-chip]')].map((chip) =>
      [...chip.style].join(),
    )
    return { most, reads: window.probe.layoutReads - reads, styles: [...new Set(styles)] }
  })
  expect(worst.most).toBeLessThanOrEqual(30)
  expect(worst.reads).toBe(0)
  expect(worst.styles).toEqual(['transform'])
})

test('only chips that move have a layer of their own', async ({ stage, page }) => {
  await stage.open('pile', { chips: 12, stagger: 300 })
  await expect(stage.chips.nth(6)).toHaveAttribute('data-state', 'falling')
  const layers = await stage.chips.evaluateAll((all) =>
    all.map((chip) => [(chip as HTMLElement).dataset.state, getComputedStyle(chip).willChange]),
  )
  for (const [state, layer] of layers) expect(layer).toBe(state === 'falling' ? 'transform' : 'auto')
  await stage.reaches('resting')
  expect(
    await page.locator('[data-slot=gravity-stack]').evaluate((root) => getComputedStyle(root).contain),
  ).toBe('content')
})

test('while one chip is lifted, those that do not touch it sleep on and are not drawn', async ({
  stage,
  page,
}) => {
  await stage.settled('pile', { chips: 3 })
  const chip = stage.chips.nth(0)
  const styles = () =>
    stage.chips.evaluateAll((all) => all.slice(1).map((other) => other.getAttribute('style')))
  const before = await styles()
  await stage.drag(chip, 0, -120)
  await expect(chip).toHaveAttribute('data-state', 'held')
  await stage.hangs(chip)
  expect(await stage.states()).toEqual(['held', 'resting', 'resting'])
  expect(await styles()).toEqual(before)
  await page.mouse.up()
})

test('mounting 60 chips reads layout once for each chip and the stage, in an observer', async ({ stage }) => {
  await stage.open('pile', { chips: 60, stagger: 60000 })
  await stage.reaches('running')
  // One computed style each, the two inner lengths of the stage, and in development a look for Tailwind's styles.
  // React StrictMode mounts twice, and only the second mount comes to see.
  expect(await stage.probe((probe) => probe.layoutReads)).toBeLessThanOrEqual(63)
})

/** How often the page has been laid out so far. */
async function layouts(page: Page) {
  const session = await page.context().newCDPSession(page)
  await session.send('Performance.enable')
  const { metrics } = await session.send('Performance.getMetrics')
  await session.detach()
  return metrics.find(({ name }) => name === 'LayoutCount')!.value
}

test('bringing 60 chips to life lays the page out once, and once more for the first release', async ({
  stage,
  page,
}) => {
  await page.route('**/client-*.js', async (route) => {
    await page.evaluate(() => window.probe.pass(3))
    still = await layouts(page)
    await route.continue()
  })
  let still = 0
  await stage.open('pile', { chips: 60, stagger: 60000 })
  await stage.reaches('running')
  await expect(stage.chips.first()).toHaveAttribute('data-state', 'resting')
  expect((await layouts(page)) - still).toBeLessThanOrEqual(2)
})

test('the fall lays nothing out', async ({ stage, page }) => {
  await stage.open('pile', { chips: 30, stagger: 0 })
  await stage.reaches('running')
  await expect(stage.chips.last()).toHaveAttribute('data-state', 'falling')
  await page.evaluate(() => window.probe.pass(3))
  const before = await layouts(page)
  await page.evaluate(() => window.probe.pass(30))
  expect((await layouts(page)) - before).toBe(0)
  await stage.reaches('resting')
})

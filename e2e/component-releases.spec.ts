import type { Page } from '@playwright/test'
import { hideTab } from './fixtures/hide-tab'
import { expect, test } from './fixtures/stage'
import { keepWaits, letTimePass } from './fixtures/time'

test('chips that come seconds apart come one at a time', async ({ stage }) => {
  await stage.page.addInitScript(() => {
    const fell: number[] = []
    Object.assign(window, { fell })
    new MutationObserver((records) => {
      for (const { target, oldValue } of records)
        if (oldValue === 'waiting' && (target as HTMLElement).dataset.slot === 'gravity-stack-chip')
          fell.push(performance.now())
    }).observe(document, { subtree: true, attributeFilter: ['data-state'], attributeOldValue: true })
  })
  await stage.open('pile', { chips: 3, stagger: 4000 })
  await expect(stage.chips.nth(2)).not.toHaveAttribute('data-state', 'waiting')
  const fell = await stage.page.evaluate(() => (window as unknown as { fell: number[] }).fell)
  // Far from at once, on the slowest machine too.
  expect(fell[2] - fell[1]).toBeGreaterThan(2000)
})

test('a new stagger leaves a pile at rest alone', async ({ stage, page }) => {
  await stage.settled('extras')
  await page.locator('#pace').click()
  await stage.probe((probe) => probe.pass(5))
  await expect(stage.root).toHaveAttribute('data-state', 'resting')
  expect(await stage.probe((probe) => probe.states.filter((state) => state === 'running').length)).toBe(1)
})

/** Counts from now on how many chips each frame releases. */
async function countReleases(page: Page) {
  await page.addInitScript(() => {
    const together: number[] = []
    Object.assign(window, { together })
    new MutationObserver((records) => {
      const released = records.filter(
        ({ target, oldValue }) =>
          oldValue === 'waiting' && (target as HTMLElement).dataset.slot === 'gravity-stack-chip',
      )
      if (released.length > 0) together.push(released.length)
    }).observe(document, { subtree: true, attributeFilter: ['data-state'], attributeOldValue: true })
  })
  return async () =>
    Math.max(...(await page.evaluate(() => (window as unknown as { together: number[] }).together)))
}

test('a new stagger holds for chips that wait already: they come one by one', async ({ stage, page }) => {
  const mostAtOnce = await countReleases(page)
  await stage.open('extras', { stagger: 60000 })
  await expect(stage.chips.first()).toHaveAttribute('data-state', 'resting')
  expect(await stage.states()).toContain('waiting')
  await page.locator('#pace').click()
  await expect.poll(() => stage.states()).not.toContain('waiting')
  await stage.reaches('resting')
  expect(await mostAtOnce()).toBeLessThan(5)
})

test('chips come down while the stagger changes with every frame', async ({ stage }) => {
  await stage.open('surroundings', { kind: 'restless' })
  await expect(stage.chips.nth(2)).not.toHaveAttribute('data-state', 'waiting')
})

test('chips that come when a hundred that waited have gone fall at once', async ({ stage, page }) => {
  await stage.open('surroundings', { kind: 'filtered' })
  await expect(stage.chips.nth(3)).not.toHaveAttribute('data-state', 'waiting')
  await page.locator('#next').click()
  await expect(stage.chips).toHaveCount(3)
  await stage.reaches('resting')
})

test('chips to come still come one by one when one is tapped after the computer has slept', async ({
  stage,
  page,
}) => {
  await letTimePass(page)
  const mostAtOnce = await countReleases(page)
  await stage.open('pile', { chips: 4, stagger: 2500 })
  const first = stage.chips.first()
  await expect(first).toHaveAttribute('data-state', 'resting')
  const { x, y } = await stage.centre(first)
  await page.evaluate(() => {
    window.passed = 30_000
  })
  await page.mouse.click(x, y)
  await stage.reaches('resting')
  expect(await mostAtOnce()).toBe(1)
})

test('no time passes for the chips to come while the tab is hidden', async ({ stage, page }) => {
  await letTimePass(page)
  await keepWaits(page, 5000)
  await stage.open('pile', { chips: 2, stagger: 60000 })
  await expect(stage.chips.first()).toHaveAttribute('data-state', 'resting')
  await page.evaluate(hideTab, true)
  await stage.reaches('paused')
  await page.evaluate(() => {
    window.passed = 20_000
  })
  await page.evaluate(hideTab, false)
  await stage.reaches('running')
  expect(await page.evaluate(() => window.waits.at(-1))).toBeGreaterThan(45_000)
})

test('who plays with the pile does not hold back the chips to come', async ({ stage, page }) => {
  await letTimePass(page)
  await keepWaits(page, 5000)
  await stage.open('pile', { chips: 2, stagger: 60000 })
  const [first, second] = [stage.chips.nth(0), stage.chips.nth(1)]
  await expect(first).toHaveAttribute('data-state', 'resting')
  await page.evaluate(() => {
    window.passed = 20_000
  })
  const { x, y } = await stage.centre(first)
  await page.mouse.click(x, y)
  await expect(first).toHaveAttribute('data-state', 'falling')
  await expect(first).toHaveAttribute('data-state', 'resting')
  await expect(second).toHaveAttribute('data-state', 'waiting')
  // ms that the second was still to wait when the first lay still, before and after the tap.
  const [before, after] = await page.evaluate(() => window.waits.slice(-2))
  expect(before - after).toBeGreaterThan(20_000)
})

test('who goes to a chip by the keyboard does not hold back the chips to come', async ({ stage, page }) => {
  await letTimePass(page)
  await keepWaits(page, 5000)
  await stage.open('controls', { stagger: 60_000 })
  await expect(stage.chips.first()).toHaveAttribute('data-state', 'resting')
  await page.evaluate(() => {
    window.passed = 20_000
  })
  await page.getByText('a button').focus()
  await expect(stage.chip('a button')).toHaveAttribute('data-state', 'resting')
  await stage.probe((probe) => probe.pass(3))
  // ms from now to the third, which comes 120 s after the first.
  expect(await page.evaluate(() => window.waits.at(-1))).toBeLessThan(105_000)
})

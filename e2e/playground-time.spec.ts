import { expect, type Page } from '@playwright/test'
import { playgroundStage as stage, test } from './page'

/** What the row below the stage says of the last step. */
const number = (page: Page, name: string) =>
  page.locator('dt', { hasText: new RegExp(`^${name}$`) }).locator('+ dd')

test('the numbers say what the solver did in the last step', async ({ page }) => {
  await page.goto('/playground?count=12&shape=boxes')
  const names = ['awake chips', 'pairs', 'contacts', 'sub-steps', 'µs a step']
  for (const name of names) await expect(number(page, name)).not.toHaveText('0')
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
  for (const name of names) await expect(number(page, name)).toHaveText('0')
})

/**
 * One chip in the air of a paused stage. The function that it returns presses Step and tells its height, px.
 */
async function falling(page: Page) {
  // Nothing falls before the first press on Step.
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/playground?count=1&stagger=0')
  await expect(page.getByText('Motion is off')).toBeVisible()
  const chip = page.locator(`${stage} [data-chip]`)
  const height = () => chip.evaluate((element) => new DOMMatrix(getComputedStyle(element).transform).f)
  const step = async () => {
    await page.getByRole('button', { name: 'Step' }).click()
    return height()
  }
  const waiting = await height()
  // It is let go after a few frames.
  await expect.poll(step, { intervals: [0] }).not.toBe(waiting)
  return step
}

test('paused, a press on Step moves the chips by one frame', async ({ page }) => {
  const step = await falling(page)
  const [first, second, third] = [await step(), await step(), await step()]
  // Gravity makes the way of each frame longer by as much; the air takes a hundredth of a pixel of it.
  expect(third - second - (second - first)).toBeCloseTo(2600 / 60 ** 2, 1)
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'paused')
})

test('a slider of the playground acts on the chips in the air', async ({ page }) => {
  const step = await falling(page)
  await page.getByLabel('gravity').press('Home')
  const [a, b, c] = [await step(), await step(), await step()]
  expect(c - b - (b - a)).toBeCloseTo(0, 0)
})

test('a slider of the playground wakes a pile that lies', async ({ page }) => {
  await page.goto('/playground?count=3')
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
  await page.getByLabel('gravity').press('End')
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'running')
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
})

test('what passes while a laptop is closed is not computed', async ({ page }) => {
  await page.clock.install({ time: 0 })
  await page.clock.pauseAt(1000)
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/playground?count=2&stagger=500')
  await page.getByRole('button', { name: 'Play' }).click()
  await page.clock.runFor(200)
  await page.clock.fastForward(600_000)
  await page.clock.runFor(100)
  await expect(number(page, 'awake chips')).toHaveText('1')
})

test('at 1/20 of the speed a second is three frames', async ({ page }) => {
  await page.clock.install({ time: 0 })
  await page.clock.pauseAt(1000)
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/playground?count=1&stagger=0')
  await page.getByRole('button', { name: 'Speed 1/20×' }).click()
  await page.getByRole('button', { name: 'Play' }).click()
  await page.clock.runFor(1000)
  await expect(number(page, 'awake chips')).toHaveText('0')
  await page.getByRole('button', { name: 'Speed 1×' }).click()
  await page.clock.runFor(200)
  await expect(number(page, 'awake chips')).toHaveText('1')
})

test('a playground at rest asks for no frame', async ({ page }) => {
  await page.goto('/playground?count=3')
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
  const asked = await page.evaluate(async () => {
    const { requestAnimationFrame } = window
    let asked = 0
    window.requestAnimationFrame = (callback) => {
      asked++
      return requestAnimationFrame(callback)
    }
    for (let frame = 0; frame < 10; frame++) await new Promise((done) => requestAnimationFrame(done))
    return asked
  })
  expect(asked).toBe(0)
})

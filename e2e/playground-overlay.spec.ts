import { expect, type Page } from '@playwright/test'
import { playgroundStage as stage, test } from './page'

/** How many colours of islands the overlay shows, and how many px are grey or the red of contacts. */
const colours = (page: Page) =>
  page.locator(`${stage} canvas`).evaluate((canvas: HTMLCanvasElement) => {
    const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height)
    const islands = new Map<string, number>()
    const count = { grey: 0, red: 0 }
    for (let i = 0; i < data.length; i += 4) {
      const [r, g, b, alpha] = data.subarray(i, i + 4)
      if (alpha < 255) continue
      if (r === 0xba && g === 0xb3 && b === 0xab) count.grey++
      else if (r > 180 && g < 110 && b < 110) count.red++
      else if (Math.max(r, g, b) - Math.min(r, g, b) > 60) {
        const colour = [r, g, b].join()
        islands.set(colour, (islands.get(colour) ?? 0) + 1)
      }
    }
    // A hull has thousands, a smoothed edge a few.
    return { ...count, islands: [...islands.values()].filter((pixels) => pixels > 800).length }
  })

test('the overlay is drawn anew in the colours of another theme', async ({ page }) => {
  await page.emulateMedia({ colorScheme: 'light' })
  await page.goto('/playground?count=2')
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
  await page.getByRole('button', { name: 'Overlay' }).click()
  const drawn = () =>
    page.locator(`${stage} canvas`).evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL())
  const light = await drawn()
  await page.emulateMedia({ colorScheme: 'dark' })
  await expect.poll(async () => (await drawn()) === light).toBe(false)
  await page.emulateMedia({ colorScheme: 'light' })
  await expect.poll(async () => (await drawn()) === light).toBe(true)
})

test('the overlay tints islands while they move, greys what sleeps, and draws contacts with their forces', async ({
  page,
}) => {
  // Nothing falls before the first press on Step.
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/playground?count=12&shape=boxes&stagger=0')
  await expect(page.getByText('Motion is off')).toBeVisible()
  await page.getByRole('button', { name: 'Overlay' }).click()
  await expect(page.getByText('dots are contact points')).toBeVisible()
  await expect(async () => {
    await page.getByRole('button', { name: 'Step' }).click()
    expect((await colours(page)).islands).toBeGreaterThan(2)
  }).toPass({ intervals: [0] })
  await page.getByRole('button', { name: 'Play' }).click()
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
  const { islands, grey, red } = await colours(page)
  expect(islands).toBe(0)
  expect(grey).toBeGreaterThan(12 * 800)
  // Two points and two lines at least under each box.
  expect(red).toBeGreaterThan(12 * 2 * 6)
})

test.describe('on a fine screen', () => {
  test.use({ deviceScaleFactor: 2 })

  test('the overlay has the screen’s own pixels, and what sleeps a dashed outline', async ({ page }) => {
    await page.addInitScript(() => {
      const dashes: number[][] = []
      Object.assign(window, { dashes })
      const { setLineDash } = CanvasRenderingContext2D.prototype
      CanvasRenderingContext2D.prototype.setLineDash = function (dash) {
        dashes.push([...dash])
        setLineDash.call(this, dash)
      }
    })
    await page.goto('/playground?count=2')
    await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
    await page.getByRole('button', { name: 'Overlay' }).click()
    const canvas = page.locator(`${stage} canvas`)
    await expect
      .poll(() => canvas.evaluate((canvas: HTMLCanvasElement) => canvas.width / canvas.clientWidth))
      .toBe(2)
    const dashed = await page.evaluate(
      () => (window as unknown as { dashes: number[][] }).dashes.filter((dash) => dash.length > 0).length,
    )
    expect(dashed).toBeGreaterThan(1)
  })
})

test('the overlay of a paused stage is there at once', async ({ page }) => {
  await page.goto('/playground?count=3')
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
  await page.getByRole('button', { name: 'Pause' }).click()
  await page.getByRole('button', { name: 'Overlay' }).click()
  await expect.poll(async () => (await colours(page)).grey).toBeGreaterThan(3 * 800)
})

test('the overlay shows how a falling chip is expected to lie, and so it comes to lie, its word the right way up', async ({
  page,
}) => {
  await page.addInitScript(() => {
    // The angle of what is drawn last with the fine dashes of what is expected.
    const { rotate, setLineDash } = CanvasRenderingContext2D.prototype
    let angle = Number.NaN
    CanvasRenderingContext2D.prototype.rotate = function (turn) {
      angle = turn
      rotate.call(this, turn)
    }
    CanvasRenderingContext2D.prototype.setLineDash = function (dash) {
      if (String(dash) === '2,3') Object.assign(window, { expected: angle })
      setLineDash.call(this, dash)
    }
  })
  // Nothing falls before the first press on Step.
  await page.emulateMedia({ reducedMotion: 'reduce' })
  // A drop in which the word comes in upside down.
  await page.goto('/playground?count=1&words=Up&seed=3')
  await expect(page.getByText('Motion is off')).toBeVisible()
  await page.getByRole('button', { name: 'Overlay' }).click()
  const step = page.getByRole('button', { name: 'Step' })
  const drawn = () =>
    page.locator('[data-chip]').evaluate((chip) => {
      const { a, b, f } = new DOMMatrix(getComputedStyle(chip).transform)
      return { angle: Math.atan2(b, a), top: f }
    })
  while ((await drawn()).top < 100) await step.click()
  const expected = await page.evaluate(() => (window as unknown as { expected: number }).expected)
  const { angle: falling } = await drawn()
  await page.getByRole('button', { name: 'Play' }).click()
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
  const { angle: resting } = await drawn()
  expect(Math.cos(falling)).toBeLessThan(0)
  expect(resting).toBeCloseTo(expected, 1)
  expect(Math.cos(resting)).toBeGreaterThan(0.9)
})

import { expect, type Page } from '@playwright/test'
import { test } from './alive'

const stage = '[data-slot=playground-stage]'

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

test('the overlay tints islands while they move, greys what sleeps, and draws contacts with their impulses', async ({
  page,
}) => {
  await page.goto('/playground?count=12&shape=boxes&stagger=0')
  await page.getByRole('button', { name: 'Overlay' }).click()
  await expect(page.getByText('Dots are contact points')).toBeVisible()
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
  await page.getByRole('button', { name: 'Pause' }).click()
  await page.getByRole('button', { name: 'Drop' }).click()
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

test('the numbers say what the solver did in the last step', async ({ page }) => {
  await page.goto('/playground?count=12&shape=boxes')
  const number = (name: string) => page.locator('dt', { hasText: new RegExp(`^${name}$`) }).locator('+ dd')
  for (const name of ['awake chips', 'pairs', 'contacts', 'substeps', 'µs a step'])
    await expect(number(name)).not.toHaveText('0')
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
  await expect(number('awake chips')).toHaveText('0')
  expect(Number(await number('contacts').textContent())).toBeGreaterThan(11)
})

import { expect, type Page, test } from '@playwright/test'

const stage = '[data-slot=playground-stage]'

/** Colours on the overlay, with how many px each has; a hull's fill is let through by a quarter, its lines are not. */
const colours = (page: Page) =>
  page.locator(`${stage} canvas`).evaluate((canvas: HTMLCanvasElement) => {
    const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height)
    const fills = new Map<string, number>()
    let red = 0
    for (let i = 0; i < data.length; i += 4) {
      const [r, g, b, alpha] = data.subarray(i, i + 4)
      // Eight steps a channel: what the canvas rounds is one colour.
      const colour = [r, g, b].map((channel) => channel >> 5).join()
      if (Math.abs(alpha - 191) < 2) fills.set(colour, (fills.get(colour) ?? 0) + 1)
      if (alpha === 255 && r > 180 && g < 120 && b < 110) red++
    }
    return { fills: [...fills.values()].filter((count) => count > 300).length, red }
  })

test('the overlay tints islands while they move, greys what sleeps, and draws contacts with their impulses', async ({
  page,
}) => {
  await page.goto('/playground?count=12&shape=boxes&stagger=100')
  await page.getByRole('button', { name: 'Overlay' }).click()
  await expect(page.getByText('Dots are contact points')).toBeVisible()
  await expect.poll(async () => (await colours(page)).fills, { intervals: [50] }).toBeGreaterThan(2)
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting', { timeout: 30_000 })
  const { fills, red } = await colours(page)
  expect(fills).toBe(1)
  expect(red).toBeGreaterThan(12 * 2 * 6)
})

test('the numbers say what the solver did in the last step', async ({ page }) => {
  await page.goto('/playground?count=12&shape=boxes')
  const number = (name: string) => page.locator('dt', { hasText: new RegExp(`^${name}$`) }).locator('+ dd')
  for (const name of ['awake chips', 'pairs', 'contacts', 'substeps', 'µs a step'])
    await expect(number(name)).not.toHaveText('0')
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting', { timeout: 30_000 })
  await expect(number('awake chips')).toHaveText('0')
  expect(Number(await number('contacts').textContent())).toBeGreaterThan(11)
})

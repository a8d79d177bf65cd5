import { readFileSync } from 'node:fs'
import AxeBuilder from '@axe-core/playwright'
import { expect } from '@playwright/test'
import { test } from './page'

type Item = { name: string; type: string; meta: { heights: { wide: number; narrow: number } } }

const items: Item[] = JSON.parse(readFileSync('registry.json', 'utf8')).items
const blocks = items.filter(({ type }) => type === 'registry:block')
const chips = '[data-slot=gravity-stack-chip]'

for (const { name, meta } of blocks) {
  test(`${name} comes to rest, fits its frame and any phone, and is accessible in both themes`, async ({
    page,
  }) => {
    const errors: string[] = []
    page.on('pageerror', ({ message }) => errors.push(message))
    for (const [width, height, colorScheme] of [
      [1280, meta.heights.wide, 'light'],
      [341, meta.heights.narrow, 'dark'],
    ] as const) {
      await page.setViewportSize({ width, height })
      await page.emulateMedia({ colorScheme })
      await page.goto(`/blocks/${name}`)
      await expect(page.locator('[data-slot=gravity-stack]')).toHaveAttribute('data-state', 'resting')
      const beyond = await page.evaluate(() => {
        const { scrollWidth, scrollHeight } = document.documentElement
        return [scrollWidth - innerWidth, scrollHeight - innerHeight]
      })
      expect(beyond, `${width} px`).toEqual([0, 0])
      const axe = new AxeBuilder({ page }).setLegacyMode().options({ resultTypes: ['violations'] })
      // A part of a page is no page: the rest of it brings the landmarks and the heading that are missing.
      axe.disableRules(['region', 'page-has-heading-one', 'landmark-one-main'])
      expect((await axe.analyze()).violations, colorScheme).toEqual([])
    }
    expect(errors).toEqual([])
  })

  test(`${name} shows every chip upright inside its stage with reduced motion, and without script`, async ({
    page,
    browser,
    baseURL,
  }) => {
    const still = await browser.newContext({ baseURL, javaScriptEnabled: false })
    const plain = await still.newPage()
    await page.emulateMedia({ reducedMotion: 'reduce' })
    for (const shown of [page, plain]) {
      await shown.setViewportSize({ width: 320, height: 700 })
      await shown.goto(`/blocks/${name}`)
      await expect(shown.locator(chips).first()).toBeVisible()
      const outside = await shown.locator('[data-slot=gravity-stack]').evaluate((stage) => {
        const { top, left, right, bottom } = stage.getBoundingClientRect()
        return [...stage.children].filter((chip) => {
          const box = chip.getBoundingClientRect()
          return box.top < top || box.left < left || box.right > right || box.bottom > bottom
        }).length
      })
      expect(outside).toBe(0)
    }
    await still.close()
  })
}

test('the page of blocks has neither frames nor code of those that nobody has come near', async ({
  page,
  request,
}) => {
  const html = await (await request.get('/blocks')).text()
  const withoutScript = html.replaceAll(/<noscript>.*?<\/noscript>/gs, '')
  expect(withoutScript).not.toMatch(/<iframe|<span class="token/)
  // With the code of all blocks it was 467 kB, which a phone reads before it answers.
  expect(html.length / 1000).toBeLessThan(200)
  await page.goto('/blocks')
  await expect(page.locator('iframe').first()).toBeVisible()
  expect(await page.locator('iframe').count()).toBeLessThan(4)
})

test('a block is still until it is near the window, and takes the theme of the page around it', async ({
  page,
}) => {
  await page.emulateMedia({ colorScheme: 'light' })
  await page.goto('/blocks')
  const frame = page.locator(`#content iframe[title="Onboarding interests"]`)
  await expect(frame).toHaveCount(0)
  await page.getByRole('heading', { name: 'Onboarding interests' }).scrollIntoViewIfNeeded()
  await frame.scrollIntoViewIfNeeded()
  const inside = frame.contentFrame()
  await expect(inside.locator('[data-slot=gravity-stack]')).toHaveAttribute('data-state', 'resting')
  await expect(inside.locator('html')).not.toHaveClass(/dark/)
  await page.getByRole('button', { name: 'Switch between light and dark' }).click()
  await expect(inside.locator('html')).toHaveClass(/dark/)
  // A link of a block is an example.
  await inside.getByRole('link', { name: 'Skip' }).click()
  await expect(inside.getByRole('heading', { name: 'What do you like?' })).toBeVisible()
})

test('the tab Phone makes a block narrow, and Code shows the file that is installed', async ({ page }) => {
  await page.goto('/blocks')
  const box = page.locator('.code', { has: page.getByRole('tablist', { name: '404' }) })
  await box.getByRole('tab', { name: 'Phone' }).click()
  const width = () => box.locator('iframe').evaluate((frame) => frame.clientWidth)
  await expect.poll(width).toBe(375)
  await box.getByRole('tab', { name: 'Code' }).click()
  const file = readFileSync('registry/blocks/gravity-not-found.tsx', 'utf8').trim()
  await expect.poll(() => box.getByRole('tabpanel', { name: 'Code' }).locator('pre').textContent()).toBe(file)
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write'])
  await box.getByRole('button', { name: 'Copy code' }).click()
  await expect(box.getByRole('button', { name: 'Copied' })).toBeVisible()
  expect((await page.evaluate(() => navigator.clipboard.readText())).trim()).toBe(file)
})

test('code that could not be fetched is asked for again by its tab', async ({ page }) => {
  await page.route('**/gravity-not-found.html.txt', (route) => route.abort())
  await page.goto('/blocks')
  const box = page.locator('.code', { has: page.getByRole('tablist', { name: '404' }) })
  await box.getByRole('tab', { name: 'Code' }).click()
  await expect(box.getByText('could not be fetched')).toBeVisible()
  await page.unroute('**/gravity-not-found.html.txt')
  await box.getByRole('tab', { name: 'Code' }).click()
  await expect(box.locator('pre')).toContainText('export function GravityNotFound')
})

test('the newsletter is filled in by the keyboard alone, topics in the pile too', async ({ page }) => {
  await page.goto('/blocks/gravity-newsletter')
  await page.getByRole('textbox', { name: 'Email address' }).fill('me@example.com')
  await page.getByRole('button', { name: 'Subscribe' }).focus()
  for (const topic of ['Releases', 'Case studies']) {
    await page.keyboard.press('Tab')
    await expect(page.getByRole('checkbox', { name: topic })).toBeFocused()
    await page.keyboard.press('Space')
  }
  await page.keyboard.press('Enter')
  await expect(page.getByRole('status')).toHaveText(/me@example\.com about Releases, Case studies\.$/)
})

test('a reaction drops one more chip, and a filter falls when it is chosen and leaves when it is not', async ({
  page,
}) => {
  await page.goto('/blocks/gravity-reactions')
  await page.getByRole('button', { name: 'Applause' }).click()
  await expect(page.locator(chips)).toHaveCount(7)
  await expect(page.getByRole('button', { name: 'Applause' })).toContainText('13')
  await page.goto('/blocks/gravity-filters')
  await page.getByRole('button', { name: 'layout', exact: true }).click()
  await expect(page.getByRole('status')).toHaveText('1 article')
  await expect(page.locator(chips)).toHaveCount(2)
  await page.getByRole('button', { name: 'layout', exact: true }).click()
  await expect(page.locator(chips)).toHaveCount(1)
})

import { readdirSync, readFileSync } from 'node:fs'
import { expect } from '@playwright/test'
import { test } from './alive'

const json = (file: string) => JSON.parse(readFileSync(`bench/results/${file}`, 'utf8'))

test('Drop again drops the chips of a preview again', async ({ page }) => {
  await page.goto('/docs/gravity-stack')
  const stage = page.locator('[data-slot=gravity-stack]').first()
  await expect(stage).toHaveAttribute('data-state', 'resting')
  await page.getByRole('button', { name: 'Drop again' }).first().click()
  await expect(stage).toHaveAttribute('data-state', 'running')
})

for (const name of ['Heavier', 'Bouncier'])
  test(`${name} on the home page makes another pile, and the first one comes back without it`, async ({
    page,
  }) => {
    await page.goto('/')
    const stage = page.locator('[data-slot=gravity-stack]')
    const pile = async () => {
      await expect(stage).toHaveAttribute('data-state', 'resting')
      return stage
        .locator('[data-slot=gravity-stack-chip]')
        .evaluateAll((all) => all.map((e) => new DOMMatrix(getComputedStyle(e).transform).e))
    }
    const first = await pile()
    const moved = async () => {
      await page.getByRole('button', { name }).click()
      await expect(stage).toHaveAttribute('data-state', 'running')
      return Math.max(...(await pile()).map((x, i) => Math.abs(x - first[i])))
    }
    expect(await moved()).toBeGreaterThan(5)
    expect(await moved()).toBeLessThan(1)
  })

test('the home page has the figures of the committed benchmark', async ({ page }) => {
  const { cost } = json('results.json').pourCosts.find(
    (row: { engine: string; chips: number }) => row.engine === 'gravity-stack' && row.chips === 60,
  )
  const { script } = json('browser.json').stages['gravity-stack'].drops.find(
    (drop: { chips: number; throttle: number }) => drop.chips === 60 && drop.throttle === 1,
  )
  await page.goto('/')
  await expect(page.getByText(`${Math.round(cost.mean)} µs`, { exact: true })).toHaveCount(2)
  await expect(page.getByText(`${script.median.toFixed(1)} ms of script`)).toBeVisible()
})

test('what could not be copied is not said to be, and the button comes back', async ({ page }) => {
  await page.clock.install({ time: 0 })
  await page.clock.pauseAt(1000)
  await page.goto('/')
  await page.evaluate(() => {
    navigator.clipboard.writeText = () => Promise.reject(new Error())
  })
  const button = page.getByRole('button', { name: 'Copy command' })
  await button.click()
  await expect(page.getByRole('button', { name: 'Not copied' })).toBeVisible()
  await expect(page.getByRole('status').filter({ hasText: 'Not copied' })).toHaveCount(1)
  await page.clock.runFor(2000)
  await expect(button).toBeVisible()
})

test('Previous and Next go through the docs in the order of their list', async ({ page }) => {
  await page.goto('/docs')
  const order = await page
    .locator('main section li a')
    .evaluateAll((all) => all.map((a) => a.getAttribute('href')))
  expect([order[0], order.at(-2)]).toEqual(['/docs/setup', '/docs/changelog'])
  for (const [i, path] of order.entries()) {
    await page.goto(path!)
    const links = page.getByRole('navigation', { name: 'Previous and next' }).getByRole('link')
    expect(await links.evaluateAll((all) => all.map((a) => a.getAttribute('href')))).toEqual(
      [order[i - 1], order[i + 1]].filter(Boolean),
    )
  }
})

test('each page names its own address and its Markdown', async ({ page, baseURL }) => {
  for (const path of ['/docs/setup', '/docs', '/playground']) {
    await page.goto(path)
    await expect(page.locator('link[rel=canonical]')).toHaveAttribute('href', `${baseURL}${path}`)
    await expect(page.locator('link[type="text/markdown"]')).toHaveAttribute('href', `${baseURL}${path}.md`)
    expect(await page.title()).toContain('Gravity Stack')
  }
})

test('Markdown has the code of every example, the actions and the index its links', async ({ request }) => {
  const markdown = await (await request.get('/docs/gravity-stack.md')).text()
  for (const file of readdirSync('registry/examples'))
    expect(markdown).toContain(readFileSync(`registry/examples/${file}`, 'utf8').trim())
  expect(markdown).toContain('| `pause()` |')
  expect(await (await request.get('/docs.md')).text()).toContain('/docs/setup.md)')
  expect(await (await request.get('/llms-full.txt')).text()).toContain(markdown)
})

test('the props table has the defaults', async ({ page }) => {
  await page.goto('/docs/gravity-stack')
  const row = (name: string) =>
    page.getByRole('group', { name: 'Props' }).getByRole('row', { name: RegExp(`^${name}`) })
  for (const [name, value] of [
    ['gravity', '2600'],
    ['bounce', '0.18'],
    ['stagger', '150'],
    ['interactive', 'true'],
    ['friction', '0.4'],
  ])
    await expect(row(name).getByRole('cell').first()).toHaveText(value)
})

test('the menu marks the page, and closes by its button and by a press beside it', async ({ page }) => {
  await page.setViewportSize({ width: 375, height: 700 })
  await page.goto('/docs/setup')
  const menu = page.getByRole('dialog', { name: 'Menu' })
  const open = page.getByRole('button', { name: 'Menu' })
  await open.click()
  await expect(menu.locator('[aria-current=page]')).toHaveText(['Setup'])
  await expect(page.locator('html')).toHaveCSS('overflow', 'hidden')
  await menu.getByRole('button', { name: 'Close' }).click()
  await expect(menu).toBeHidden()
  await open.click()
  await page.mouse.click(10, 400)
  await expect(menu).toBeHidden()
})

test('tabs are one stop, and Home, End and the left arrow go from one to another', async ({ page }) => {
  await page.goto('/docs/gravity-stack')
  const tabs = page
    .getByRole('tablist', { name: /^Package manager/ })
    .first()
    .getByRole('tab')
  expect(await tabs.evaluateAll((all) => all.map((t) => (t as HTMLElement).tabIndex))).toEqual([
    0, -1, -1, -1,
  ])
  await tabs.first().press('End')
  await expect(tabs.nth(3)).toBeFocused()
  await tabs.nth(3).press('ArrowLeft')
  await expect(tabs.nth(2)).toBeFocused()
  await tabs.nth(2).press('Home')
  await expect(tabs.nth(0)).toBeFocused()
})

test('every control of a figure changes what it says', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/docs/how-it-works')
  const figures = page.locator('[data-slot=figure]')
  await expect(figures).toHaveCount(6)
  for (const figure of await figures.all()) {
    await figure.scrollIntoViewIfNeeded()
    const time = figure.getByLabel('Time', { exact: true })
    await time.press('End')
    await time.press('ArrowLeft')
    const said = figure.locator(':scope > div > div').last()
    await expect(said).not.toContainText('…')
    for (const control of await figure
      .locator('input:not([id$=time])[type=range], input[type=radio]:not(:checked)')
      .all()) {
      const before = await said.textContent()
      if ((await control.getAttribute('type')) === 'radio') await control.press('Space')
      else
        await control.press('ArrowLeft').then(async () => {
          if ((await said.textContent()) === before) await control.press('ArrowRight')
        })
      await expect(said).not.toHaveText(before!)
    }
  }
})

test('a box slides as far as its friction lets it', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/docs/how-it-works')
  const friction = page.getByRole('slider', { name: 'Friction' })
  const figure = page.locator('[data-slot=figure]', { has: friction })
  await friction.press('End')
  await figure.getByLabel('Time', { exact: true }).press('End')
  await expect(figure).toContainText(/Box: gone (\d+)\.\d+ px\s*of \1\./)
})

test('a figure plays at a press', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/docs/how-it-works')
  const figure = page.locator('[data-slot=figure]').first()
  await figure.getByRole('button', { name: 'Play' }).click()
  await expect(figure.getByLabel('Time', { exact: true })).not.toHaveValue('0')
})

test('with all asleep the islands figure asks for no frame', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/docs/how-it-works')
  const figure = page.locator('[data-slot=figure]').last()
  await figure.getByLabel('Time', { exact: true }).press('End')
  await expect(figure).toContainText('Awake 0 of 14')
  await expect(figure).toContainText('Frame callbacks none')
})

test('code has colours', async ({ page }) => {
  for (const [path, code] of [
    ['/docs/gravity-stack', '[role=tabpanel] pre'],
    ['/playground', '.code pre'],
  ]) {
    await page.goto(path)
    const pre = page.locator(code).filter({ hasText: 'export function' }).first()
    const colours = await pre.evaluate(
      (e) => new Set([...e.querySelectorAll('span')].map((s) => getComputedStyle(s).color)).size,
    )
    expect(colours, path).toBeGreaterThan(2)
  }
})

test('scroll bars have the colours of the page', async ({ page }) => {
  await page.emulateMedia({ colorScheme: 'dark' })
  await page.goto('/docs/setup')
  const bar = await page
    .locator('.code pre')
    .first()
    .evaluate((e) => getComputedStyle(e).scrollbarColor)
  expect(bar).toMatch(/^lab.* rgba\(0, 0, 0, 0\)$/)
})

test('on paper long lines of code are wrapped', async ({ page }) => {
  await page.goto('/docs/setup')
  await page.emulateMedia({ media: 'print' })
  await expect(page.locator('.code pre').first()).toHaveCSS('white-space', 'pre-wrap')
})

test('what a hard scene misses is said to be missed', async ({ page }) => {
  await page.goto('/docs/stability')
  const missed = json('stability.json').filter(
    ({ value, bound }: { value: number | null; bound: number }) => !(value !== null && value <= bound),
  ).length
  const table = page.getByRole('group', { name: 'Scenes that break solvers' })
  await expect(table.getByText('missed', { exact: true })).toHaveCount(missed)
})

test('a choice saved by another version of the site hides nothing', async ({ page }) => {
  await page.addInitScript(() => {
    localStorage.setItem('theme', 'sepia')
    localStorage.setItem('package-manager', 'cargo')
    localStorage.setItem('install', 'curl')
  })
  await page.goto('/docs/gravity-stack')
  await expect(page.getByText('npx shadcn@latest add').first()).toBeVisible()
  await expect(page.getByRole('tab', { name: 'npm' }).first()).toHaveAttribute('aria-selected', 'true')
})

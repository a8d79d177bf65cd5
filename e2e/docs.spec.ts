import { readFileSync } from 'node:fs'
import { gzipSync } from 'node:zlib'
import AxeBuilder from '@axe-core/playwright'
import { expect, type Page, type Response } from '@playwright/test'
import { addressed } from '../site.config.mjs'
import { docs, painted, test, withhold } from './page'

test('the props table says what range and default a number has, in the page and in Markdown', async ({
  page,
  request,
}) => {
  const gravityRange = '0 to 20,000, or x and y each −20,000 to 20,000'
  await page.goto('/docs/gravity-stack')
  const row = (name: string) =>
    page.getByRole('group', { name: 'Props' }).getByRole('row', { name: RegExp(`^${name}`) })
  for (const [name, range, value] of [
    ['gravity', `number | { x: number; y: number }, ${gravityRange}`, '2600'],
    ['bounce', 'number, 0 to 1', '0.18'],
    ['friction', 'number, 0 to 10', '0.4'],
    ['stagger', 'number, 0 to 60,000', '150'],
    ['interactive', 'boolean', 'true'],
  ]) {
    await expect(row(name)).toContainText(range)
    await expect(row(name).getByRole('cell').first()).toHaveText(value)
  }
  const markdown = await (await request.get('/docs/gravity-stack.md')).text()
  expect(markdown).toContain(`| \`gravity\` | \`number \\| { x: number; y: number }\`, ${gravityRange} |`)
  // The prompt for an assistant stands in it too.
  expect(markdown).toContain(`- gravity (number | { x: number; y: number }, ${gravityRange}, default 2600)`)
})

test('beside a page stand its headings, in their words', async ({ page }) => {
  await page.setViewportSize({ width: 1400, height: 800 })
  for (const path of docs) {
    await page.goto(path)
    const beside = page.getByRole('navigation', { name: 'On this page' }).getByRole('link')
    const headings = page.locator('#content :is(h2, h3)[id]')
    expect(await beside.allTextContents(), path).toEqual(
      (await headings.allTextContents()).map((words) => words.replace(/#$/, '')),
    )
  }
})

test('a heading is read without the mark behind it', async ({ page }) => {
  await page.goto('/docs/gravity-stack')
  await expect(page.getByRole('heading', { name: 'Installation', exact: true })).toBeVisible()
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

test('tabs are one stop for the keyboard; arrows, Home and End go from one to another and scroll nothing', async ({
  page,
}) => {
  await page.goto('/docs/gravity-stack')
  const preview = page.getByRole('tablist', { name: 'gravity-stack-demo' })
  await preview.getByRole('tab', { name: 'Preview' }).focus()
  await page.keyboard.press('ArrowRight')
  await expect(preview.getByRole('tab', { name: 'Code' })).toBeFocused()
  await expect(preview.getByRole('tab', { name: 'Code' })).toHaveAttribute('aria-selected', 'true')
  await expect(page.getByRole('tabpanel', { name: 'Code' }).first()).toContainText(
    'export function GravityStackDemo',
  )

  const managers = page
    .getByRole('tablist', { name: /^Package manager/ })
    .first()
    .getByRole('tab')
  expect(await managers.evaluateAll((all) => all.map((tab) => (tab as HTMLElement).tabIndex))).toEqual([
    0, -1, -1, -1,
  ])
  await managers.first().focus()
  const scrolled = () => page.evaluate(() => scrollY)
  const before = await scrolled()
  for (const [key, tab] of [
    ['End', 3],
    ['ArrowLeft', 2],
    ['Home', 0],
  ] as const) {
    await page.keyboard.press(key)
    await expect(managers.nth(tab)).toBeFocused()
    // A page that is told to scroll begins with the next frame.
    await painted(page)
    expect(await scrolled()).toBe(before)
  }
})

test.describe('with a clipboard', () => {
  test.use({ permissions: ['clipboard-read', 'clipboard-write'] })

  const clipboard = (page: Page) => page.evaluate(() => navigator.clipboard.readText())

  test('copies the command for the package manager that is shown', async ({ page }) => {
    await page.goto('/')
    // Until no chip may fall past under the pointer.
    await expect(page.locator('[data-slot=gravity-stack]')).toHaveAttribute('data-state', 'resting')
    await page.getByRole('tab', { name: 'bun' }).click()
    await page.getByRole('button', { name: 'Copy command' }).click()
    await expect(page.getByRole('button', { name: 'Copied' })).toBeVisible()
    expect(await clipboard(page)).toMatch(/^bunx --bun shadcn@latest add http\S+\/r\/gravity-stack\.json$/)
  })

  test('copies the component file, with the address of its docs on this site', async ({ page }) => {
    await page.goto('/docs/gravity-stack')
    await page.getByRole('tab', { name: 'Manual' }).click()
    await page.getByRole('button', { name: 'Copy the whole file' }).click()
    await expect(page.getByRole('button', { name: 'Copied' })).toBeVisible()
    // Compared as a whole: a difference would print the file twice.
    const file = addressed(readFileSync('components/ui/gravity-stack.tsx', 'utf8'))
    expect((await clipboard(page)) === file).toBe(true)
  })

  test('copies the tokens of the ladder as they are in the repository', async ({ page }) => {
    await page.goto('/docs/elevation')
    await page.getByRole('tab', { name: 'Manual' }).click()
    await page.locator('#install-manual').getByRole('button', { name: 'Copy code' }).click()
    await expect(page.getByRole('button', { name: 'Copied' })).toBeVisible()
    expect(await clipboard(page)).toBe(readFileSync('app/elevation.css', 'utf8').trimEnd())
  })

  test('copies the code that belongs to the pressed button', async ({ page }) => {
    await page.goto('/')
    await page.getByRole('button', { name: 'Bouncier' }).click()
    await page.getByRole('button', { name: 'Copy code' }).click()
    await expect(page.getByRole('button', { name: 'Copied' })).toBeVisible()
    expect(await clipboard(page)).toContain('bounce={0.7}')
  })

  test('copies a sample as it is written, its empty lines empty', async ({ page }) => {
    await page.goto('/docs/gravity-stack')
    await page.locator('figure.code').first().getByRole('button', { name: 'Copy code' }).click()
    await expect(page.getByRole('button', { name: 'Copied' })).toBeVisible()
    expect(await clipboard(page)).toContain("'@/components/ui/gravity-stack'\n\nexport function Topics() {\n")
  })

  test('copies a page as Markdown', async ({ page }) => {
    await page.goto('/docs/setup')
    await page.getByRole('button', { name: 'Copy page as Markdown' }).click()
    await expect(page.getByRole('button', { name: 'Copied' })).toHaveText('Copied')
    expect(await clipboard(page)).toMatch(/^# Setup\n/)
  })
})

test('the menu beside Copy page opens and closes by the keyboard, with or without script', async ({
  page,
  browser,
  baseURL,
}) => {
  const still = await browser.newContext({ baseURL, javaScriptEnabled: false })
  const plain = await still.newPage()
  await plain.goto('/docs/setup')
  await expect(plain.getByRole('link', { name: 'Open as Markdown' })).toBeVisible()
  await still.close()

  await page.setViewportSize({ width: 375, height: 700 })
  await page.goto('/docs/setup')
  const menu = page.getByRole('button', { name: 'More ways to take this page' })
  const first = page.getByRole('link', { name: 'Open as Markdown' })
  await menu.focus()
  await page.keyboard.press('Enter')
  await expect(first).toBeVisible()
  const { x, y, height } = (await first.boundingBox())!
  const button = (await menu.boundingBox())!
  expect(x).toBeGreaterThanOrEqual(0)
  expect(y).toBeGreaterThanOrEqual(button.y + button.height)
  expect(y + height).toBeLessThan(button.y + 120)
  await page.keyboard.press('Tab')
  await expect(first).toBeFocused()
  for (const name of ['Open in ChatGPT', 'Open in Claude']) {
    await page.keyboard.press('Tab')
    await expect(page.getByRole('link', { name })).toBeFocused()
  }
  const axe = new AxeBuilder({ page }).setLegacyMode().options({ resultTypes: ['violations'] })
  expect((await axe.analyze()).violations).toEqual([])
  await page.keyboard.press('Escape')
  await expect(first).toBeHidden()
  await expect(menu).toBeFocused()
})

test('a prompt for an assistant names the address, every prop, every action and the code of Usage', async ({
  page,
}) => {
  await page.goto('/docs/gravity-stack')
  const names = (group: string) =>
    page
      .getByRole('group', { name: group })
      .getByRole('rowheader')
      .evaluateAll((all) => all.map((cell) => cell.firstChild!.textContent!))
  await page.getByRole('tab', { name: 'Prompt' }).click()
  const prompt = (await page.locator('#install-prompt pre').textContent())!
  expect(prompt).toMatch(/npx shadcn@latest add http\S+\/r\/gravity-stack\.json/)
  expect(prompt).toContain('export function Topics()')
  for (const name of await names('Props')) expect(prompt).toContain(`- ${name} (`)
  for (const name of await names('Actions')) expect(prompt).toContain(`- ${name}`)
  // The choice is remembered, where another item has a prompt of its own.
  await page.goto('/docs/elevation')
  await expect(page.locator('#install-prompt pre')).toContainText('/r/elevation.json')
  await expect(page.getByRole('button', { name: 'Copy prompt' })).toBeVisible()
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

  await page.goto('/docs/setup')
  await page.route('**/docs/setup.md', (route) => route.fulfill({ status: 503, body: 'try again later' }))
  await page.getByRole('button', { name: 'Copy page as Markdown' }).click()
  await expect(page.getByRole('button', { name: 'Not copied' })).toBeVisible()
})

test('the whole source unfolds in the page', async ({ page }) => {
  await page.goto('/docs/gravity-stack')
  await page.getByRole('tab', { name: 'Manual' }).click()
  const manual = page.locator('#install-manual')
  await page.getByRole('button', { name: /Show all/ }).focus()
  const scrolled = await page.evaluate(() => scrollY)
  await page.keyboard.press('Enter')
  await expect(manual).toContainText('export interface GravityStackProps')
  await expect(page.getByRole('region', { name: 'components/ui/gravity-stack.tsx' })).toBeFocused()
  expect(await page.evaluate(() => scrollY)).toBe(scrolled)
  await expect(manual.getByRole('link', { name: 'Plain text' })).toBeVisible()
  // On paper there is nothing to scroll.
  const hidden = () =>
    manual
      .locator('pre')
      .last()
      .evaluate((pre) => pre.scrollHeight - pre.clientHeight)
  expect(await hidden()).toBeGreaterThan(1000)
  await page.emulateMedia({ media: 'print' })
  expect(await hidden()).toBe(0)
})

test('who has moved on while the whole source was on its way keeps the focus', async ({ page }) => {
  const letCome = await withhold(page, '**/gravity-stack.html.txt')
  await page.goto('/docs/gravity-stack')
  await page.getByRole('tab', { name: 'Manual' }).click()
  await page.getByRole('button', { name: /Show all/ }).click()
  const elsewhere = page.getByRole('link', { name: 'Plain text' })
  await elsewhere.focus()
  letCome()
  await expect(page.locator('#install-manual')).toContainText('export interface GravityStackProps')
  await expect(elsewhere).toBeFocused()
})

test('the whole source is asked for once, and again after it could not be fetched', async ({ page }) => {
  let asked = 0
  let answer = () => {}
  await page.route('**/gravity-stack.html.txt', async (route) => {
    asked++
    await new Promise<void>((resolve) => {
      answer = resolve
    })
    await (asked > 1 ? route.continue() : route.abort())
  })
  await page.goto('/docs/gravity-stack')
  await page.getByRole('tab', { name: 'Manual' }).click()
  await page.getByRole('button', { name: /Show all/ }).click()
  await page.getByRole('button', { name: 'Fetching…' }).click()
  await expect.poll(() => asked).toBe(1)
  answer()
  await expect(page.locator('#install-manual').getByRole('alert')).toContainText('could not be fetched')
  await page.getByRole('button', { name: /Show all/ }).click()
  await expect.poll(() => asked).toBe(2)
  answer()
  await expect(page.locator('#install-manual')).toContainText('export interface GravityStackProps')
  await expect(page.locator('#install-manual').getByRole('alert')).toHaveCount(0)
})

test('Drop again drops the chips of a preview again', async ({ page }) => {
  await page.goto('/docs/gravity-stack')
  const stage = page.locator('[data-slot=gravity-stack]').first()
  await expect(stage).toHaveAttribute('data-state', 'resting')
  await page.getByRole('button', { name: 'Drop again' }).first().click()
  await expect(stage).toHaveAttribute('data-state', 'running')
})

test('with reduced motion no preview offers to drop again', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/docs/gravity-stack')
  await expect(page.getByRole('tab', { name: 'Code' }).first()).toBeVisible()
  await expect(page.getByRole('button', { name: 'Drop again', includeHidden: true }).first()).toBeHidden()
})

test('a demo below the fold waits to be seen, then falls and comes to rest', async ({ page }) => {
  await page.setViewportSize({ width: 1280, height: 700 })
  await page.goto('/docs/gravity-stack')
  const stages = page.locator('[data-slot=gravity-stack]')
  await expect(stages.nth(0)).toHaveAttribute('data-state', 'resting')
  await expect(stages.nth(2)).toHaveAttribute('data-state', /static|waiting/)
  await stages.nth(2).scrollIntoViewIfNeeded()
  await expect(stages.nth(2)).toHaveAttribute('data-state', 'resting')
})

test('a demo whose script did not come is tried again when it is seen again', async ({ page }) => {
  await page.setViewportSize({ width: 1280, height: 700 })
  await page.goto('/docs/gravity-stack')
  const stages = page.locator('[data-slot=gravity-stack]')
  await expect(stages.nth(0)).toHaveAttribute('data-state', 'resting')
  let refused = 0
  await page.route('**/*.js', (route) => {
    refused++
    return route.abort()
  })
  await stages.nth(2).scrollIntoViewIfNeeded()
  await expect.poll(() => refused).toBeGreaterThan(0)
  await page.unroute('**/*.js')
  await page.evaluate(() => scrollTo(0, 0))
  await expect(stages.nth(0)).toBeInViewport()
  await stages.nth(2).scrollIntoViewIfNeeded()
  await expect(stages.nth(2)).toHaveAttribute('data-state', 'resting')
})

// The framework, React and the page's own take 136 of them.
test('the component page brings at most 165 kB of script', async ({ page }) => {
  // What the links of the page fetch in advance belongs to other pages.
  await page.route(/_rsc=/, (route) => route.abort())
  const scripts: Response[] = []
  page.on('response', (response) => {
    if (response.request().resourceType() === 'script') scripts.push(response)
  })
  await page.goto('/docs/gravity-stack', { waitUntil: 'networkidle' })
  await expect(page.locator('[data-slot=gravity-stack]').first()).toHaveAttribute(
    'data-state',
    /running|resting/,
  )
  const bodies = await Promise.all(scripts.map((response) => response.body()))
  const bytes = bodies.reduce((sum, body) => sum + gzipSync(body).length, 0)
  expect(bytes / 1000).toBeLessThanOrEqual(165)
})

test('what a hard scene misses is said to be missed', async ({ page }) => {
  await page.goto('/docs/stability')
  const missed = JSON.parse(readFileSync('bench/results/stability.json', 'utf8')).filter(
    ({ value, bound }: { value: number | null; bound: number }) => !(value !== null && value <= bound),
  ).length
  const table = page.getByRole('group', { name: 'Scenes that break solvers' })
  await expect(table.getByText('missed', { exact: true })).toHaveCount(missed)
})

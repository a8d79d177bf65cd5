import { readFileSync } from 'node:fs'
import AxeBuilder from '@axe-core/playwright'
import { expect, type Locator, type Page } from '@playwright/test'
import { docs, pages, test, watchShifts } from './page'

/** px that the page is wider than its window. */
const overflow = (page: Page) =>
  page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth)

const tab = (name: string) => (page: Page) => page.getByRole('tab', { name, exact: true }).first()
const button = (name: string) => (page: Page) => page.getByRole('button', { name, exact: true })
const link = (navigation: string, name: string) => (page: Page) =>
  page.getByRole('navigation', { name: navigation, exact: true }).getByRole('link', { name, exact: true })
const option = (words: string) => (page: Page) =>
  page
    .locator('label', { has: page.getByRole('radio') })
    .filter({ hasText: new RegExp(`^${words}`) })
    .first()

for (const path of pages) {
  test.describe(path, () => {
    test('loads with one title and no error, and nothing moves about meanwhile', async ({ page }) => {
      const shifted = await watchShifts(page)
      const errors: string[] = []
      page.on('pageerror', (error) => errors.push(error.message))
      page.on('console', (message) => {
        // A browser with a 404 page in its hands says so in the console.
        const expected = path === '/404' && message.text().includes('404')
        if (message.type() === 'error' && !expected) errors.push(message.text())
      })
      await page.goto(path)
      await expect(page.getByRole('heading', { level: 1 })).toHaveCount(1)
      await expect(page.locator('#content')).toBeVisible()
      await page.waitForLoadState('networkidle')
      expect(errors).toEqual([])
      expect(await shifted()).toBeLessThan(0.01)
    })

    test('fits a window of 320 px, and of 375', async ({ page }) => {
      for (const width of [320, 375]) {
        await page.setViewportSize({ width, height: 700 })
        if (width === 320) await page.goto(path)
        await page.waitForLoadState('networkidle')
        expect(await overflow(page), `${width} px`).toBe(0)
      }
    })

    test('has no accessibility violation in light and dark, nor with reduced motion', async ({ page }) => {
      await page.emulateMedia({ colorScheme: 'light', reducedMotion: 'no-preference' })
      await page.goto(path)
      await page.waitForLoadState('networkidle')
      for (const [colorScheme, reducedMotion] of [
        ['light', 'no-preference'],
        ['dark', 'no-preference'],
        ['dark', 'reduce'],
      ] as const) {
        await page.emulateMedia({ colorScheme, reducedMotion })
        await expect(page.locator('html')).toHaveClass(colorScheme === 'dark' ? /dark/ : /^((?!dark).)*$/)
        // A chip that falls past other words covers them for a moment, and a changing colour is neither of
        // the two.
        await expect(page.locator('[data-slot="gravity-stack"][data-state="running"]')).toHaveCount(0)
        await page.waitForFunction(
          () => !document.getAnimations().some((animation) => animation instanceof CSSTransition),
        )
        // What a frame holds has a test of its own. Only what is wrong is asked for: a third of the time.
        const axe = new AxeBuilder({ page })
          .setLegacyMode()
          .exclude('iframe')
          .options({ resultTypes: ['violations'] })
        expect((await axe.analyze()).violations, `${colorScheme}, ${reducedMotion}`).toEqual([])
      }
    })
  })
}

const tables = docs.filter((path) => /^\||Table \/>/m.test(readFileSync(`content${path}.mdx`, 'utf8')))

for (const path of tables) {
  test(`on a phone no table of ${path} is cut off, and each has a name of its own`, async ({ page }) => {
    await page.setViewportSize({ width: 320, height: 700 })
    await page.goto(path)
    const found = await page.locator('[role=group]:has(> table)').evaluateAll((all) =>
      all.map((table) => ({
        name: table.getAttribute('aria-label'),
        cut: table.scrollWidth - table.clientWidth,
        // Where it is wider after all, the keyboard can scroll it.
        tabIndex: (table as HTMLElement).tabIndex,
      })),
    )
    const names = found.map(({ name }) => name)
    expect(names).toEqual([...new Set(names)])
    expect(found).toEqual(found.map(({ name }) => ({ name, cut: 0, tabIndex: 0 })))
    expect(found.length).toBeGreaterThan(0)
  })
}

test('with text twice as large, a phone keeps the buttons of the header and of a command in reach', async ({
  page,
}) => {
  await page.setViewportSize({ width: 320, height: 700 })
  for (const path of ['/', '/docs/setup', '/playground']) {
    await page.goto(path)
    await page.addStyleTag({ content: 'html { font-size: 200% !important }' })
    const buttons = page
      .getByRole('banner')
      .getByRole('button')
      .or(page.getByRole('button', { name: 'Copy' }))
    expect(await buttons.count()).toBeGreaterThan(1)
    for (const button of await buttons.all()) {
      const { x, width } = (await button.boundingBox())!
      expect(x + width).toBeLessThanOrEqual(320)
    }
  }
})

test('with text twice as large, a phone breaks a heading that is longer than its line', async ({ page }) => {
  await page.setViewportSize({ width: 320, height: 700 })
  await page.goto('/docs/accessibility')
  await page.addStyleTag({ content: 'html { font-size: 200% !important }' })
  const heading = page.getByRole('heading', { level: 1 })
  expect(await heading.evaluate(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth)).toBe(0)
})

test('a slider says its value once, with its unit', async ({ page }) => {
  await page.goto('/playground')
  const slider = (name: string) => page.getByRole('slider', { name, exact: true })
  await expect(slider('gravity')).toHaveAttribute('aria-valuetext', /^2,600\spx\/s²$/)
  await expect(slider('bounce')).toHaveAttribute('aria-valuetext', '0.18')
  await page.goto('/docs/how-it-works')
  await expect(slider('Time').first()).toHaveAttribute('aria-valuetext', /^\d\.\d\d seconds$/)
  await expect(slider('Distance from the centre')).toHaveAttribute('aria-valuetext', /^70\spx$/)
})

test('the name in the header stays on one line, and the links beside it have room', async ({ page }) => {
  await page.goto('/docs/setup')
  for (const width of [320, 640, 767, 768, 1024]) {
    await page.setViewportSize({ width, height: 700 })
    const lines = page.locator('header').locator('a[href="/"], nav a:visible')
    for (const { height } of await lines.evaluateAll((all) =>
      all.map((link) => link.getBoundingClientRect()),
    ))
      expect(height, `${width} px`).toBeLessThan(40)
    const name = page.locator('header a[href="/"] span')
    expect(await name.evaluate((words) => words.scrollWidth - words.clientWidth), `${width} px`).toBe(0)
    expect(await overflow(page), `${width} px`).toBe(0)
  }
})

test('the header marks the page that one is on, and Docs on the other pages of the docs', async ({
  page,
}) => {
  const marked = page.getByRole('navigation', { name: 'Main' }).locator('[aria-current]')
  for (const [path, title, current] of [
    ['/docs/gravity-stack', 'Docs', 'page'],
    ['/docs/setup', 'Docs', 'true'],
    ['/docs/how-it-works', 'How it works', 'page'],
    ['/playground', 'Playground', 'page'],
    ['/benchmarks', 'Benchmarks', 'page'],
  ]) {
    await page.goto(path)
    await expect(marked, path).toHaveText([title])
    await expect(marked, path).toHaveAttribute('aria-current', current)
    await expect(marked, path).not.toHaveCSS('background-color', 'rgba(0, 0, 0, 0)')
  }
  await page.goto('/')
  await expect(marked).toHaveCount(0)
})

test('on a narrow screen the menu opens, closes with Escape, and leads somewhere', async ({ page }) => {
  await page.setViewportSize({ width: 375, height: 700 })
  await page.goto('/docs/setup')
  const menu = page.getByRole('dialog', { name: 'Menu' })
  await page.getByRole('button', { name: 'Menu' }).click()
  await expect(menu).toBeVisible()
  await page.keyboard.press('Escape')
  await expect(menu).toBeHidden()
  await expect(page.getByRole('button', { name: 'Menu' })).toBeFocused()
  await page.getByRole('button', { name: 'Menu' }).click()
  await menu.getByRole('link', { name: 'Elevation' }).click()
  await expect(page.getByRole('heading', { level: 1, name: 'Elevation' })).toBeVisible()
})

test('the menu marks the page, and closes by its button, by a press beside it and by a link', async ({
  page,
}) => {
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
  // Who comes back to a page that was kept as it was left finds it without the menu.
  await page.evaluate(() => addEventListener('click', (event) => event.preventDefault()))
  await open.click()
  await menu.getByRole('link', { name: 'Elevation' }).click()
  await expect(menu).toBeHidden()
})

test('the first Tab offers to skip to the content', async ({ page }) => {
  await page.goto('/docs/setup')
  await page.keyboard.press('Tab')
  await expect(page.getByRole('link', { name: 'Skip to content' })).toBeFocused()
  await expect(page.getByRole('link', { name: 'Skip to content' })).toBeInViewport()
})

test.describe('in forced colours', () => {
  const chosen: [
    path: string,
    what: string,
    chosen: (page: Page) => Locator,
    other: (page: Page) => Locator,
  ][] = [
    ['/', 'package manager', tab('npm'), tab('pnpm')],
    ['/', 'look of the chips', button('Tinted'), button('Neutral')],
    ['/docs/gravity-stack', 'way to install', tab('CLI'), tab('Manual')],
    ['/docs/setup', 'page of the docs', link('Docs', 'Setup'), link('Docs', 'Caveats')],
    ['/playground', 'page in the header', link('Main', 'Playground'), link('Main', 'Benchmarks')],
    ['/playground', 'speed', button('Speed 1×'), button('Speed 1/4×')],
    ['/benchmarks', 'engine', option('All'), option('Planck')],
    ['/docs/how-it-works', 'number of sub-steps', option('6'), option('1')],
  ]
  for (const [path, what, one, other] of chosen) {
    test(`the chosen ${what} can be told from the others`, async ({ page }) => {
      await page.emulateMedia({ forcedColors: 'active' })
      await page.goto(path)
      // Of the words, which change with their background: that says transparent where it looks the same.
      const colour = (of: Locator) => of.evaluate((element) => getComputedStyle(element).color)
      await expect.poll(async () => (await colour(one(page))) === (await colour(other(page)))).toBe(false)
    })
  }
})

test('in forced colours a link that is a button by its ground alone has a border', async ({ page }) => {
  await page.emulateMedia({ forcedColors: 'active' })
  await page.goto('/')
  await expect(page.getByRole('link', { name: 'Read the docs' })).toHaveCSS('border-width', '1px')
})

test('back and forward go from anchor to anchor and from page to page', async ({ page }) => {
  const errors: string[] = []
  page.on('pageerror', (error) => errors.push(error.message))
  await page.goto('/docs/setup')
  const contents = page.getByRole('navigation', { name: 'On this page' })
  await contents.getByRole('link', { name: 'Dark mode' }).click()
  await contents.getByRole('link', { name: 'Tokens' }).click()
  await page.goBack()
  await expect(page).toHaveURL(/setup#dark-mode$/)
  await expect(page.getByRole('heading', { name: 'Dark mode' })).toBeInViewport()
  await page.getByRole('navigation', { name: 'Docs' }).getByRole('link', { name: 'Caveats' }).click()
  await expect(page.getByRole('heading', { level: 1, name: 'Caveats' })).toBeVisible()
  await page.goBack()
  await expect(page.getByRole('heading', { level: 1, name: 'Setup' })).toBeVisible()
  await expect(page).toHaveURL(/setup#dark-mode$/)
  await page.goForward()
  await expect(page.getByRole('heading', { level: 1, name: 'Caveats' })).toBeVisible()
  expect(errors).toEqual([])
})

for (const [reducedMotion, fades] of [
  ['no-preference', true],
  ['reduce', false],
] as const) {
  test(`from page to page ${fades ? 'one fades into the other' : 'nothing fades where motion is reduced'}`, async ({
    page,
  }) => {
    await page.emulateMedia({ reducedMotion })
    await page.addInitScript(() => {
      addEventListener('pagereveal', ({ viewTransition }) => {
        document.documentElement.dataset.faded = `${!!viewTransition}`
      })
    })
    await page.goto('/docs')
    await link('Docs', 'Caveats')(page).click()
    await page.waitForURL('**/docs/caveats')
    await expect(page.locator('html')).toHaveAttribute('data-faded', `${fades}`)
  })
}

test('chips and the ladder keep their colours on paper', async ({ page }) => {
  const surfaces = { '/': '[data-slot=gravity-stack-chip] > *', '/docs/elevation': '.dark li' }
  for (const [path, surface] of Object.entries(surfaces)) {
    await page.goto(path)
    await page.emulateMedia({ media: 'print' })
    await expect(page.locator(surface).first()).toHaveCSS('print-color-adjust', 'exact')
  }
})

test('the keyboard is seen wherever it goes', async ({ page }) => {
  for (const path of ['/', '/docs/gravity-stack', '/playground', '/benchmarks']) {
    await page.goto(path)
    for (let presses = 0; presses < 25; presses++) {
      await page.keyboard.press('Tab')
      const focused = await page.evaluate(() => {
        const element = document.activeElement!
        // Of a choice with a hidden circle the whole is outlined.
        const outlines = [element, element.closest('label') ?? element].map((shown) => {
          const { outlineStyle, outlineWidth } = getComputedStyle(shown)
          return `${outlineStyle} ${outlineWidth}`
        })
        return { outlines, html: element.outerHTML.slice(0, 80) }
      })
      // In a frame the keyboard is on something of the frame's own page.
      if (focused.html.startsWith('<iframe')) continue
      expect(focused.outlines, `${path}: ${focused.html}`).toContain('solid 2px')
    }
  }
})

test('on paper no table is cut off', async ({ page }) => {
  await page.emulateMedia({ media: 'print' })
  await page.setViewportSize({ width: 700, height: 900 })
  for (const path of ['/benchmarks', '/docs/stability']) {
    await page.goto(path)
    const boxes = page.locator(':is([role=group], [role=region]):has(> table)')
    expect(await boxes.count()).toBeGreaterThan(2)
    for (const box of await boxes.all()) await expect(box).toHaveCSS('overflow-x', 'visible')
  }
})

test('on paper long lines of code are wrapped', async ({ page }) => {
  await page.goto('/docs/setup')
  await page.emulateMedia({ media: 'print' })
  await expect(page.locator('.code pre').first()).toHaveCSS('white-space', 'pre-wrap')
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

test('each button has the words that it shows in its name', async ({ page }) => {
  for (const path of pages) {
    await page.goto(path)
    const others = await page.locator('button[aria-label]').evaluateAll((buttons) =>
      buttons
        .map((button) => ({
          name: button.getAttribute('aria-label')!.toLowerCase(),
          words: button.textContent!.toLowerCase(),
        }))
        .filter(({ name, words }) => !name.includes(words.trim())),
    )
    expect(others, path).toEqual([])
  }
})

test.describe('without script', () => {
  test.use({ javaScriptEnabled: false })

  test('words, commands, code and chips can all be read', async ({ page }) => {
    await page.goto('/docs/gravity-stack')
    await expect(page.getByText('npx shadcn@latest add').first()).toBeVisible()
    await expect(page.getByText('Prototype', { exact: true })).toBeVisible()
    // of a demo below the fold
    await expect(page.getByText('Limestone', { exact: true })).toBeVisible()
    // What tabs hide otherwise, and what would do nothing.
    for (const command of [/^npx shadcn@latest add/, /^pnpm dlx shadcn@latest add/, /^npm install motion cn/])
      await expect(page.getByText(command).first()).toBeVisible()
    const code = page.getByRole('tabpanel').filter({ hasText: 'export function GravityStackDemo' }).first()
    expect((await code.boundingBox())!.height).toBeGreaterThan(200)
    await expect(page.locator('button:visible')).toHaveCount(0)
    await page.goto('/')
    await expect(page.getByText('no physics library')).toBeVisible()
  })

  for (const [path, words, count] of [
    ['/playground', /^The playground runs in your browser/, 1],
    ['/docs/how-it-works', /^This figure is computed in your browser/, 7],
    ['/docs/stability', /^This figure is computed in your browser/, 2],
  ] as const) {
    test(`${path} says what needs a script`, async ({ page }) => {
      await page.goto(path)
      const said = page.locator('noscript p')
      await expect(said).toHaveText(Array(count).fill(words))
      await expect(said.first()).toBeVisible()
    })
  }
})

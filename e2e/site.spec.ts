import { readdirSync, readFileSync } from 'node:fs'
import { gzipSync } from 'node:zlib'
import AxeBuilder from '@axe-core/playwright'
import { expect, type Locator, type Page, type Response } from '@playwright/test'
import { TOUCH_HOLD } from '../registry/gravity-stack/constants'
import { alive, test, withhold } from './alive'

const docs = readdirSync('content/docs').map((file) => `/docs/${file.replace('.mdx', '')}`)
const pages = ['/', '/docs', '/playground', '/benchmarks', ...docs, '/404']

/** px that the page is wider than its window. */
const overflow = (page: Page) =>
  page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth)

/** Call before a page loads: how far what it shows has moved about since then, by the browser's own measure. */
async function watchShifts(page: Page) {
  await page.addInitScript(() => {
    let shifted = 0
    const add = (entries: PerformanceEntryList) => {
      for (const entry of entries) shifted += (entry as PerformanceEntry & { value: number }).value
    }
    const observer = new PerformanceObserver((list) => add(list.getEntries()))
    observer.observe({ type: 'layout-shift', buffered: true })
    Object.assign(window, {
      shifted() {
        add(observer.takeRecords())
        return shifted
      },
    })
  })
  return () => page.evaluate<number>('shifted()')
}

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
        // A chip that falls past other words covers them for a moment, and a colour on its way is neither one's.
        await expect(page.locator('[data-slot="gravity-stack"][data-state="running"]')).toHaveCount(0)
        await page.waitForFunction(
          () => !document.getAnimations().some((animation) => animation instanceof CSSTransition),
        )
        // No page has frames, and only what is wrong is asked for: a third of the time.
        const axe = new AxeBuilder({ page }).setLegacyMode().options({ resultTypes: ['violations'] })
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
      })),
    )
    const names = found.map(({ name }) => name)
    expect(names).toEqual([...new Set(names)])
    expect(found).toEqual(found.map(({ name }) => ({ name, cut: 0 })))
    expect(found.length).toBeGreaterThan(0)
  })
}

test('the props table says what range a number has, in the page and in Markdown', async ({
  page,
  request,
}) => {
  await page.goto('/docs/gravity-stack')
  const row = (name: string) =>
    page.getByRole('group', { name: 'Props' }).getByRole('row', { name: RegExp(`^${name}`) })
  await expect(row('gravity')).toContainText('number, 0 to 20,000')
  await expect(row('bounce')).toContainText('number, 0 to 1')
  await expect(row('friction')).toContainText('number, 0 to 10')
  await expect(row('stagger')).toContainText('number, 0 to 60,000')
  const markdown = await (await request.get('/docs/gravity-stack.md')).text()
  expect(markdown).toContain('| `gravity` | `number`, 0 to 20,000 |')
})

for (const path of pages.filter((path) => path !== '/404')) {
  const twin = path === '/' ? '/index.md' : `${path}.md`
  test(`${twin} is the page in Markdown, with no tag left and no dead link`, async ({ page, request }) => {
    await page.goto(path)
    const answer = await request.get(twin)
    expect(answer.headers()['content-type']).toBe('text/markdown;charset=utf-8')
    const markdown = await answer.text()
    expect(markdown).toContain(`# ${await page.getByRole('heading', { level: 1 }).textContent()}\n`)
    expect(markdown.replace(/^```[\s\S]*?^```/gm, '')).not.toMatch(/^<\/?[A-Z]/m)
    for (const [, to] of markdown.matchAll(/\]\(http:\/\/localhost:\d+([^)#]*)/g)) {
      expect((await request.get(to)).ok(), to).toBe(true)
    }
    await expect(page.getByRole('link', { name: 'Markdown' })).toHaveAttribute('href', twin)
  })
}

test('every link and anchor of the site leads somewhere', async ({ request }) => {
  const html = new Map<string, string>()
  for (const path of pages) html.set(path, await (await request.get(path)).text())
  const dead: string[] = []
  for (const [path, text] of html) {
    for (const [, href] of text.matchAll(/<a\s[^>]*?href="([^"]*)"/g)) {
      if (/^(https?|mailto):/.test(href)) continue
      const [target, anchor] = href.replaceAll('&amp;', '&').split('#')
      const to = target.split('?')[0] || path
      if (!html.has(to)) {
        const answer = await request.get(to)
        html.set(to, answer.ok() ? await answer.text() : '')
      }
      const found = html.get(to)
      if (!found || (anchor && !found.includes(` id="${anchor}"`))) dead.push(`${path} → ${href}`)
    }
  }
  expect(dead).toEqual([])
})

// There may be no network where this runs: an address comes into this list when somebody has looked at it.
const elsewhere = [
  'https://developer.mozilla.org/docs/Web/API/Pointer_events',
  'https://developer.mozilla.org/docs/Web/API/ResizeObserver',
  'https://developer.mozilla.org/docs/Web/CSS/Guides/Containment',
  'https://developer.mozilla.org/docs/Web/CSS/Guides/Flexible_box_layout',
  'https://developer.mozilla.org/docs/Web/CSS/Guides/Media_queries/Printing',
  'https://developer.mozilla.org/docs/Web/CSS/Reference/At-rules/@media/prefers-reduced-motion',
  'https://developer.mozilla.org/docs/Web/CSS/Reference/Properties/scroll-margin',
]

test('links to other sites are those that somebody has looked at', async ({ request, baseURL }) => {
  const found = new Set<string>()
  for (const path of pages) {
    const text = await (await request.get(path)).text()
    for (const [, href] of text.matchAll(/<a\s[^>]*?href="(\w+:[^"]*)"/g)) {
      if (!href.startsWith(baseURL!)) found.add(href)
    }
  }
  const edits = process.env.REPOSITORY_URL || 'no repository is named'
  expect([...found].filter((href) => !href.startsWith(edits)).sort()).toEqual(elsewhere)
})

for (const size of [
  { width: 1280, height: 720 },
  { width: 375, height: 667 },
]) {
  test(`at ${size.width} px the first screen says what it is, what it costs and how to add it`, async ({
    page,
  }) => {
    await page.setViewportSize(size)
    await page.goto('/')
    const words = [
      'A React component whose children drop in',
      /^\d+\.\d kB not counting React and cn$/,
      /^\d+ µs of physics a frame, 60 chips$/,
      /^0 frames at rest$/,
    ]
    for (const word of words) await expect(page.getByText(word)).toBeInViewport({ ratio: 1 })
    // The command is longer than a narrow screen, and scrolls.
    await expect(page.getByText('npx shadcn@latest add')).toBeInViewport()
    await expect(page.getByRole('button', { name: 'Copy command' })).toBeInViewport({ ratio: 1 })
  })
}

for (const [width, height] of [
  [640, 900],
  [768, 1024],
  [820, 1180],
  [1024, 768],
  [1280, 720],
  [1440, 900],
]) {
  test(`at ${width} × ${height} the pile at rest covers neither the command nor the button under it`, async ({
    page,
  }) => {
    await page.setViewportSize({ width, height })
    await page.goto('/')
    await expect(page.locator('[data-slot=gravity-stack]')).toHaveAttribute('data-state', 'resting')
    const free = [
      page.locator('section .code', { has: page.getByText('npx shadcn') }),
      page.getByRole('link', { name: 'Read the docs' }),
    ]
    for (const words of free) {
      const covers = await words.evaluate((element) => {
        const { left, right, top, bottom } = element.getBoundingClientRect()
        const found = new Set<string>()
        for (let x = left + 4; x < right; x += 8) {
          for (let y = top + 4; y < bottom; y += 8) {
            const chip = document.elementFromPoint(x, y)?.closest('[data-slot=gravity-stack-chip]')
            if (chip) found.add(chip.textContent!)
          }
        }
        return [...found]
      })
      expect(covers).toEqual([])
    }
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

test('a slider says its value once, with its unit', async ({ page }) => {
  await page.goto('/playground')
  const slider = (name: string) => page.getByRole('slider', { name, exact: true })
  await expect(slider('gravity')).toHaveAttribute('aria-valuetext', /^2,600\spx\/s²$/)
  await expect(slider('bounce')).toHaveAttribute('aria-valuetext', '0.18')
  await page.goto('/docs/how-it-works')
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

test('the theme is there before the first paint, and a press on the switch is remembered', async ({
  page,
}) => {
  // What the root looked like when <body> came into being: nothing can have been painted before.
  await page.addInitScript(() => {
    new MutationObserver((_, observer) => {
      if (!document.body) return
      Object.assign(window, { first: document.documentElement.classList.contains('dark') })
      observer.disconnect()
    }).observe(document, { childList: true, subtree: true })
  })
  const first = () => page.evaluate(() => (window as unknown as { first: boolean }).first)

  await page.emulateMedia({ colorScheme: 'dark' })
  await page.goto('/')
  expect(await first()).toBe(true)

  await page.getByRole('button', { name: 'Switch between light and dark' }).click()
  await expect(page.locator('html')).not.toHaveClass(/dark/)
  await page.goto('/docs/setup')
  expect(await first()).toBe(false)
})

test('a phone’s bar has the colour of the theme, also once the switch was pressed', async ({ page }) => {
  const bar = () =>
    page.evaluate(
      () =>
        [...document.querySelectorAll<HTMLMetaElement>('meta[name=theme-color]')].find(
          ({ media }) => !media || matchMedia(media).matches,
        )?.content,
    )
  await page.emulateMedia({ colorScheme: 'light' })
  await page.goto('/docs/setup')
  expect(await bar()).toBe('#fcfbf9')
  await page.getByRole('button', { name: 'Switch between light and dark' }).click()
  await expect.poll(bar).toBe('#0f0e0d')
  await page.reload()
  expect(await bar()).toBe('#0f0e0d')
})

test('the theme follows the system while nobody has pressed the switch', async ({ page }) => {
  await page.emulateMedia({ colorScheme: 'light' })
  await page.goto('/docs/setup', { waitUntil: 'networkidle' })
  await page.emulateMedia({ colorScheme: 'dark' })
  await expect(page.locator('html')).toHaveClass(/dark/)
})

test('a change of the system while the page loads is not missed', async ({ page }) => {
  await page.emulateMedia({ colorScheme: 'light' })
  const letCome = await withhold(page, '**/*.js')
  const loaded = page.goto('/docs/setup')
  await expect(page.getByRole('heading', { level: 1, name: 'Setup' })).toBeVisible()
  await expect(page.locator('html')).not.toHaveClass(/dark/)
  await page.emulateMedia({ colorScheme: 'dark' })
  letCome()
  await loaded
  await expect(page.locator('html')).toHaveClass(/dark/)
})

test('a dark page is printed light, and is dark again afterwards', async ({ page }) => {
  await page.emulateMedia({ colorScheme: 'dark' })
  await page.goto('/docs/setup', { waitUntil: 'networkidle' })
  await page.emulateMedia({ media: 'print' })
  await expect(page.locator('html')).not.toHaveClass(/dark/)
  await expect(page.getByRole('navigation', { name: 'Docs' })).toBeHidden()
  await page.emulateMedia({ media: 'screen' })
  await expect(page.locator('html')).toHaveClass(/dark/)
})

test('chips and the ladder keep their colours on paper', async ({ page }) => {
  const surfaces = { '/': '[data-slot=gravity-stack-chip] > *', '/docs/elevation': '.dark li' }
  for (const [path, surface] of Object.entries(surfaces)) {
    await page.goto(path)
    await page.emulateMedia({ media: 'print' })
    await expect(page.locator(surface).first()).toHaveCSS('print-color-adjust', 'exact')
  }
})

test('the playground is printed as its code', async ({ page }) => {
  await page.goto('/playground')
  await page.emulateMedia({ media: 'print' })
  await expect(page.locator('[data-slot=playground-stage]')).toBeHidden()
  await expect(page.getByRole('form', { name: 'Settings' })).toBeHidden()
  await expect(page.getByText('export function Pile()')).toBeVisible()
})

test('the package manager and the way to install are remembered on every page', async ({ page }) => {
  await page.goto('/docs/gravity-stack')
  await page.getByRole('tab', { name: 'Manual' }).click()
  await page.locator('#install-manual').getByRole('tab', { name: 'pnpm' }).click()
  await expect(page.getByText('pnpm add motion')).toBeVisible()

  await page.goto('/')
  await expect(page.getByText('pnpm dlx shadcn@latest add')).toBeVisible()
  await expect(page.getByText('npx shadcn@latest add')).toBeHidden()
  await page.goto('/docs/gravity-stack')
  await expect(page.locator('#install-manual')).toBeVisible()
  await expect(page.locator('#install-cli')).toBeHidden()
})

test('what another tab saves is applied here too, and what was saved while this page was away', async ({
  page,
  context,
}) => {
  await page.emulateMedia({ colorScheme: 'light' })
  await page.goto('/')
  const other = await context.newPage()
  await other.emulateMedia({ colorScheme: 'light' })
  await other.goto('/docs/setup')
  await alive(other)
  await other.getByRole('button', { name: 'Switch between light and dark' }).click()
  await expect(page.locator('html')).toHaveClass(/dark/)
  await other.getByRole('tab', { name: 'yarn' }).first().click()
  await expect(page.getByText('yarn dlx shadcn@latest add')).toBeVisible()
  await expect(page.getByRole('tab', { name: 'yarn' })).toHaveAttribute('aria-selected', 'true')

  // The browser of the tests keeps no page to go back to.
  await page.evaluate(() => {
    localStorage.setItem('theme', 'light')
    localStorage.setItem('package-manager', 'bun')
    window.dispatchEvent(new PageTransitionEvent('pageshow', { persisted: true }))
  })
  await expect(page.locator('html')).not.toHaveClass(/dark/)
  await expect(page.getByText('bunx --bun shadcn@latest add')).toBeVisible()
  await expect(page.getByRole('tab', { name: 'bun' })).toHaveAttribute('aria-selected', 'true')
})

test('tabs are one stop for the keyboard, and arrows move between them', async ({ page }) => {
  await page.goto('/docs/gravity-stack')
  const preview = page.getByRole('tablist', { name: 'gravity-stack-demo' })
  await preview.getByRole('tab', { name: 'Preview' }).focus()
  await page.keyboard.press('ArrowRight')
  await expect(preview.getByRole('tab', { name: 'Code' })).toBeFocused()
  await expect(preview.getByRole('tab', { name: 'Code' })).toHaveAttribute('aria-selected', 'true')
  await expect(page.getByRole('tabpanel', { name: 'Code' }).first()).toContainText(
    'export function GravityStackDemo',
  )
})

test.describe('with a clipboard', () => {
  test.use({ permissions: ['clipboard-read', 'clipboard-write'] })

  const clipboard = (page: Page) => page.evaluate(() => navigator.clipboard.readText())

  test('copies the command for the package manager that is shown', async ({ page }) => {
    await page.goto('/')
    await page.getByRole('tab', { name: 'bun' }).click()
    await page.getByRole('button', { name: 'Copy command' }).click()
    await expect(page.getByRole('button', { name: 'Copied' })).toBeVisible()
    expect(await clipboard(page)).toMatch(/^bunx --bun shadcn@latest add http\S+\/r\/gravity-stack\.json$/)
  })

  test('copies the component file as it is in the repository', async ({ page }) => {
    await page.goto('/docs/gravity-stack')
    await page.getByRole('tab', { name: 'Manual' }).click()
    await page.getByRole('button', { name: 'Copy the whole file' }).click()
    await expect(page.getByRole('button', { name: 'Copied' })).toBeVisible()
    // Compared as a whole: a difference would print the file twice.
    expect((await clipboard(page)) === readFileSync('components/ui/gravity-stack.tsx', 'utf8')).toBe(true)
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
    await expect(page.getByRole('button', { name: 'Copied' })).toBeVisible()
    expect(await clipboard(page)).toMatch(/^# Setup\n/)
  })
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

test('the home page performs what its buttons say and shows the code for it', async ({ page }) => {
  await page.goto('/')
  const stage = page.locator('[data-slot=gravity-stack]')
  const colour = () =>
    page.getByText('grab me', { exact: true }).evaluate((chip) => getComputedStyle(chip).backgroundColor)
  await expect(stage).toHaveAttribute('data-state', 'resting')
  const tinted = await colour()
  await page.getByRole('button', { name: 'Neutral' }).click()
  await expect(page.getByText('bg-elevation-3')).toBeVisible()
  await expect.poll(colour).not.toBe(tinted)
  await page.getByRole('button', { name: 'Tinted' }).click()
  await expect(page.getByText('bg-amber-300')).toBeVisible()
  await expect.poll(colour).toBe(tinted)
  const moves = {
    'Drop again': 'actions.current?.drop()',
    Shake: 'actions.current?.shake()',
    Heavier: 'gravity={6000}',
    Bouncier: 'bounce={0.7}',
  }
  for (const [name, code] of Object.entries(moves)) {
    await expect(stage).toHaveAttribute('data-state', 'resting')
    await page.getByRole('button', { name }).click()
    await expect(stage).toHaveAttribute('data-state', 'running')
    await expect(page.getByText(code)).toBeVisible()
  }
  // The code is of all that is set, not of the last press alone.
  for (const code of ['bg-amber-300', 'gravity={6000} bounce={0.7}', 'import { useRef }'])
    await expect(page.getByText(code)).toBeVisible()
})

test('on the home page an action is not left pressed, and leaves what was set as it is', async ({ page }) => {
  await page.goto('/')
  const stage = page.locator('[data-slot=gravity-stack]')
  const pressed = page.locator('button[aria-pressed=true]')
  await expect(stage).toHaveAttribute('data-state', 'resting')
  await expect(pressed).toHaveText(['Tinted'])
  await page.getByRole('button', { name: 'Heavier' }).click()
  await page.getByRole('button', { name: 'Neutral' }).click()
  for (const name of ['Drop again', 'Shake']) {
    await page.getByRole('button', { name }).click()
    await expect(pressed).toHaveText(['Neutral', 'Heavier'])
    await expect(stage).toHaveAttribute('data-state', 'resting')
  }
  await page.getByRole('button', { name: 'Heavier' }).click()
  await expect(stage).toHaveAttribute('data-state', 'running')
  await expect(pressed).toHaveText(['Neutral'])
  await expect(page.getByText('gravity={6000}')).toHaveCount(0)
})

test('the drop on the home page can be paused, and goes on with whatever is pressed next', async ({
  page,
}) => {
  await page.goto('/')
  const stage = page.locator('[data-slot=gravity-stack]')
  const pause = page.getByRole('button', { name: 'Pause' })
  for (const next of ['Resume', 'Shake', 'Drop again', 'Heavier']) {
    await expect(stage).toHaveAttribute('data-state', 'resting')
    await page.getByRole('button', { name: 'Drop again' }).click()
    await expect(stage).toHaveAttribute('data-state', 'running')
    await pause.click()
    await expect(stage).toHaveAttribute('data-state', 'paused')
    await expect(page.getByText('actions.current?.pause()')).toBeVisible()
    await page.getByRole('button', { name: next }).click()
    await expect(stage).toHaveAttribute('data-state', 'running')
    await expect(pause).toBeVisible()
  }
})

test('with reduced motion no preview offers to drop again', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/docs/gravity-stack')
  await expect(page.getByRole('tab', { name: 'Code' }).first()).toBeVisible()
  await expect(page.getByRole('button', { name: 'Drop again', includeHidden: true }).first()).toBeHidden()
})

test('the tints of the home page are those in its code', async ({ page }) => {
  await page.goto('/')
  await page.getByRole('button', { name: 'Tinted' }).click()
  const code = await page.locator('pre', { hasText: 'const tints' }).textContent()
  const chips = page.locator('[data-slot=gravity-stack-chip] > span')
  for (const [index, name] of [...code!.matchAll(/'(bg-[\w-]+)'/g)].map(([, name]) => name).entries())
    await expect(chips.nth(index)).toContainClass(name)
})

test('words can be read before any script is asked for', async ({ page }) => {
  for (const path of pages) {
    await page.goto(path)
    const early = await page.evaluate(() => {
      const [painted] = performance.getEntriesByName('first-contentful-paint')
      const requests = performance.getEntriesByType('resource')
      return requests
        .filter(({ name, startTime }) => name.endsWith('.js') && startTime < painted.startTime)
        .map(({ name }) => name)
    })
    expect(early, path).toEqual([])
  }
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

test('on a narrow screen the menu opens, closes with Escape, and closes when it has led somewhere', async ({
  page,
}) => {
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
  await expect(menu).toBeHidden()
})

test('the first Tab offers to skip to the content', async ({ page }) => {
  await page.goto('/docs/setup')
  await page.keyboard.press('Tab')
  await expect(page.getByRole('link', { name: 'Skip to content' })).toBeFocused()
  await expect(page.getByRole('link', { name: 'Skip to content' })).toBeInViewport()
})

test('llms.txt and the sitemap list every page, and llms-full.txt holds the source', async ({ request }) => {
  const index = await (await request.get('/llms.txt')).text()
  const map = await (await request.get('/sitemap.xml')).text()
  for (const path of ['/playground', '/benchmarks', ...docs]) {
    expect(index).toContain(`${path}.md)`)
    expect(map).toContain(`${path}</loc>`)
  }
  for (const [, to] of index.matchAll(/\]\(http:\/\/localhost:\d+([^)]*)/g)) {
    expect((await request.get(to)).ok(), to).toBe(true)
  }
  const full = await (await request.get('/llms-full.txt')).text()
  expect(full.includes(readFileSync('components/ui/gravity-stack.tsx', 'utf8').trim())).toBe(true)
})

test('every page has words of its own and a picture for those who share it', async ({ page, request }) => {
  const seen = new Set<string>()
  for (const path of pages.filter((path) => path !== '/404')) {
    await page.goto(path)
    const meta = (name: string) => page.locator(`meta[property="${name}"]`).getAttribute('content')
    seen.add(`${await page.title()} ${await page.locator('meta[name=description]').getAttribute('content')}`)
    const picture = new URL((await meta('og:image')) ?? '')
    expect((await request.get(picture.pathname)).headers()['content-type']).toBe('image/png')
  }
  expect(seen.size).toBe(pages.length - 1)
})

test('an address that leads nowhere gets the page whose words fall', async ({ page }) => {
  const answer = await page.goto('/nowhere/at/all')
  expect(answer?.status()).toBe(404)
  await expect(page.getByRole('heading', { name: 'Page not found' })).toBeVisible()
  await expect(page.locator('[data-slot=gravity-stack]')).toHaveAttribute('data-state', 'resting')
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
    ['/docs/how-it-works', /^This figure is computed in your browser/, 6],
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

test.describe('playground', () => {
  const stage = '[data-slot=playground-stage]'

  test('drops its chips, and all of them lie inside and still', async ({ page }) => {
    await page.goto('/playground')
    await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
    // How far each hull reaches past wall or floor, px: a rotated element's own box has corners that a pill has not.
    const outside = await page.locator(stage).evaluate((element) =>
      [...element.querySelectorAll<HTMLElement>('[data-chip]')].map((chip) => {
        const { a, b, e, f } = new DOMMatrix(getComputedStyle(chip).transform)
        const [w, h] = [chip.offsetWidth / 2, chip.offsetHeight / 2]
        const radius = Number.parseFloat(getComputedStyle(chip.firstElementChild!).borderTopLeftRadius)
        const r = Math.min(radius, w, h)
        const reachX = Math.abs(a) * (w - r) + Math.abs(b) * (h - r) + r
        const reachY = Math.abs(b) * (w - r) + Math.abs(a) * (h - r) + r
        return Math.max(
          reachX - (e + w),
          e + w + reachX - element.clientWidth,
          f + h + reachY - element.clientHeight,
        )
      }),
    )
    expect(Math.max(...outside)).toBeLessThan(1)
  })

  test('the address holds the settings, and Reset clears it', async ({ page }) => {
    await page.goto('/playground')
    await page.getByLabel('Shape').selectOption('mixed')
    await page.getByLabel('gravity').focus()
    await page.keyboard.press('ArrowRight')
    await expect(page).toHaveURL(/\?shape=mixed&gravity=2700$/)
    await page.reload()
    await expect(page.getByLabel('Shape')).toHaveValue('mixed')
    await expect(page.getByText('<GravityStack gravity={2700} className="h-96">')).toBeVisible()
    await page.getByRole('button', { name: 'Reset' }).click()
    await expect(page).toHaveURL(/\/playground$/)
    await expect(page.getByLabel('Shape')).toHaveValue('pills')
  })

  test('a browser that refuses a new address does no harm', async ({ page }) => {
    const errors: string[] = []
    page.on('pageerror', (error) => errors.push(error.message))
    await page.clock.install({ time: 0 })
    await page.clock.pauseAt(1000)
    await page.goto('/playground')
    await page.evaluate(() => {
      Object.assign(window, { refused: 0 })
      const { replaceState } = history
      history.replaceState = (...args) => {
        if (!String(args[2]).includes('gravity=')) return replaceState.apply(history, args)
        Object.assign(window, { refused: (window as unknown as { refused: number }).refused + 1 })
        throw new DOMException('too often', 'SecurityError')
      }
    })
    // Twenty steps of a slider in one go are one address.
    await page.getByLabel('gravity').evaluate((slider: HTMLInputElement) => {
      for (let n = 0; n < 20; n++) {
        slider.stepUp()
        slider.dispatchEvent(new Event('input', { bubbles: true }))
      }
    })
    await expect(page.getByLabel('gravity')).toHaveValue('4600')
    const refused = () => page.evaluate(() => (window as unknown as { refused: number }).refused)
    await page.clock.runFor(1000)
    expect(await refused()).toBe(1)
    await page.clock.runFor(10_000)
    expect(await refused()).toBe(1)
    expect(errors).toEqual([])
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

  test('with reduced motion nothing falls before a press on Play, also after Reset', async ({ page }) => {
    await page.emulateMedia({ reducedMotion: 'reduce' })
    await page.goto('/playground?count=3')
    const words = page.getByText('Motion is off, as your system asks')
    await expect(words).toBeVisible()
    await page.getByRole('button', { name: 'Play' }).click()
    await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
    await expect(words).toBeHidden()
    await page.getByRole('button', { name: 'Reset' }).click()
    await expect(words).toBeVisible()
    await expect(page.locator(stage)).toHaveAttribute('data-state', 'paused')
    await expect(page.getByRole('button', { name: 'Play' })).toBeVisible()
  })

  test('an address that makes no sense does no harm', async ({ page }) => {
    await page.goto('/playground?count=1e9&gravity=NaN&shape=star&words=%2C%2C&bounce=-3')
    await expect(page.locator(`${stage} [data-chip]`)).toHaveCount(60)
    await expect(page.getByLabel('bounce')).toHaveValue('0')
    await expect(page.getByLabel('Shape')).toHaveValue('pills')
  })

  test('another seed makes another pile; the same seed the same', async ({ page }) => {
    const pile = async (seed: number) => {
      await page.goto(`/playground?count=8&seed=${seed}`)
      await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
      return page
        .locator(`${stage} [data-chip]`)
        .evaluateAll((chips) => chips.map((chip) => (chip as HTMLElement).style.transform))
    }
    const first = await pile(1)
    expect(await pile(2)).not.toEqual(first)
    expect(await pile(1)).toEqual(first)
  })

  test('paused, a press on Step moves the chips by one frame', async ({ page }) => {
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
    const [first, second, third] = [await step(), await step(), await step()]
    // Gravity makes the way of each frame longer by as much; the air takes a hundredth of a pixel of it.
    expect(third - second - (second - first)).toBeCloseTo(2600 / 60 ** 2, 1)
    await expect(page.locator(stage)).toHaveAttribute('data-state', 'paused')
  })

  test('a chip is dragged and tossed', async ({ page }) => {
    await page.goto('/playground?count=1')
    await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
    const chip = page.locator(`${stage} [data-chip]`)
    const from = (await chip.boundingBox())!
    await page.mouse.move(from.x + 20, from.y + 10)
    await page.mouse.down()
    await page.mouse.move(from.x + 40, from.y - 120, { steps: 8 })
    await expect.poll(async () => (await chip.boundingBox())!.y).toBeLessThan(from.y - 60)
    const room = (await page.locator(stage).boundingBox())!
    const way = from.x < room.x + room.width / 2 ? 1 : -1
    // Half a pixel a millisecond by the times of the events themselves: a hand that is late throws nothing, and a busy
    // machine's is.
    const hand = await chip.evaluate(
      async (element, { x, y, way }) => {
        const start = performance.now()
        const send = (type: string, ms: number) => {
          const event = new PointerEvent(type, {
            bubbles: true,
            pointerId: 1,
            pointerType: 'mouse',
            buttons: type === 'pointermove' ? 1 : 0,
            clientX: x + way * 0.5 * ms,
            clientY: y,
          })
          Object.defineProperty(event, 'timeStamp', { value: start + ms })
          element.dispatchEvent(event)
        }
        for (let ms = 0; ms < 300; ms += 1000 / 60) {
          send('pointermove', ms)
          await new Promise(requestAnimationFrame)
        }
        send('pointerup', 300)
        return x + way * 150
      },
      { x: from.x + 40, y: from.y - 120, way },
    )
    const beyond = async () => way * ((await chip.boundingBox())!.x + 20 - hand)
    await expect.poll(beyond).toBeGreaterThan(40)
    await page.mouse.up()
    await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
  })
})

test.describe('playground under a finger', () => {
  test.use({ hasTouch: true, viewport: { width: 390, height: 700 } })

  test('a chip is carried off when the finger rests, and the page scrolls when it does not', async ({
    page,
  }) => {
    await page.goto('/playground?count=1')
    const stage = page.locator('[data-slot=playground-stage]')
    await expect(stage).toHaveAttribute('data-state', 'resting')
    await stage.evaluate((element) => element.scrollIntoView({ block: 'center' }))
    const chip = stage.locator('[data-chip]')
    // Both at once: a page that a finger has sent off scrolls on meanwhile.
    const top = () =>
      chip.evaluate((element) => {
        const stage = element.closest('[data-slot=playground-stage]')!
        return element.getBoundingClientRect().y - stage.getBoundingClientRect().y
      })
    const scrolled = () => page.evaluate(() => scrollY)
    const session = await page.context().newCDPSession(page)
    const swipe = async (held: boolean) => {
      const { x, y, width, height } = (await chip.boundingBox())!
      const at = (up: number) => [{ x: x + width / 2, y: y + height / 2 - up }]
      await session.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: at(0) })
      // What is held is awake.
      if (held) await expect(stage).not.toHaveAttribute('data-state', 'resting')
      for (let up = 10; up <= 150; up += 10) {
        await session.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: at(up) })
        await page.evaluate(() => new Promise(requestAnimationFrame))
      }
      return () => session.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] })
    }
    const [lying, before] = [await top(), await scrolled()]

    const drop = await swipe(true)
    await expect.poll(top).toBeLessThan(lying - 80)
    expect(await scrolled()).toBe(before)
    await drop()
    await expect(stage).toHaveAttribute('data-state', 'resting')

    // The moment after which a finger holds never comes: a busy machine's swipe may take longer than that.
    await page.evaluate((never) => {
      const { setTimeout } = window
      window.setTimeout = ((work: () => void, ms?: number) =>
        ms === never ? 0 : setTimeout(work, ms)) as typeof window.setTimeout
    }, TOUCH_HOLD)
    const lies = await top()
    const lift = await swipe(false)
    await expect.poll(scrolled).toBeGreaterThan(before + 60)
    expect(await top()).toBeCloseTo(lies, 0)
    await lift()
  })
})

test('another scene or seed starts at its beginning, and leaves the focus where it is', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/docs/stability')
  const figures = page.locator('[data-slot=figure]')
  await expect(figures).toHaveCount(2)
  for (const figure of await figures.all()) {
    await figure.scrollIntoViewIfNeeded()
    await expect(figure).not.toContainText('…')
    const time = figure.getByLabel('Time', { exact: true })
    const toEnd = async () => {
      await time.press('End')
      await expect(time).not.toHaveValue('0')
    }
    await toEnd()
    const seed = figure.getByRole('button', { name: /^Seed/ })
    await seed.press('Enter')
    await expect(seed).toHaveText(/^Seed 2/)
    await expect(seed).toBeFocused()
    await expect(time).toHaveValue('0')
    await toEnd()
    const scene = figure.getByRole('combobox', { name: 'Scene' })
    const before = await scene.inputValue()
    await scene.press('ArrowUp')
    await expect(scene).not.toHaveValue(before)
    await expect(scene).toBeFocused()
    await expect(time).toHaveValue('0')
    await page.emulateMedia({ reducedMotion: 'no-preference' })
    await scene.press('ArrowDown')
    await expect(time).not.toHaveValue('0')
    await page.emulateMedia({ reducedMotion: 'reduce' })
  }
})

test('a scene is seen to be chosen before the page is busy with it, and no scene moves its controls', async ({
  page,
}) => {
  await page.goto('/docs/stability')
  for (const [n, scene] of ['A column of forty boxes stands', 'A pill falls for a second'].entries()) {
    const figure = page.locator('[data-slot=figure]').nth(n)
    await figure.scrollIntoViewIfNeeded()
    await expect(figure.locator('strong').first()).toBeVisible()
    const choice = figure.getByRole('combobox', { name: 'Scene' })
    const picture = figure.getByRole('img')
    const { height } = (await picture.boundingBox())!
    const before = await picture.getAttribute('aria-label')
    const atOnce = await choice.evaluate(async (select: HTMLSelectElement, text) => {
      select.selectedIndex = [...select.options].findIndex((option) => option.text.includes(text))
      select.dispatchEvent(new Event('change', { bubbles: true }))
      await Promise.resolve()
      return select.closest('[data-slot=figure]')!.querySelector('canvas')!.ariaLabel
    }, scene)
    expect(atOnce).toBe(before)
    await expect(picture).toHaveAccessibleName(new RegExp(scene))
    expect((await picture.boundingBox())!.height, 'a scene higher than wide is drawn smaller').toBeLessThan(
      2 * height,
    )
  }
})

for (const path of ['/docs/how-it-works', '/docs/stability']) {
  test(`at 320 px nothing on ${path} moves when a figure gets its numbers`, async ({ page }) => {
    // Played, numbers that grow wider move the next ones.
    await page.emulateMedia({ reducedMotion: 'reduce' })
    const shifted = await watchShifts(page)
    await page.setViewportSize({ width: 320, height: 900 })
    await page.goto(path)
    for (const figure of await page.locator('[data-slot=figure]').all()) {
      await figure.scrollIntoViewIfNeeded()
      await expect(figure.locator('strong').first()).toBeVisible()
    }
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))))
    expect(await shifted()).toBeLessThan(0.01)
  })
}

test('a scene that breaks solvers is drawn with both its walls', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/docs/stability')
  const canvas = page.locator('[data-slot=figure] canvas').first()
  const walls = () =>
    canvas.evaluate((element: HTMLCanvasElement) => {
      const { width, height } = element
      const { data } = element.getContext('2d')!.getImageData(0, 0, width, height)
      return [0, width - 1].map((x) =>
        Array.from({ length: height }, (_, y) => data[4 * (y * width + x) + 3]).every((alpha) => alpha > 0),
      )
    })
  await expect.poll(walls).toEqual([true, true])
})

test.describe('how it works', () => {
  test('each figure can be scrubbed with the keyboard', async ({ page }) => {
    await page.emulateMedia({ reducedMotion: 'reduce' })
    await page.goto('/docs/how-it-works')
    const times = page.getByLabel('Time', { exact: true })
    await expect(times).toHaveCount(6)
    for (const time of await times.all()) {
      await time.scrollIntoViewIfNeeded()
      await time.focus()
      await page.keyboard.press('End')
      await page.keyboard.press('ArrowLeft')
      await expect(time).not.toHaveValue('0')
    }
  })

  test('the figures run the solver: an impact meets its formula, a flight its curve', async ({ page }) => {
    await page.emulateMedia({ reducedMotion: 'reduce' })
    await page.goto('/docs/how-it-works')
    const [flight, impact] = await page.locator('[data-slot=figure]').all()
    await flight.getByLabel('Time', { exact: true }).press('End')
    await expect(flight).toContainText(/this solver (0|\d\.\d\s·\s10⁻¹.)\spx/)
    await impact.getByLabel('Time', { exact: true }).press('End')
    await expect(impact).toContainText(/Speed ([\d.]+) px\/sby formula \1/)
    await expect(impact).toContainText(/Spin ([\d.]+) rad\/sby formula \1/)
  })

  test('on paper every figure stands at a moment that shows something', async ({ page }) => {
    await page.emulateMedia({ reducedMotion: 'reduce' })
    await page.goto('/docs/how-it-works')
    const times = page.getByLabel('Time', { exact: true })
    await expect(times).toHaveCount(6)
    await expect(async () => {
      await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')))
      expect(
        await times.evaluateAll((all) => all.map((time) => (time as HTMLInputElement).value)),
      ).not.toContain('0')
    }).toPass()
    for (const figure of await page.locator('[data-slot=figure]').all()) {
      await expect(figure).not.toContainText('…')
    }
  })

  test('a figure plays when it is seen, unless the reader prefers reduced motion', async ({ page }) => {
    await page.goto('/docs/how-it-works')
    const time = page.getByLabel('Time', { exact: true }).first()
    await page.locator('[data-slot=figure] canvas').first().scrollIntoViewIfNeeded()
    await expect(time).not.toHaveValue('0')
    await page.emulateMedia({ reducedMotion: 'reduce' })
    await page.reload()
    await page.locator('[data-slot=figure] canvas').first().scrollIntoViewIfNeeded()
    await expect(page.locator('[data-slot=figure]').first()).toContainText('px')
    await expect(time).toHaveValue('0')
  })
})

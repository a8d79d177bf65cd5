import { readdirSync, readFileSync } from 'node:fs'
import { gzipSync } from 'node:zlib'
import AxeBuilder from '@axe-core/playwright'
import { expect, type Page, test } from '@playwright/test'

const docs = readdirSync('content/docs').map((file) => `/docs/${file.replace('.mdx', '')}`)
const pages = ['/', '/playground', ...docs, '/404']

/** px that the page is wider than its window. */
const overflow = (page: Page) =>
  page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth)

for (const path of pages) {
  test.describe(path, () => {
    test('shows one title and no error', async ({ page }) => {
      const errors: string[] = []
      page.on('pageerror', (error) => errors.push(error.message))
      page.on('console', (message) => {
        // A browser with a 404 page in its hands says so in the console.
        if (message.type() === 'error' && !message.text().includes('404')) errors.push(message.text())
      })
      await page.goto(path)
      await expect(page.getByRole('heading', { level: 1 })).toHaveCount(1)
      await expect(page.locator('#content')).toBeVisible()
      await page.waitForLoadState('networkidle')
      expect(errors).toEqual([])
    })

    for (const width of [320, 375]) {
      test(`fits a window of ${width} px`, async ({ page }) => {
        await page.setViewportSize({ width, height: 700 })
        await page.goto(path)
        await page.waitForLoadState('networkidle')
        expect(await overflow(page)).toBe(0)
      })
    }

    for (const colorScheme of ['light', 'dark'] as const) {
      test(`has no accessibility violation in ${colorScheme}`, async ({ page }) => {
        await page.emulateMedia({ colorScheme })
        await page.goto(path)
        await page.waitForLoadState('networkidle')
        expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([])
      })

      test(`has no accessibility violation in ${colorScheme} with reduced motion`, async ({ page }) => {
        await page.emulateMedia({ colorScheme, reducedMotion: 'reduce' })
        await page.goto(path)
        await page.waitForLoadState('networkidle')
        expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([])
      })
    }

    test('does not move about while it loads', async ({ page }) => {
      await page.addInitScript(() => {
        Object.assign(window, { shifted: 0 })
        new PerformanceObserver((list) => {
          for (const entry of list.getEntries()) {
            const { value } = entry as PerformanceEntry & { value: number }
            Object.assign(window, { shifted: (window as unknown as { shifted: number }).shifted + value })
          }
        }).observe({ type: 'layout-shift', buffered: true })
      })
      await page.goto(path)
      await page.waitForLoadState('networkidle')
      expect(await page.evaluate(() => (window as unknown as { shifted: number }).shifted)).toBeLessThan(0.01)
    })
  })
}

for (const path of docs) {
  test(`${path}.md is the page in Markdown, with no tag left`, async ({ page, request }) => {
    await page.goto(path)
    const markdown = await (await request.get(`${path}.md`)).text()
    expect(markdown).toContain(`# ${await page.getByRole('heading', { level: 1 }).textContent()}\n`)
    expect(markdown.replace(/^```[\s\S]*?^```/gm, '')).not.toMatch(/^<\/?[A-Z]/m)
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

test('the theme follows the system while nobody has pressed the switch', async ({ page }) => {
  await page.emulateMedia({ colorScheme: 'light' })
  await page.goto('/docs/setup', { waitUntil: 'networkidle' })
  await page.emulateMedia({ colorScheme: 'dark' })
  await expect(page.locator('html')).toHaveClass(/dark/)
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
    expect(await clipboard(page)).toBe(readFileSync('components/ui/gravity-stack.tsx', 'utf8'))
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
  await page.getByRole('button', { name: /Show all/ }).click()
  await expect(page.locator('#install-manual')).toContainText('export interface GravityStackProps')
})

test('a demo below the fold waits to be seen, then falls and comes to rest', async ({ page }) => {
  await page.setViewportSize({ width: 1280, height: 700 })
  await page.goto('/docs/gravity-stack')
  const stages = page.locator('[data-slot=gravity-stack]')
  await expect(stages.nth(0)).toHaveAttribute('data-state', 'resting', { timeout: 30_000 })
  await expect(stages.nth(2)).toHaveAttribute('data-state', /static|waiting/)
  await stages.nth(2).scrollIntoViewIfNeeded()
  await expect(stages.nth(2)).toHaveAttribute('data-state', 'resting', { timeout: 30_000 })
})

test('the home page performs what its buttons say and shows the code for it', async ({ page }) => {
  await page.goto('/')
  const stage = page.locator('[data-slot=gravity-stack]')
  await expect(stage).toHaveAttribute('data-state', 'resting', { timeout: 30_000 })
  await page.getByRole('button', { name: 'Shake' }).click()
  await expect(stage).toHaveAttribute('data-state', 'running')
  await expect(page.getByText('stack.current?.shake()')).toBeVisible()
  await page.getByRole('button', { name: 'Bouncier' }).click()
  await expect(page.getByText('bounce={0.7}')).toBeVisible()
})

test('the component page brings at most 165 kB of script', async ({ page }) => {
  // What the links of the page fetch in advance belongs to other pages.
  await page.route(/_rsc=/, (route) => route.abort())
  const scripts: Promise<Buffer>[] = []
  page.on('response', (response) => {
    if (response.request().resourceType() === 'script') scripts.push(response.body())
  })
  await page.goto('/docs/gravity-stack', { waitUntil: 'networkidle' })
  const bytes = (await Promise.all(scripts)).reduce((sum, body) => sum + gzipSync(body).length, 0)
  expect(bytes / 1000).toBeLessThanOrEqual(165)
})

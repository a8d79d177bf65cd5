import { expect } from '@playwright/test'
import { alive, test, withhold } from './page'

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

test('where nothing can be saved, themes and tabs change all the same', async ({ page }) => {
  await page.addInitScript(() => {
    Object.defineProperty(window, 'localStorage', {
      get: () => {
        throw new DOMException('Blocked', 'SecurityError')
      },
    })
  })
  const errors: string[] = []
  page.on('pageerror', (error) => errors.push(error.message))
  await page.emulateMedia({ colorScheme: 'dark' })
  await page.goto('/docs/setup')
  await expect(page.locator('html')).toHaveClass(/dark/)
  await page.getByRole('tab', { name: 'yarn' }).first().click()
  await expect(page.getByText('yarn dlx shadcn@latest').first()).toBeVisible()
  await page.getByRole('button', { name: 'Switch between light and dark' }).click()
  await expect(page.locator('html')).not.toHaveClass(/dark/)
  expect(errors).toEqual([])
})

test('a dark page is printed light, and is dark again afterwards', async ({ page }) => {
  await page.emulateMedia({ colorScheme: 'dark' })
  await page.goto('/docs/setup', { waitUntil: 'networkidle' })
  await page.emulateMedia({ media: 'print' })
  await expect(page.locator('html')).not.toHaveClass(/dark/)
  await expect(page.getByRole('navigation', { name: 'Docs' })).toBeHidden()
  await page.emulateMedia({ media: 'screen' })
  await expect(page.locator('html')).toHaveClass(/dark/)
  // On its way to a printer from the start.
  await page.emulateMedia({ media: 'print' })
  await page.reload()
  await expect(page.locator('html')).not.toHaveClass(/dark/)
})

import AxeBuilder from '@axe-core/playwright'
import { expect, type Locator, type Page } from '@playwright/test'
import { test, withhold } from './page'

const field = (page: Page) => page.getByRole('combobox', { name: 'Search' })
const results = (page: Page) => page.getByRole('listbox', { name: 'Results' }).getByRole('option')
const dialog = (page: Page) => page.getByRole('dialog', { name: 'Search' })
const said = (page: Page) => dialog(page).getByRole('status')

test('the search brings no byte before it is opened, and its index once', async ({ page }) => {
  const asked: string[] = []
  page.on('request', (request) => asked.push(new URL(request.url()).pathname))
  await page.goto('/docs/setup', { waitUntil: 'networkidle' })
  const before = asked.length
  expect(asked).not.toContain('/search.json')
  await page.keyboard.press('/')
  await expect(said(page)).toHaveText(/^\d+ pages$/)
  // The script is one that the page had not asked for.
  const scripts = asked.slice(before).filter((path) => path.endsWith('.js'))
  expect(scripts.length).toBeGreaterThan(0)
  expect(asked.slice(0, before)).not.toEqual(expect.arrayContaining(scripts))
  await page.keyboard.press('Escape')
  await expect(page.locator('body')).toBeFocused()
  await page.keyboard.press('/')
  await expect(results(page).first()).toBeVisible()
  expect(asked.filter((path) => path === '/search.json')).toHaveLength(1)
})

test('a slash opens the search as soon as the page is alive, however late its other effects come', async ({
  page,
}) => {
  // What React puts off until after its commit comes as a message: none comes any more.
  await page.addInitScript(() => {
    const { postMessage } = MessagePort.prototype
    MessagePort.prototype.postMessage = function (this: MessagePort, ...args: [unknown]) {
      const alive = Object.keys(document.documentElement).some((key) => key.startsWith('__reactProps'))
      if (!alive) postMessage.apply(this, args)
    } as typeof postMessage
  })
  await page.goto('/docs/setup')
  await page.keyboard.press('/')
  await expect(dialog(page)).toBeVisible()
})

test('who types “reduced motion” is told how many results there are, and Enter opens the first', async ({
  page,
}) => {
  await page.goto('/docs/setup')
  await page.keyboard.press('/')
  await page.keyboard.type('reduced motion')
  await expect(said(page)).toHaveText(/^\d+ results$/)
  await expect(results(page)).toHaveCount(Number.parseInt((await said(page).textContent())!, 10))
  await page.keyboard.press('Enter')
  await expect(page).toHaveURL(/\/docs\/accessibility#motion$/)
  await expect(page.getByRole('heading', { name: 'Motion', exact: true })).toBeInViewport()
})

test('arrows move through the results, and past the last to the first', async ({ page }) => {
  await page.goto('/docs')
  await page.keyboard.press('/')
  await page.keyboard.type('drop')
  const expectChosen = async (option: Locator) => {
    await expect(option).toHaveAttribute('aria-selected', 'true')
    await expect(option).toBeInViewport()
    await expect(field(page)).toHaveAttribute('aria-activedescendant', (await option.getAttribute('id'))!)
    await expect(page.getByRole('option', { selected: true })).toHaveCount(1)
  }
  await expectChosen(results(page).first())
  await page.keyboard.press('ArrowDown')
  await expectChosen(results(page).nth(1))
  await page.keyboard.press('ArrowUp')
  await page.keyboard.press('ArrowUp')
  await expectChosen(results(page).last())
  await page.keyboard.type('s')
  await expectChosen(results(page).first())
})

for (const [query, kind, title, place] of [
  ['stagger', 'Prop', 'stagger', '#prop-stagger'],
  ['shake', 'Action', 'shake()', '#action-shake'],
  ['fill hero', 'Recipe', 'Fill a hero', '#fill-a-hero'],
  ['avatars', 'Example', 'Avatars', '#avatars'],
  [
    'ERESOLVE',
    'Error message',
    'ERESOLVE could not resolve and react@17',
    'td:has-text("ERESOLVE could not")',
  ],
  ['page load', 'Section', 'What a page has to load', '#weight'],
])
  test(`“${query}” leads to the ${kind.toLowerCase()} ${title}`, async ({ page }) => {
    await page.goto('/')
    await page.keyboard.press('Control+k')
    await page.keyboard.type(query)
    await results(page).filter({ hasText: kind }).filter({ hasText: title }).first().click()
    await expect(page).not.toHaveURL('/')
    await expect(page.locator(place)).toBeInViewport()
  })

test('from anywhere ⌘K and Ctrl K open and close it, and Escape gives the focus back', async ({ page }) => {
  await page.goto('/playground')
  const slider = page.getByRole('slider', { name: 'gravity' })
  for (const key of ['Control+k', 'Meta+k']) {
    await slider.focus()
    await page.keyboard.press(key)
    await expect(field(page)).toBeFocused()
    await page.keyboard.press(key)
    await expect(dialog(page)).toBeHidden()
    await expect(slider).toBeFocused()
  }
  const button = page.getByRole('button', { name: 'Search', exact: true })
  await button.press('Enter')
  await expect(field(page)).toBeFocused()
  await page.keyboard.type('x')
  await page.keyboard.press('Escape')
  await expect(button).toBeFocused()
  // It opens empty again, and a press beside it closes it too.
  await button.click()
  await expect(field(page)).toHaveValue('')
  await page.mouse.click(20, 500)
  await expect(dialog(page)).toBeHidden()
})

test('a slash in a field is a slash, and none opens the search over the menu', async ({ page }) => {
  await page.setViewportSize({ width: 375, height: 700 })
  await page.goto('/playground')
  const words = page.getByRole('textbox').first()
  await words.fill('')
  await words.press('/')
  await expect(words).toHaveValue('/')
  await expect(dialog(page)).toBeHidden()
  await page.getByRole('button', { name: 'Menu' }).click()
  await page.keyboard.press('/')
  await page.keyboard.press('Control+k')
  await expect(page.getByRole('dialog', { name: 'Menu' })).toBeVisible()
  await expect(dialog(page)).toBeHidden()
  await page.keyboard.press('Escape')
  await page.keyboard.press('Control+k')
  await page.keyboard.type('a/b')
  await expect(field(page)).toHaveValue('a/b')
})

test('what is typed while the search is on its way is searched for', async ({ page }) => {
  const letCome = await withhold(page, '**/search.json')
  await page.goto('/docs')
  await page.keyboard.press('/')
  await expect(said(page)).toHaveText('Fetching…')
  await page.keyboard.type('friction')
  letCome()
  await expect(said(page)).toHaveText(/results$/)
  await expect(field(page)).toHaveValue('friction')
  await expect(field(page)).toBeFocused()
})

test('a search that could not be fetched says so, and is fetched when it is opened again', async ({
  page,
}) => {
  await page.route('**/search.json', (route) => route.abort())
  await page.goto('/docs')
  await page.keyboard.press('/')
  await expect(said(page)).toHaveText(/could not be fetched/)
  await page.unroute('**/search.json')
  await page.keyboard.press('Escape')
  await expect(page.locator('body')).toBeFocused()
  await page.keyboard.press('/')
  await page.keyboard.type('zebra')
  await expect(said(page)).toHaveText('Nothing has the words “zebra”')
})

test('the search has no accessibility violation, light or dark, wide or 375 px, and fits', async ({
  page,
}) => {
  for (const [width, colorScheme] of [
    [1280, 'light'],
    [1280, 'dark'],
    [375, 'dark'],
    [320, 'light'],
  ] as const) {
    await page.setViewportSize({ width, height: 640 })
    await page.emulateMedia({ colorScheme })
    await page.goto('/docs/setup')
    await page.keyboard.press('/')
    for (const query of ['', 'could not', 'zebra']) {
      await field(page).fill(query)
      await expect(said(page)).toHaveText(query === 'zebra' ? /^Nothing/ : /\d/)
      const axe = new AxeBuilder({ page }).setLegacyMode().include('dialog[open]')
      expect((await axe.analyze()).violations, `${width} ${colorScheme} “${query}”`).toEqual([])
      const box = (await dialog(page).boundingBox())!
      expect(box.x).toBeGreaterThanOrEqual(0)
      expect(box.x + box.width).toBeLessThanOrEqual(width)
      expect(box.y + box.height).toBeLessThanOrEqual(640)
    }
  }
})

test('every entry of the search leads to a place on a page', async ({ request }) => {
  const html = new Map<string, string>()
  const entries: { href: string }[] = await (await request.get('/search.json')).json()
  const dead: string[] = []
  for (const { href } of entries) {
    const [path, anchor] = href.replace(/:~:.*/, '').split('#')
    if (!html.has(path)) html.set(path, await (await request.get(path)).text())
    if (anchor && !html.get(path)!.includes(` id="${anchor}"`)) dead.push(href)
  }
  expect(dead).toEqual([])
  expect(entries.length).toBeGreaterThan(100)
})

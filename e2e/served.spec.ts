import { readdirSync, readFileSync } from 'node:fs'
import { expect, type Page } from '@playwright/test'
import { registryItemSchema } from 'shadcn/schema'
import { releases } from '../scripts/releases.mjs'
import { addressed } from '../site.config.mjs'
import { docs, pages, test } from './page'

// What the host gives to browsers, crawlers, machines that read Markdown, and other sites.

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
    const link = page.getByRole('link', { name: 'Open as Markdown', includeHidden: true })
    await expect(link).toHaveAttribute('href', twin)
  })
}

test('Markdown tells what tabs and figures show, and which bounds are missed, and links to Markdown alone', async ({
  page,
  request,
  baseURL,
}) => {
  const markdownOf = async (path: string) => (await request.get(path)).text()
  const component = await markdownOf('/docs/gravity-stack.md')
  expect(component).toContain('title="gravity-stack-demo.tsx"')
  expect(component).toMatch(
    /With the CLI:[\s\S]+npx shadcn@latest add[\s\S]+By hand:[\s\S]+npm install motion/,
  )
  expect(await markdownOf('/docs/setup.md')).toContain(`registry add @liten=${baseURL}/r/{name}.json`)
  expect(await markdownOf('/docs/how-it-works.md')).toContain('_On the page itself a figure runs here._')
  expect(await markdownOf('/index.md')).toContain('<GravityStack actionsRef={actions} gravity={6000}')

  for (const [path, words] of [
    ['/docs/stability', ', missed'],
    ['/benchmarks', 'goal missed'],
  ]) {
    await page.goto(path)
    const missed = page.locator('td strong').filter({ hasText: /missed/ })
    expect((await markdownOf(`${path}.md`)).split(words).length - 1, path).toBe(await missed.count())
  }
  for (const path of docs) {
    const text = await markdownOf(`${path}.md`)
    const prose = text.replace(/^```[\s\S]*?^```/gm, 'code')
    expect(prose, path).not.toContain('\n\n\n')
    const links = [...prose.matchAll(/\]\(([^)]+)\)/g)].map(([, to]) => to)
    expect(links.filter((to) => !/^(https?:|#)/.test(to) || /\/docs\/[\w-]+(#|$)/.test(to))).toEqual([])
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

test('every link and anchor of the site leads somewhere', async ({ request }) => {
  const html = new Map<string, string>()
  for (const path of pages) html.set(path, await (await request.get(path)).text())
  const dead: string[] = []
  // Links of the blocks are examples, so only pages of the site are asked for theirs.
  for (const [path, text] of [...html]) {
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
  'https://www.w3.org/WAI/WCAG22/Understanding/motion-actuation',
]

/** Where a page or an item can be taken to; what they are handed is tested below. */
const takers = /^https:\/\/(chatgpt\.com|claude\.ai|v0\.app)\//

test('links to other sites are those that somebody has looked at', async ({ request, baseURL }) => {
  const found = new Set<string>()
  for (const path of pages) {
    const text = await (await request.get(path)).text()
    for (const [, href] of text.matchAll(/<a\s[^>]*?href="(\w+:[^"]*)"/g)) {
      if (!href.startsWith(baseURL!)) found.add(href)
    }
  }
  const edits = process.env.REPOSITORY_URL || 'no repository is named'
  const others = [...found].filter((href) => !href.startsWith(edits) && !takers.test(href))
  expect(others.sort()).toEqual(elsewhere)
})

test('who is handed a page or an item elsewhere is given an address that the site serves', async ({
  request,
  baseURL,
}) => {
  const given = new Set<string>()
  for (const path of pages) {
    const text = await (await request.get(path)).text()
    for (const [, href] of text.matchAll(/<a\s[^>]*?href="(\w+:[^"]*)"/g)) {
      if (!takers.test(href)) continue
      const query = new URL(href.replaceAll('&amp;', '&')).searchParams
      const [address] = `${query.get('q') ?? query.get('url')}`.match(/http[^\s,]+/)!
      given.add(address.replace(baseURL!, ''))
    }
  }
  for (const path of pages.filter((path) => path !== '/404'))
    expect(given).toContain(path === '/' ? '/index.md' : `${path}.md`)
  expect(given).toContain('/v0/gravity-stack.json')
  for (const path of given) expect((await request.get(path)).ok(), path).toBe(true)
})

test('what v0 is given holds to the schema of a registry, with the component and a page that shows it', async ({
  request,
}) => {
  const answer = await request.get('/v0/gravity-stack.json')
  expect(answer.headers()['access-control-allow-origin']).toBe('*')
  const item = registryItemSchema.parse(await answer.json())
  // v0 follows no names to other items, and reads no stylesheet of one.
  expect(item).not.toHaveProperty('registryDependencies')
  const files: Record<string, string> = {}
  for (const { target, content } of item.files!) files[target!] = content!
  const registry = await (await request.get('/r/gravity-stack.json')).json()
  expect(files['components/ui/gravity-stack.tsx'] === registry.files[0].content).toBe(true)
  for (const content of Object.values(files)) {
    for (const [, from] of content.matchAll(/from '@\/([^']+)'/g)) expect(files[`${from}.tsx`]).toBeDefined()
  }
  expect(files['app/page.tsx']).toContain('<GravityStackDemo />')
})

test('each page names its own address and its Markdown', async ({ page, baseURL }) => {
  for (const path of ['/docs/setup', '/docs', '/playground']) {
    await page.goto(path)
    await expect(page.locator('link[rel=canonical]')).toHaveAttribute('href', `${baseURL}${path}`)
    await expect(page.locator('link[type="text/markdown"]')).toHaveAttribute('href', `${baseURL}${path}.md`)
    expect(await page.title()).toContain('Gravity Stack')
  }
})

test('every page has words of its own and a picture for those who share it', async ({
  page,
  request,
  baseURL,
}) => {
  const seen = new Set<string>()
  for (const path of pages.filter((path) => path !== '/404')) {
    await page.goto(path)
    const meta = (name: string) => page.locator(`meta[property="${name}"]`).getAttribute('content')
    expect(await meta('og:url')).toBe(new URL(path, baseURL).href.replace(/\/$/, ''))
    await expect(page.locator('meta[name="twitter:card"]')).toHaveAttribute('content', 'summary_large_image')
    seen.add(`${await page.title()} ${await page.locator('meta[name=description]').getAttribute('content')}`)
    // The pile at rest, and the loop of its drop.
    const pictures = await page
      .locator('meta[property="og:image"]')
      .evaluateAll((all) => all.map((one) => new URL(one.getAttribute('content') ?? '').pathname))
    const types = await Promise.all(
      pictures.map(async (at) => (await request.get(at)).headers()['content-type']),
    )
    expect(types).toEqual(['image/png', 'image/webp'])
  }
  expect(seen.size).toBe(pages.length - 1)
})

test('a crawler finds the map of the site, and the component’s page under a title of its own', async ({
  page,
  request,
  baseURL,
}) => {
  expect(await (await request.get('/robots.txt')).text()).toContain(`Sitemap: ${baseURL}/sitemap.xml`)
  await page.goto('/docs/gravity-stack')
  await expect(page).toHaveTitle('Gravity Stack, a React component')
})

test('llms.txt and the sitemap list every page, and llms-full.txt holds the source', async ({ request }) => {
  const index = await (await request.get('/llms.txt')).text()
  const map = await (await request.get('/sitemap.xml')).text()
  for (const path of ['/blocks', '/playground', '/benchmarks', ...docs]) {
    expect(index).toContain(`${path}.md)`)
    expect(map).toContain(`${path}</loc>`)
  }
  for (const [, to] of index.matchAll(/\]\(http:\/\/localhost:\d+([^)]*)/g)) {
    expect((await request.get(to)).ok(), to).toBe(true)
  }
  const full = await (await request.get('/llms-full.txt')).text()
  const file = addressed(readFileSync('components/ui/gravity-stack.tsx', 'utf8'))
  expect(full.includes(file.trim())).toBe(true)
})

test('a feed announces each released version, with what is new and a link to it', async ({
  page,
  baseURL,
}) => {
  await page.goto('/docs/changelog')
  const feed = page.locator('link[type="application/rss+xml"]')
  await expect(feed).toHaveAttribute('href', `${baseURL}/changelog.xml`)
  const items = await page.evaluate(async () => {
    const parsed = new DOMParser().parseFromString(await (await fetch('/changelog.xml')).text(), 'text/xml')
    return [...parsed.querySelectorAll('item')].map((item) =>
      ['title', 'link', 'pubDate', 'description'].map((name) => item.querySelector(name)?.textContent ?? ''),
    )
  })
  expect(items.map(([title]) => title)).toEqual(
    Object.keys(releases).map((version) => `Gravity Stack ${version}`),
  )
  const [, link, date, description] = items.at(-1)!
  expect(date).toBe('Sat, 28 Nov 2026 00:00:00 GMT')
  expect(description).toContain('<li>Each child collides as what it is')
  await page.goto(link)
  await expect(page.getByRole('heading', { name: '0.1.0' })).toBeInViewport()
})

test('the registry may be read from any site, and what never changes is asked for once', async ({
  page,
  request,
}) => {
  const item = (await request.get('/r/gravity-stack.json')).headers()
  expect(item['access-control-allow-origin']).toBe('*')
  expect(item['cache-control']).toBe('public, max-age=300')
  expect(item['content-encoding']).toMatch(/^(br|gzip)$/)
  await page.goto('/')
  const script = await page.locator('script[src]:not([nomodule])').first().getAttribute('src')
  const headers = (await request.get(script!)).headers()
  expect(headers['cache-control']).toBe('public, max-age=31536000, immutable')
  expect(headers['x-content-type-options']).toBe('nosniff')
  expect((await request.get('/source/gravity-stack.tsx.txt')).headers()['content-type']).toBe(
    'text/plain;charset=utf-8',
  )
})

test('a page that somebody points at is fetched before the press, a file is not', async ({
  page,
  context,
}) => {
  await page.goto('/docs/setup')
  const early: string[] = []
  context.on('request', (request) => {
    if (request.headers()['sec-purpose'] === 'prefetch') early.push(new URL(request.url()).pathname)
  })
  // A press tells at once, and is none when it ends elsewhere.
  await page.getByRole('button', { name: 'More ways' }).click()
  for (const link of [
    page.getByRole('link', { name: 'Open as Markdown' }),
    page.getByRole('navigation', { name: 'Docs' }).getByRole('link', { name: 'Recipes' }),
  ]) {
    await link.hover()
    await page.mouse.down()
    await page.getByRole('heading', { level: 1 }).hover()
    await page.mouse.up()
  }
  await expect.poll(() => early).toEqual(['/docs/recipes'])
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

test.describe('scripts come', () => {
  const sources = (page: Page) =>
    page
      .locator('script[src]:not([nomodule])')
      .evaluateAll((scripts) => scripts.map((script) => (script as HTMLScriptElement).src))

  // Time stands still in pages that come after this.
  const stopTime = async (page: Page) => {
    await page.clock.install({ time: 0 })
    await page.clock.pauseAt(1000)
  }

  test('once, also when the wait for the first paint runs out later', async ({ page }) => {
    await stopTime(page)
    await page.goto('/docs/setup')
    const first = await sources(page)
    expect(first.length).toBeGreaterThan(0)
    await page.clock.runFor(3000)
    expect(await sources(page)).toEqual(first)
  })

  test('without word of a first paint: at once in a hidden tab, after three seconds in one that is seen', async ({
    page,
  }) => {
    await stopTime(page)
    await page.addInitScript(() => {
      PerformanceObserver.prototype.observe = () => {}
      const hidden = location.search === '?hidden'
      Object.defineProperty(document, 'hidden', { get: () => hidden })
    })
    await page.goto('/docs/setup?hidden')
    const loaded = page.goto('/docs/setup')
    await page.waitForURL('/docs/setup')
    expect(await sources(page)).toEqual([])
    await page.clock.runFor(3000)
    await loaded
  })
})

test('an address that leads nowhere gets the page whose words fall', async ({ page }) => {
  const answer = await page.goto('/nowhere/at/all')
  expect(answer?.status()).toBe(404)
  await expect(page.getByRole('heading', { name: 'Page not found' })).toBeVisible()
  await expect(page.locator('[data-slot=gravity-stack]')).toHaveAttribute('data-state', 'resting')
})

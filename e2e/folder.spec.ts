import { execFileSync } from 'node:child_process'
import { createHash } from 'node:crypto'
import { existsSync, readdirSync, readFileSync } from 'node:fs'
import { rm } from 'node:fs/promises'
import type { Server } from 'node:http'
import type { AddressInfo } from 'node:net'
import { join } from 'node:path'
import { expect } from '@playwright/test'
import { root } from '../scripts/run.mjs'
import { serve } from '../scripts/serve.mjs'
import { committedUrl } from '../site.config.mjs'
import { pages, test } from './page'

// The site as it stands on a host that gives each project a folder: built for that address and served there.
const base = '/gravity-stack'
const folder = join(root, 'out-folder')
let server: Server
let origin: string

const filesOf = (path: string) =>
  readdirSync(join(root, path), { encoding: 'utf8', recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath, entry.name))

const committed = () =>
  [join(root, 'registry.json'), ...filesOf('public'), ...filesOf('components/ui')].map((path) => [
    path,
    createHash('sha1').update(readFileSync(path)).digest('hex'),
  ])

// One worker has all of these tests, so that the site is built once.
test.describe.configure({ mode: 'default', timeout: 600_000 })

let before: string[][]
let after: string[][]

test.beforeAll(async () => {
  server = await serve(folder, 0, base)
  origin = `http://localhost:${(server.address() as AddressInfo).port}`
  before = committed()
  execFileSync('node', ['scripts/build.mjs'], {
    cwd: root,
    env: { ...process.env, SITE_URL: `${origin}${base}`, SITE_OUT: 'out-folder' },
  })
  after = committed()
})

test.afterAll(async () => {
  server.close()
  server.closeAllConnections()
  await rm(folder, { recursive: true })
})

test('a build for an address leaves what is committed as it is', () => {
  expect(after).toEqual(before)
})

test('in a folder every address in every page, file and registry item leads somewhere', async ({
  request,
}) => {
  const named = new Map<string, string>()
  const written = filesOf('out-folder').filter((path) => /\.(html|md|txt|json|xml|css)$/.test(path))
  for (const path of written) {
    const text = readFileSync(path, 'utf8')
    expect(text, `${path} names the committed address`).not.toContain(committedUrl)
    const whole = text.match(RegExp(`${origin}[^\\s"'\`<>()\\\\]*`, 'g')) ?? []
    // The links of a block are examples, which lead to pages of whoever takes it.
    const own = path.includes('/blocks/') ? text.replace(/<a [^>]*>/g, '') : text
    const attributes = path.endsWith('.html')
      ? [...own.matchAll(/(?:href|src|content)="(\/[^"]*)"/g)].map(([, to]) => `${origin}${to}`)
      : []
    for (const to of [...whole, ...attributes])
      named.set(to.replaceAll('&amp;', '&').replace('{name}', 'gravity-stack').replace(/[.,]$/, ''), path)
  }
  const dead: string[] = []
  for (const [to, path] of named) {
    const answer = await request.get(to)
    if (!answer.ok()) dead.push(`${path} → ${to}`)
  }
  expect(dead).toEqual([])
  expect(named.has(`${origin}${base}/docs/setup.md`)).toBe(true)
  expect(named.has(`${origin}${base}/r/gravity-stack.json`)).toBe(true)
})

test('in a folder every page works: links, fonts, pictures, scripts and what buttons fetch', async ({
  page,
  context,
}) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write'])
  const wrong: string[] = []
  page.on('pageerror', (error) => wrong.push(error.message))
  page.on('response', (response) => {
    if (!response.ok() && !response.url().endsWith('/404')) wrong.push(response.url())
  })
  for (const path of pages) {
    await page.goto(`${origin}${base}${path}`)
    const links = await page
      .locator('a[href]')
      .evaluateAll((all) => (all as HTMLAnchorElement[]).map(({ href }) => href))
    wrong.push(...links.filter((to) => to.startsWith(origin) && !to.startsWith(`${origin}${base}/`)))
  }

  await page.goto(`${origin}${base}/docs/gravity-stack`)
  const marked = page.getByRole('navigation', { name: 'Main' }).locator('[aria-current]')
  await expect(marked).toHaveText(['Docs'])
  await page.getByRole('button', { name: 'Copy page' }).click()
  await expect(page.getByRole('button', { name: 'Copied' })).toBeVisible()
  await page.getByRole('tab', { name: 'Manual' }).click()
  await page.getByRole('button', { name: /^Show all/ }).click()
  await expect(page.getByRole('region', { name: 'components/ui/gravity-stack.tsx' })).toBeVisible()

  await page.goto(`${origin}${base}/docs/setup`)
  await expect(marked).toHaveText(['Docs'])
  const early = context.waitForEvent('request', (request) => !!request.headers()['sec-purpose'])
  await page.getByRole('navigation', { name: 'Docs' }).getByRole('link', { name: 'Recipes' }).hover()
  expect((await early).url()).toBe(`${origin}${base}/docs/recipes`)

  await page.getByRole('button', { name: 'Search' }).click()
  await page.getByRole('combobox').fill('reduced motion')
  await page.getByRole('option').first().click()
  await expect(page).toHaveURL(RegExp(`${base}/docs/`))

  await page.goto(`${origin}${base}/benchmarks`)
  await page.locator('summary').filter({ hasText: 'Figures' }).first().click()
  await expect(page.getByRole('columnheader', { name: 'Setting' }).first()).toBeVisible()
  expect(wrong).toEqual([])
})

test('in a folder the host finds its headers, no Jekyll and the page for what is not there', async ({
  request,
}) => {
  const item = await request.get(`${origin}${base}/r/gravity-stack.json`)
  expect(item.headers()['access-control-allow-origin']).toBe('*')
  expect(readFileSync(join(folder, '_headers'), 'utf8')).toContain(`\n${base}/_next/static/*\n`)
  expect(existsSync(join(folder, '.nojekyll'))).toBe(true)
  const lost = await request.get(`${origin}${base}/nowhere/at/all`)
  expect(lost.status()).toBe(404)
  expect(await lost.text()).toContain('Page not found')
})

import { execFileSync, spawn } from 'node:child_process'
import { once } from 'node:events'
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { createServer } from 'node:http'
import type { AddressInfo } from 'node:net'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { expect, type Page, test } from '@playwright/test'
import { build } from 'esbuild'
import type { Pin } from '../registry/gravity-stack/pins'
import { findEngines } from '../scripts/browser.mjs'

const path = (name: string) => fileURLToPath(new URL(`../registry/gravity-stack/${name}`, import.meta.url))
const pins: Record<string, Pin> = JSON.parse(readFileSync(path('pins.json'), 'utf8'))

/** Plays the pinned scenes in any engine. */
const script = build({
  stdin: {
    contents: `
      import { fingerprint, pinned } from './pins'
      import { createWorld } from './world'
      globalThis.found = JSON.stringify(Object.fromEntries(pinned.map((name) => [name, fingerprint(name, createWorld)])))`,
    resolveDir: path(''),
    loader: 'ts',
  },
  bundle: true,
  format: 'iife',
  write: false,
}).then(({ outputFiles }) => outputFiles[0].text)

async function inChromium(page: Page) {
  await page.addScriptTag({ content: await script })
  return page.evaluate('found') as Promise<string>
}

/** No driver: a page that sends back what it has found. */
async function inFirefox(command: string, folder: string) {
  const page = `<!doctype html><meta charset="utf-8"><script>${await script}
    fetch('/', { method: 'POST', body: found })</script>`
  const server = createServer((request, response) => {
    if (request.method !== 'POST') return response.setHeader('content-type', 'text/html').end(page)
    let body = ''
    request.on('data', (text) => {
      body += text
    })
    request.on('end', () => server.emit('found', body))
  }).listen(0)
  const url = `http://localhost:${(server.address() as AddressInfo).port}`
  const args = ['--headless', '--no-remote', '--profile', folder, url]
  // It ends before the test gives up, so that none is left behind.
  const browser = spawn(command, args, { stdio: 'ignore', timeout: 50_000 })
  const exit = once(browser, 'exit')
  try {
    const ended = exit.then(() => [`${command} ended before it had found anything`])
    return (await Promise.race([once(server, 'found'), ended]))[0] as string
  } finally {
    browser.kill()
    await exit
    server.closeAllConnections()
    server.close()
  }
}

async function inJavaScriptCore(command: string, folder: string) {
  const file = join(folder, 'scenes.js')
  writeFileSync(file, `${await script};print(found)`)
  return execFileSync(command, [file], { encoding: 'utf8' })
}

const engines = findEngines()
const missing = engines.filter(({ path }) => !path).map(({ name }) => name)
const without = missing.length > 0 ? ` (${missing.join(' and ')} could not be asked: not installed)` : ''

test(`five named scenes settle at the same step with the same bits as in Node in Chromium${without}`, async ({
  page,
}) => {
  expect(JSON.parse(await inChromium(page))).toEqual(pins)
})

for (const { name, path } of engines) {
  if (!path) continue
  test(`five named scenes settle at the same step with the same bits as in Node in ${name}`, async () => {
    const folder = mkdtempSync(join(tmpdir(), 'same-bits-'))
    try {
      const found = await (name === 'Firefox' ? inFirefox : inJavaScriptCore)(path, folder)
      expect(JSON.parse(found)).toEqual(pins)
    } finally {
      rmSync(folder, { recursive: true, force: true, maxRetries: 5 })
    }
  })
}

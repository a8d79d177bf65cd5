import { execFileSync, spawn } from 'node:child_process'
import { once } from 'node:events'
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { createServer } from 'node:http'
import type { AddressInfo } from 'node:net'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { runInNewContext } from 'node:vm'
import { expect, type Page, test } from '@playwright/test'
import { build } from 'esbuild'
import type { Pin } from '../registry/gravity-stack/testing/pins'
import { findEngines } from '../scripts/browser.mjs'

const path = (name: string) => fileURLToPath(new URL(`../registry/gravity-stack/${name}`, import.meta.url))
const pins: Record<string, Pin> = JSON.parse(readFileSync(path('testing/pins.json'), 'utf8'))

/** Plays the pinned scenes in any engine, and asks for the releases of 60 chips, each above all before it. */
const script = build({
  stdin: {
    contents: `
      import { reach, releasePose, releaseTime } from './stage/release'
      import { fingerprint, pinned } from './testing/pins'
      import { createWorld } from './world'
      const scenes = Object.fromEntries(pinned.map((name) => [name, fingerprint(name, createWorld)]))
      const obstacles = []
      const releases = Array.from({ length: 60 }, (_, i) => {
        const size = [40 + i / 3, 24 + i / 7]
        const pose = releasePose(i, ...size, 640, 2600, obstacles)
        obstacles.push({ x: pose.x, y: pose.y, reach: reach(...size) })
        return [releaseTime(i, i / 100), pose]
      })
      globalThis.found = JSON.stringify({ scenes, releases })`,
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
  const browser = spawn(command, args, { stdio: 'ignore', timeout: 150_000 })
  const exit = once(browser, 'exit')
  try {
    const ended = exit.then(() => {
      throw new Error(`${command} ended before it had found anything`)
    })
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

async function compare(found: string) {
  const { scenes, releases } = JSON.parse(found)
  expect(scenes).toEqual(pins)
  expect(releases).toEqual(JSON.parse(runInNewContext(`${await script};found`)).releases)
}

// WebKit's own shell is asked instead of its browser.
const engines = findEngines().filter(({ name }) => name !== 'WebKit')
const missing = engines.filter(({ path }) => !path).map(({ name }) => name)
const without = missing.length > 0 ? ` (${missing.join(' and ')} could not be asked: not installed)` : ''

test(`five named scenes and 60 releases give the same bits as in Node in Chromium${without}`, async ({
  page,
}) => {
  await compare(await inChromium(page))
})

for (const { name, path } of engines) {
  if (!path) continue
  test(`five named scenes and 60 releases give the same bits as in Node in ${name}`, async () => {
    const folder = mkdtempSync(join(tmpdir(), 'same-bits-'))
    try {
      await compare(await (name === 'Firefox' ? inFirefox : inJavaScriptCore)(path, folder))
    } finally {
      rmSync(folder, { recursive: true, force: true, maxRetries: 5 })
    }
  })
}

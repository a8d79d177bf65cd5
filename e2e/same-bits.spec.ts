import { execFileSync } from 'node:child_process'
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { runInNewContext } from 'node:vm'
import { expect, type Page, test } from '@playwright/test'
import { build } from 'esbuild'
import type { Pin } from '../registry/gravity-stack/testing/pins'
import { findEngines } from '../scripts/browser.mjs'
import { inFirefox } from './in-firefox'

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
      const taken = []
      const releases = Array.from({ length: 60 }, (_, i) => {
        const size = [40 + i / 3, 24 + i / 7]
        const pose = releasePose(i, ...size, 640, 2600, taken)
        const far = reach(...size)
        taken.push([pose.x - far, pose.y - far, pose.x + far, pose.y + far])
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
      await compare(
        await (name === 'Firefox' ? inFirefox(path, folder, await script) : inJavaScriptCore(path, folder)),
      )
    } finally {
      rmSync(folder, { recursive: true, force: true, maxRetries: 5 })
    }
  })
}

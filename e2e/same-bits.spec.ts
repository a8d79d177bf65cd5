import { readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { expect, test } from '@playwright/test'
import { build } from 'esbuild'
import type { Pin, pinned as Pinned } from '../registry/gravity-stack/pins'

const path = (name: string) => fileURLToPath(new URL(`../registry/gravity-stack/${name}`, import.meta.url))
const pins: Record<string, Pin> = JSON.parse(readFileSync(path('pins.json'), 'utf8'))

test('five named scenes settle at the same step with the same bits as in Node', async ({ page }) => {
  const { outputFiles } = await build({
    stdin: {
      contents: `export { fingerprint, pinned } from './pins'; export { createWorld } from './world'`,
      resolveDir: path(''),
      loader: 'ts',
    },
    bundle: true,
    format: 'iife',
    globalName: 'solver',
    write: false,
  })
  await page.addScriptTag({ content: outputFiles[0].text })
  const found = await page.evaluate(() => {
    // biome-ignore lint/suspicious/noExplicitAny: the bundle's global
    const { fingerprint, pinned, createWorld } = (globalThis as any).solver
    return Object.fromEntries(
      (pinned as typeof Pinned).map((name) => [name, fingerprint(name, createWorld) as Pin]),
    )
  })
  expect(found).toEqual(pins)
})

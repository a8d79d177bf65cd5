import { spawnSync } from 'node:child_process'
import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { expect, type Page } from '@playwright/test'
import { build } from 'esbuild'
import { fromFragment, toFragment } from '../lib/pile-link'
import { findEngines } from '../scripts/browser.mjs'
import { inFirefox } from './in-firefox'
import { playgroundStage, test } from './page'

test.use({ permissions: ['clipboard-read', 'clipboard-write'] })

const stage = (page: Page) => page.locator(playgroundStage)

async function copyPile(page: Page) {
  await page.getByRole('button', { name: 'Copy this pile' }).click()
  await expect(page.getByRole('button', { name: 'Copied' })).toBeVisible()
  return page.evaluate(() => navigator.clipboard.readText())
}

/**
 * The address of a pile that fell on an obstacle, was tossed, made narrower, given less gravity and pulled
 * aside, whose obstacle was moved and taken away, and that was pushed under a closed top.
 */
async function makeLink(page: Page) {
  await page.goto('/playground?count=8&shape=mixed&stagger=40&seed=5&obstacle=true&push=44')
  await expect(stage(page)).toHaveAttribute('data-state', 'resting')
  const box = (await stage(page).locator('[data-chip]').last().boundingBox())!
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2)
  await page.mouse.down()
  await page.mouse.move(box.x + 90, box.y - 160, { steps: 12 })
  await page.mouse.up()
  await page.setViewportSize({ width: 700, height: 800 })
  await page.getByRole('slider', { name: 'gravity' }).fill('1200')
  await page.getByRole('slider', { name: 'Direction' }).fill('45')
  await page.getByRole('checkbox', { name: 'ceiling' }).check()
  const obstacle = page.getByRole('button', { name: 'Obstacle' })
  await obstacle.focus()
  await page.keyboard.press('ArrowLeft')
  const held = (await obstacle.boundingBox())!
  await page.mouse.move(held.x + 30, held.y + 10)
  await page.mouse.down()
  await page.mouse.move(held.x + 130, held.y + 90, { steps: 6 })
  await page.mouse.up()
  await expect(stage(page)).toHaveAttribute('data-state', 'resting')
  await page.getByRole('checkbox', { name: 'Obstacle' }).uncheck()
  await stage(page).scrollIntoViewIfNeeded()
  const { x, y, width, height } = (await stage(page).boundingBox())!
  await page.mouse.move(x + width / 2, y + height - 10)
  await page.mouse.move(x + width - 10, y + height - 10, { steps: 20 })
  await expect(stage(page)).toHaveAttribute('data-state', 'resting')
  return copyPile(page)
}

/** What the command says of a link. */
const node = (link: string) =>
  spawnSync(process.execPath, ['node_modules/tsx/dist/cli.mjs', 'bench/replay.ts', link], {
    encoding: 'utf8',
  })

test('the link of a pile plays in Node, in Firefox and on the page itself to the same bits', async ({
  page,
}) => {
  const link = await makeLink(page)
  const record = (await fromFragment(new URL(link).hash))!
  expect(new Set(record.acts.map(([, what]) => what))).toEqual(
    new Set(['clear', 'configure', 'grab', 'move', 'obstacle', 'push', 'release', 'resize']),
  )
  expect(node(link)).toMatchObject({
    status: 0,
    stdout: expect.stringContaining(`${record.hash}: the same pile`),
  })

  await page.goto(link)
  await expect(page.getByText('the same pile to the last bit')).toBeVisible()
  await expect(stage(page)).toHaveAttribute('data-outcome', 'same')
  await page.getByRole('button', { name: 'Drop' }).click()
  await expect(page).toHaveURL(/gravity=1200[^#]*$/)
  await expect(page.getByText('the same pile')).toBeHidden()

  const firefox = findEngines().find(({ name }) => name === 'Firefox')?.path
  if (!firefox) return
  const { outputFiles } = await build({
    stdin: {
      contents: `
        import { createReplay } from './components/lab/recorder'
        import { fromFragment } from './lib/pile-link'
        globalThis.found = fromFragment(${JSON.stringify(new URL(link).hash)}).then((record) => {
          const replay = createReplay(record)
          while (!replay.over) replay.step()
          return replay.pile.world.hash()
        })`,
      resolveDir: process.cwd(),
      loader: 'ts',
    },
    bundle: true,
    format: 'iife',
    write: false,
  })
  const folder = mkdtempSync(join(tmpdir(), 'pile-link-'))
  try {
    expect(await inFirefox(firefox, folder, outputFiles[0].text)).toBe(record.hash)
  } finally {
    rmSync(folder, { recursive: true, force: true, maxRetries: 5 })
  }
})

test('a link that comes out otherwise says so, and one that holds nothing drops a new pile', async ({
  page,
}) => {
  await page.goto('/playground?count=2&stagger=0')
  await expect(stage(page)).toHaveAttribute('data-state', 'resting')
  const link = new URL(await copyPile(page))
  const record = (await fromFragment(link.hash))!
  link.hash = await toFragment({ ...record, version: '0.0.1', hash: 'other' })
  await page.goto(link.href)
  await expect(page.getByText('recorded with version 0.0.1')).toBeVisible()
  expect(node(link.href)).toMatchObject({
    status: 1,
    stdout: expect.stringContaining('not the recorded other'),
  })
  await page.goto('/playground?count=3#pile=nonsense')
  await page.reload()
  await expect(page.getByText('holds no pile that can be played')).toBeVisible()
  await expect(stage(page)).toHaveAttribute('data-state', 'resting')
})

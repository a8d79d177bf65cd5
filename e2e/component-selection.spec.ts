import type { Page } from '@playwright/test'
import { expect, type StagePage, test } from './fixtures/stage'

const WORD = 'design'

/** What a double click in the middle of the first chip selects. */
async function select(stage: StagePage) {
  const { x, y } = await stage.centre(stage.chips.first())
  await stage.page.mouse.dblclick(x, y)
  return stage.page.evaluate(() => `${getSelection()}`.trim())
}

const pause = (page: Page) => page.locator('#pause').evaluate((button: HTMLElement) => button.click())

test('words can be selected in a pile that can’t be grabbed', async ({ stage }) => {
  await stage.settled('pile', { chips: 3, interactive: false })
  expect(await select(stage)).toBe(WORD)
})

test('words can be selected in a pile while it is paused, and not while it can be grabbed', async ({
  stage,
  page,
}) => {
  await stage.settled('extras')
  expect(await select(stage)).toBe('')
  await stage.reaches('resting')
  await pause(page)
  await stage.reaches('paused')
  expect(await select(stage)).toBe(WORD)
})

test('words of a chip’s part that keeps its presses can be selected', async ({ stage, page }) => {
  await stage.settled('surroundings', { kind: 'kept words' })
  for (const word of ['marked', 'editable']) {
    await page.getByText(word).dblclick()
    expect(await page.evaluate(() => `${getSelection()}`.trim())).toBe(word)
  }
  await page.evaluate(() => getSelection()!.removeAllRanges())
  await page.getByText('grabbed').dblclick()
  expect(await page.evaluate(() => `${getSelection()}`.trim())).toBe('')
})

test.describe('with reduced motion', () => {
  test.use({ contextOptions: { reducedMotion: 'reduce' } })

  test('words can be selected in the upright row, before the script has come as well', async ({
    stage,
    page,
  }) => {
    await stage.open('pile', { chips: 3 })
    expect(await select(stage)).toBe(WORD)
    await page.route('**/client-*.js', () => {})
    await page.reload({ waitUntil: 'commit' })
    await expect(stage.root).toHaveCSS('position', 'relative')
    expect(await select(stage)).toBe(WORD)
  })
})

test.describe('without script', () => {
  test.use({ javaScriptEnabled: false })

  test('words can be selected in the upright row', async ({ page }) => {
    await page.goto('/pile?chips=3')
    await expect(page.getByText(WORD)).toHaveCSS('user-select', 'auto')
  })
})

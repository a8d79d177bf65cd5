import { expect, readBar, test } from './fixtures/stage'

// What the browser itself draws in a chip, and has its own presses.

test.use({
  // Playwright hides scroll bars in a browser without a window.
  launchOptions: async ({ launchOptions }, use) => {
    await use({ ...launchOptions, ignoreDefaultArgs: ['--hide-scrollbars'] })
  },
})

test('the scroll bar of a card scrolls the card, which is not held meanwhile; beside its bar the card is', async ({
  stage,
  page,
}) => {
  await stage.settled('surroundings', { kind: 'card' })
  const chip = stage.chips.first()
  const card = chip.locator('> div')
  const [from, to] = await card.evaluate(readBar)
  await page.mouse.move(from.x, from.y)
  await page.mouse.down()
  await page.mouse.move(to.x, to.y, { steps: 5 })
  await expect.poll(() => card.evaluate((element) => element.scrollTop)).toBeGreaterThan(30)
  expect(await stage.states()).not.toContain('held')
  await page.mouse.up()
  await stage.probe((probe) => probe.pass(3))
  expect(await stage.probe((probe) => probe.states.at(-1))).toBe('resting')
  await stage.drag(chip, 10, -60)
  await expect(chip).toHaveAttribute('data-state', 'held')
  await page.mouse.up()
})

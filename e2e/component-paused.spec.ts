import { expect, goTo, test } from './fixtures/stage'

test('pause() freezes the chips in the air, resume() lets them go on', async ({ stage, page }) => {
  await stage.open('extras')
  await expect(stage.chips.nth(3)).toHaveAttribute('data-state', 'falling')
  await page.locator('#pause').click()
  await stage.reaches('paused')
  // Nothing can be grabbed, and no cursor says so.
  await expect(stage.chips.first()).toHaveCSS('cursor', 'auto')
  const { poses } = await stage.pile()
  expect(await stage.during('frames')).toBe(0)
  expect((await stage.pile()).poses).toEqual(poses)
  const { x, y } = await stage.centre(stage.chips.nth(0))
  await page.mouse.move(x, y)
  await page.mouse.down()
  expect(await stage.states()).not.toContain('held')
  await page.mouse.up()
  await page.locator('#resume').click()
  await stage.reaches('resting')
})

test('pause() holds a stage from the start when it is called before anything is seen', async ({ stage }) => {
  await stage.open('surroundings', { kind: 'early' })
  await stage.reaches('paused')
  expect(new Set(await stage.states())).toEqual(new Set(['waiting']))
  expect(await stage.during('frames')).toBe(0)
})

test('drop() lets a paused pile fall', async ({ stage, page }) => {
  await stage.open('extras')
  await expect(stage.chips.nth(1)).toHaveAttribute('data-state', 'falling')
  await page.locator('#pause').click()
  await stage.reaches('paused')
  await page.locator('#drop').click()
  await stage.reaches('running')
  await stage.reaches('resting')
})

test('a tap on a chip of a paused pile is no tap, and moves nothing when the pile goes on', async ({
  stage,
  page,
}) => {
  await stage.settled('extras')
  await page.locator('#pause').click()
  await stage.reaches('paused')
  const { x, y } = await stage.centre(stage.chips.nth(0))
  await page.mouse.click(x, y)
  const before = await stage.probe((probe) => probe.states.length)
  await page.locator('#resume').click()
  await stage.reaches('resting')
  expect(await stage.probe((probe) => probe.states)).toHaveLength(before + 1)
})

test('paused while it has no height, a stage drops its chips when it has one and goes on', async ({
  stage,
  page,
}) => {
  await page.addInitScript(() => {
    addEventListener('DOMContentLoaded', () => {
      const flat = document.createElement('style')
      flat.textContent = '[data-slot=gravity-stack] { height: 0 !important }'
      document.head.append(flat)
      Object.assign(window, { unfold: () => flat.remove() })
    })
  })
  await stage.open('extras')
  await stage.reaches('waiting')
  await page.locator('#pause').click()
  // Its chips may change their size all the same.
  await stage.chips.first().evaluate((chip) => {
    ;(chip.firstElementChild as HTMLElement).style.fontSize = '30px'
    return window.probe.pass(3)
  })
  await page.evaluate('unfold()')
  await stage.reaches('paused')
  expect(new Set(await stage.states())).toEqual(new Set(['waiting']))
  await page.locator('#resume').click()
  await stage.reaches('resting')
  expect(new Set(await stage.states())).toEqual(new Set(['resting']))
})

test('in a paused stage the focus moves no chip that can be seen in the air', async ({ stage, page }) => {
  await stage.open('extras')
  await expect
    .poll(async () => {
      const { poses } = await stage.pile()
      return poses[0].y
    })
    .toBeGreaterThan(40)
  await page.locator('#pause').evaluate((button: HTMLElement) => button.click())
  await stage.reaches('paused')
  const { poses } = await stage.pile()
  await stage.chips.first().evaluate(goTo)
  expect((await stage.pile()).poses[0]).toEqual(poses[0])
})

test('in a stage without height that is paused from the start a chip can have the focus', async ({
  stage,
  page,
}) => {
  await stage.open('surroundings', { kind: 'lowest' })
  await page.getByText('there').focus()
  await expect(page.getByText('there')).toBeFocused()
  await expect.poll(() => stage.probe((probe) => probe.observed.resize)).toBeGreaterThan(1)
  await page.getByText('there').blur()
  await page.getByText('there').focus()
})

test('in a paused stage that gets its height late the chip with the focus comes into view', async ({
  stage,
  page,
}) => {
  await stage.open('surroundings', { kind: 'lowest' })
  const link = page.getByText('there')
  await link.focus()
  await stage.root.evaluate((root) => {
    root.style.height = '240px'
  })
  await stage.reaches('paused')
  await expect(stage.chip('there')).not.toHaveAttribute('data-state', 'waiting')
  const { y } = await stage.centre(stage.chip('there'))
  expect(y).toBeGreaterThan(0)
  expect(y).toBeLessThan(240)
})

test('what waits above a paused stage comes into view when it gets the focus', async ({ stage, page }) => {
  await stage.open('surroundings', { kind: 'links' })
  await expect(stage.chips.first()).toHaveAttribute('data-state', 'falling')
  await page.locator('#pause').click()
  await stage.reaches('paused')
  const late = page.getByText('there', { exact: true })
  await late.focus()
  await expect(late).toBeInViewport({ ratio: 1 })
  await stage.reaches('paused')
})

test('what hangs above a stage paused in mid-fall comes into view when the keyboard goes there', async ({
  stage,
  page,
}) => {
  // By the page itself, from its start: an answer may take longer than the fall into view.
  await page.addInitScript(() => {
    new MutationObserver((_, observer) => {
      if (!document.querySelector('[data-state=falling]')) return
      observer.disconnect()
      document.querySelector<HTMLElement>('#pause')?.click()
    }).observe(document, { subtree: true, attributeFilter: ['data-state'] })
  })
  await stage.open('surroundings', { kind: 'links' })
  await stage.reaches('paused')
  const link = page.getByText('here', { exact: true })
  await expect(link).not.toBeInViewport()
  await page.keyboard.press('Tab')
  await expect(link).toBeFocused()
  await expect(link).toBeInViewport({ ratio: 1 })
  await stage.reaches('paused')
})

test('a field that comes to a paused stage and takes the focus at once is in view', async ({
  stage,
  page,
}) => {
  await stage.settled('surroundings', { kind: 'field' })
  await page.locator('#pause').click()
  await stage.reaches('paused')
  await page.locator('#next').click()
  const field = page.getByLabel('new')
  await expect(field).toBeFocused()
  await expect(field).toBeInViewport({ ratio: 1 })
  await stage.reaches('paused')
})

test('a paused stage that becomes narrower has all its chips inside and apart', async ({ stage, page }) => {
  await stage.settled('surroundings', { kind: 'narrower' })
  await page.locator('#pause').click()
  await stage.reaches('paused')
  await page.locator('#next').click()
  await expect.poll(() => stage.root.evaluate((root) => root.clientWidth)).toBe(160)
  await expect.poll(() => stage.outside()).toBeLessThan(1)
  expect(await stage.overlap()).toBeLessThan(1)
  await stage.reaches('paused')
})

test('a chip that comes to a paused stage moves none of those in mid-fall', async ({ stage, page }) => {
  await stage.open('surroundings', { kind: 'front' })
  await expect(stage.chip('one')).toHaveAttribute('data-state', 'falling')
  await page.locator('#pause').click()
  await stage.reaches('paused')
  const { poses } = await stage.pile()
  await page.locator('#next').click()
  await expect(stage.chips).toHaveCount(4)
  await page.evaluate(() => window.probe.pass(10))
  expect((await stage.pile()).poses.slice(1)).toEqual(poses)
})

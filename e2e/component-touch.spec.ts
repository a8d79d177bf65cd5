import type { CDPSession, Locator, Page } from '@playwright/test'
import { expect, type StagePage, test } from './fixtures/stage'

test.use({ hasTouch: true, viewport: { width: 660, height: 500 } })

class Finger {
  constructor(
    readonly page: Page,
    readonly session: CDPSession,
    public x = 0,
    public y = 0,
  ) {}

  static async on(page: Page) {
    return new Finger(page, await page.context().newCDPSession(page))
  }

  async down(x: number, y: number) {
    Object.assign(this, { x, y })
    await this.session.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [{ x, y }] })
  }

  async by(dx: number, dy: number, steps = 8) {
    for (let i = 0; i < steps; i++) {
      this.x += dx / steps
      this.y += dy / steps
      await this.session.send('Input.dispatchTouchEvent', {
        type: 'touchMove',
        touchPoints: [{ x: this.x, y: this.y }],
      })
      await this.page.evaluate(() => window.probe.pass(1))
    }
  }

  up() {
    return this.session.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] })
  }
}

const scrolled = (page: Page) => page.evaluate(() => scrollY)

async function ready(stage: StagePage, page: Page) {
  await stage.open('pile', { chips: 5, above: 100, below: 1500 })
  await stage.reaches('resting')
  return Finger.on(page)
}

const onto = async (finger: Finger, stage: StagePage, chip: Locator) => {
  const { x, y } = await stage.centre(chip)
  await finger.down(x, y)
}

test('a swipe on the empty stage scrolls the page', async ({ stage, page }) => {
  const finger = await ready(stage, page)
  await finger.down(320, 200)
  await finger.by(0, -150)
  await finger.up()
  await expect.poll(() => scrolled(page)).toBeGreaterThan(80)
})

test('a quick swipe up that starts on a chip scrolls the page and leaves the chip', async ({
  stage,
  page,
}) => {
  const finger = await ready(stage, page)
  const { poses } = await stage.pile()
  const { x, y } = await stage.centre(stage.chips.nth(1))
  // In one go: a finger that rests for a moment holds.
  await Promise.all([finger.down(x, y), finger.by(0, -150)])
  await finger.up()
  await expect.poll(() => scrolled(page)).toBeGreaterThan(80)
  expect(await stage.states()).not.toContain('held')
  expect((await stage.pile()).poses).toEqual(poses)
})

test('a finger that sets out sideways takes the chip along, then in any direction', async ({
  stage,
  page,
}) => {
  const finger = await ready(stage, page)
  const chip = stage.chips.nth(1)
  await onto(finger, stage, chip)
  await finger.by(40, 0)
  await expect(chip).toHaveAttribute('data-state', 'held')
  await finger.by(0, -120)
  await expect(chip).toHaveAttribute('data-state', 'held')
  await stage.hangs(chip)
  expect(Math.abs((await stage.centre(chip)).y - finger.y)).toBeLessThan(40)
  expect(await scrolled(page)).toBe(0)
  await finger.up()
  await expect(chip).not.toHaveAttribute('data-state', 'held')
  await stage.reaches('resting')
})

test('a finger that rests on a chip for a moment holds it; then it can be lifted straight up', async ({
  stage,
  page,
}) => {
  const finger = await ready(stage, page)
  const chip = stage.chips.nth(1)
  await onto(finger, stage, chip)
  await expect(chip).toHaveAttribute('data-state', 'held')
  await finger.by(0, -150)
  await expect(chip).toHaveAttribute('data-state', 'held')
  await stage.hangs(chip)
  expect(Math.abs((await stage.centre(chip)).y - finger.y)).toBeLessThan(40)
  expect(await scrolled(page)).toBe(0)
  await finger.up()
  await stage.reaches('resting')
})

test('a finger that carries a chip presses nothing in it', async ({ stage, page }) => {
  const finger = await ready(stage, page)
  const chip = stage.chips.first()
  const heard = await chip.evaluateHandle((wrapper) => {
    const types: string[] = []
    for (const type of ['pointerup', 'click'])
      wrapper.firstElementChild!.addEventListener(type, () => types.push(type))
    return types
  })
  await onto(finger, stage, chip)
  await finger.by(60, 0)
  await expect(chip).toHaveAttribute('data-state', 'held')
  await finger.by(0, -60)
  await finger.up()
  await stage.reaches('resting')
  expect(await heard.jsonValue()).toEqual([])
})

test('a finger keeps the chip whose content is replaced under it', async ({ stage, page }) => {
  await stage.settled('surroundings', { kind: 'swaps' })
  const finger = await Finger.on(page)
  const chip = stage.chips.first()
  await onto(finger, stage, chip)
  await expect(chip).toHaveText('pressed')
  await expect(chip).toHaveAttribute('data-state', 'held')
  await finger.by(0, -100, 12)
  await expect(chip).toHaveAttribute('data-state', 'held')
  await stage.hangs(chip)
  expect(await scrolled(page)).toBe(0)
  await finger.up()
  await stage.reaches('resting')
})

test('after a finger has carried a chip, a tap on a label outside the stage counts', async ({
  stage,
  page,
}) => {
  await stage.settled('surroundings', { kind: 'labelled' })
  const finger = await Finger.on(page)
  await onto(finger, stage, stage.chip('one'))
  await finger.by(60, 0)
  await expect(stage.chip('one')).toHaveAttribute('data-state', 'held')
  await finger.up()
  await stage.reaches('resting')
  await page.getByText('label').tap()
  await expect(page.locator('#box')).toBeChecked()
})

test('a tap with a finger makes a chip hop and follows a link', async ({ stage, page }) => {
  await stage.settled('controls')
  await page.touchscreen.tap(...(Object.values(await stage.centre(stage.chip('plain'))) as [number, number]))
  await expect(stage.chip('plain')).toHaveAttribute('data-state', 'falling')
  await page.touchscreen.tap(
    ...(Object.values(await stage.centre(stage.chip('Read the docs'))) as [number, number]),
  )
  await expect(page).toHaveURL(/#link$/)
  await stage.reaches('resting')
})

test('two fingers hold two chips, one after the other', async ({ stage, page }) => {
  const { session } = await ready(stage, page)
  const [first, second] = [stage.chips.nth(1), stage.chips.nth(2)]
  const points = [{ ...(await stage.centre(first)), id: 0 }]
  await session.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: points })
  await expect(first).toHaveAttribute('data-state', 'held')
  points.push({ ...(await stage.centre(second)), id: 1 })
  await session.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: points })
  await expect(second).toHaveAttribute('data-state', 'held')
  await expect(first).toHaveAttribute('data-state', 'held')
  await session.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] })
  await stage.reaches('resting')
})

const zoom = (page: Page) => page.evaluate(() => visualViewport!.scale)

// The stage lies from 100 to 440 px of the page.
for (const [where, second, rest] of [
  ['both on a chip', undefined, false],
  ['both on a chip, after a moment of rest', undefined, true],
  ['one on a chip and one on the empty stage', 200, true],
  ['one on a chip and one outside the stage', 50, true],
] as const) {
  test(`two fingers that spread zoom the page and leave the pile: ${where}`, async ({ stage, page }) => {
    const { session } = await ready(stage, page)
    const { poses } = await stage.pile()
    const { x, y } = await stage.centre(stage.chips.nth(1))
    const fingers = (count: number, spread = 0) =>
      [
        { x: x - 8 - spread, y, id: 0 },
        { x: x + 8 + spread, y: second ?? y, id: 1 },
      ].slice(0, count)
    // In one go: a finger that rests alone for a moment holds.
    await Promise.all(
      [1, 2].map((count) =>
        session.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: fingers(count) }),
      ),
    )
    // Longer than a finger has to rest on a chip to hold it.
    if (rest) await page.evaluate(() => window.probe.pass(20))
    for (let spread = 6; spread <= 120; spread += 6) {
      await session.send('Input.dispatchTouchEvent', {
        type: 'touchMove',
        touchPoints: fingers(2, spread),
      })
      await page.evaluate(() => window.probe.pass(1))
    }
    expect(await stage.states()).not.toContain('held')
    await session.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] })
    await expect.poll(() => zoom(page)).toBeGreaterThan(1.5)
    expect((await stage.pile()).poses).toEqual(poses)
  })
}

test('the wheel scrolls the page over the empty stage, over a chip and while a chip is held; with Ctrl it zooms', async ({
  stage,
  page,
}) => {
  await ready(stage, page)
  await page.mouse.move(320, 110)
  await page.mouse.wheel(0, 40)
  await expect.poll(() => scrolled(page)).toBe(40)
  const chip = stage.chips.nth(1)
  const { x, y } = await stage.centre(chip)
  await page.mouse.move(x, y)
  await page.mouse.wheel(0, 40)
  await expect.poll(() => scrolled(page)).toBe(80)
  await page.mouse.move(x, y - 40)
  await page.mouse.down()
  await expect(chip).toHaveAttribute('data-state', 'held')
  await page.mouse.wheel(0, 40)
  await expect.poll(() => scrolled(page)).toBe(120)
  await page.mouse.up()
  await stage.reaches('resting')
  // A trackpad's pinch comes as a wheel with Ctrl, which zooms unless somebody prevents it.
  const left = page.evaluate(
    () =>
      new Promise((resolve) => {
        addEventListener('wheel', ({ ctrlKey, defaultPrevented }) => resolve({ ctrlKey, defaultPrevented }))
      }),
  )
  const at = await stage.centre(chip)
  await page.mouse.move(at.x, at.y)
  await page.keyboard.down('Control')
  await page.mouse.wheel(0, -40)
  expect(await left).toEqual({ ctrlKey: true, defaultPrevented: false })
  await page.keyboard.up('Control')
})

test('sideways gestures are left to the browser but for drags on a chip', async ({ stage, page }) => {
  await ready(stage, page)
  expect(await stage.root.evaluate((root) => getComputedStyle(root).touchAction)).toBe('auto')
  expect(await stage.chips.first().evaluate((chip) => getComputedStyle(chip).touchAction)).toBe(
    'pan-y pinch-zoom',
  )
  expect(await stage.probe((probe) => probe.listeners.wheel ?? 0)).toBe(0)
})

test('a button beside the stage hears its click, though a finger lets go of a chip while it is down', async ({
  stage,
  page,
}) => {
  const finger = await ready(stage, page)
  await stage.root.evaluate((root) => {
    const button = document.createElement('button')
    button.style.cssText = 'position: fixed; inset: 0 auto auto 0; width: 60px; height: 60px'
    button.onclick = () => button.append('clicked')
    root.before(button)
  })
  const chip = stage.chips.first()
  await onto(finger, stage, chip)
  await finger.by(60, 0)
  await expect(chip).toHaveAttribute('data-state', 'held')
  await page.mouse.move(30, 30)
  await page.mouse.down()
  await finger.up()
  await expect(chip).not.toHaveAttribute('data-state', 'held')
  await page.mouse.up()
  await expect(page.getByRole('button')).toHaveText('clicked')
})

test('a finger that swipes over a paused stage is the browser’s, whichever way it goes', async ({
  stage,
  page,
}) => {
  await stage.settled('extras')
  await expect(stage.chips.first()).toHaveCSS('touch-action', 'pan-y pinch-zoom')
  await page.locator('#pause').click()
  await stage.reaches('paused')
  await expect(stage.chips.first()).toHaveCSS('touch-action', 'auto')
})

test.describe('with fingers', () => {
  test.use({ hasTouch: true, viewport: { width: 660, height: 500 } })

  test('a second finger that moves on the empty stage takes no chip from the first', async ({
    stage,
    page,
  }) => {
    await stage.settled('pile', { chips: 5, above: 100, below: 1500 })
    const session = await page.context().newCDPSession(page)
    const chip = stage.chips.nth(1)
    const first = { ...(await stage.centre(chip)), id: 0 }
    const send = (type: 'touchStart' | 'touchMove', ...touchPoints: { x: number; y: number; id: number }[]) =>
      session.send('Input.dispatchTouchEvent', { type, touchPoints })
    await send('touchStart', first)
    await expect(chip).toHaveAttribute('data-state', 'held')
    await send('touchStart', first, { x: 320, y: 300, id: 1 })
    for (let y = 290; y >= 150; y -= 10) {
      await send('touchMove', first, { x: 320, y, id: 1 })
      await page.evaluate(() => window.probe.pass(1))
    }
    await expect(chip).toHaveAttribute('data-state', 'held')
    expect(await page.evaluate(() => [scrollY, visualViewport!.scale])).toEqual([0, 1])
    await session.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] })
    await stage.reaches('resting')
  })
})

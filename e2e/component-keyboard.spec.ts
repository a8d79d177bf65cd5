import type { Page } from '@playwright/test'
import { expect, type StagePage, test } from './fixtures/stage'

const focused = () => document.activeElement!.textContent || document.activeElement!.tagName

test('only the chips’ own controls are tab stops, in reading order', async ({ stage, page }) => {
  await stage.settled('controls')
  await page.getByText('before').focus()
  const order: string[] = []
  for (let i = 0; i < 5; i++) {
    await page.keyboard.press('Tab')
    order.push(await page.evaluate(focused))
  }
  expect(order).toEqual(['Read the docs', 'a button', 'inner', 'INPUT', 'after'])
})

test('focus brings a chip to the front and never scrolls the pile out of its place', async ({
  stage,
  page,
}) => {
  await stage.settled('controls')
  const { poses } = await stage.pile()
  await page.getByText('before').focus()
  for (let i = 1; i <= 4; i++) {
    await page.keyboard.press('Tab')
    const levels = await stage.chips.evaluateAll((all) =>
      all.map((chip) => Number(getComputedStyle(chip).zIndex) || 0),
    )
    expect(levels.indexOf(Math.max(...levels))).toBe(i - 1)
  }
  expect(await stage.root.evaluate((root) => [root.scrollTop, root.scrollLeft])).toEqual([0, 0])
  expect((await stage.pile()).poses).toEqual(poses)
})

for (const [given, rule] of [
  ['style', 'overflow: hidden'],
  ['style', 'overflow: scroll'],
  ['rule of the page', 'overflow: auto !important'],
] as const) {
  test(`nothing in a stage scrolls, though a ${given} says "${rule}"`, async ({ stage, page }) => {
    await stage.open('controls')
    if (given === 'style') await stage.root.evaluate((root, rule) => root.setAttribute('style', rule), rule)
    else await page.addStyleTag({ content: `[data-slot=gravity-stack] { ${rule} }` })
    await stage.reaches('resting')
    const drawn = () =>
      stage.root.evaluate((root) => [
        root.clientWidth,
        ...Array.from(root.children, (chip) => chip.getBoundingClientRect().y),
      ])
    const before = await drawn()
    expect(before[0]).toBe(640)
    await page.getByText('before').focus()
    for (let i = 1; i <= 4; i++) await page.keyboard.press('Tab')
    for (const chip of await stage.chips.all())
      await chip.evaluate((element) => element.scrollIntoView({ block: 'start' }))
    await stage.root.evaluate((root) => {
      root.scrollTop = 100
      root.scrollLeft = 100
    })
    await stage.chips.first().hover()
    await page.mouse.wheel(0, 30)
    await stage.probe((probe) => probe.pass(3))
    await page.evaluate(() => scrollTo(0, 0))
    expect(await drawn()).toEqual(before)
  })
}

test('a control is pressed from the keyboard while its chip lies in the pile', async ({ stage, page }) => {
  await stage.settled('controls')
  await page.getByText('a button').focus()
  await page.keyboard.press('Space')
  await page.getByText('Read the docs').focus()
  await page.keyboard.press('Enter')
  await expect(page.locator('output')).toHaveText('click button, click link')
})

test('focus that lands on a chip still waiting brings it in at once', async ({ stage, page }) => {
  await page.setViewportSize({ width: 800, height: 600 })
  await stage.open('controls', { above: 500, stagger: 60000 })
  await stage.reaches('waiting')
  await page.getByText('a button').focus()
  await expect(stage.chip('a button')).toHaveAttribute('data-state', /falling|resting/)
  await stage.reaches('running')
  await expect(stage.chip('a button')).toHaveAttribute('data-state', 'resting')
  await expect(page.getByText('a button')).toBeInViewport()
})

test('focus that jumps into a stage far down the page brings the stage into view and its chips down', async ({
  stage,
  page,
}) => {
  await page.setViewportSize({ width: 800, height: 600 })
  await stage.open('controls', { above: 3000 })
  await page.getByText('a button').focus()
  await expect(stage.chip('a button')).toHaveAttribute('data-state', 'resting')
  await expect(page.getByText('a button')).toBeInViewport()
})

test('the Tab key on the way into a stage just below the window brings the stage into view', async ({
  stage,
  page,
}) => {
  await page.setViewportSize({ width: 800, height: 600 })
  for (const above of [600, 640, 680]) {
    await stage.open('controls', { above })
    await page.getByText('before').focus()
    await page.keyboard.press('Tab')
    await expect(page.getByText('Read the docs')).toBeFocused()
    await expect(stage.chip('Read the docs')).toHaveAttribute('data-state', 'resting')
    await expect(page.getByText('Read the docs')).toBeInViewport()
  }
})

test('focus on a chip that is falling is in view when it lies, though the floor was below the window', async ({
  stage,
  page,
}) => {
  await page.setViewportSize({ width: 800, height: 600 })
  await stage.open('controls', { above: 400, stagger: 0 })
  await expect(stage.chip('a button')).toHaveAttribute('data-state', 'falling')
  await page.getByText('before').focus()
  await page.keyboard.press('Tab')
  await expect(page.getByText('Read the docs')).toBeFocused()
  await stage.reaches('resting')
  await expect(page.getByText('Read the docs')).toBeInViewport({ ratio: 0.9 })
})

/** A stage taller than the window, its first chips in the air. */
async function tall(stage: StagePage, page: Page) {
  await page.setViewportSize({ width: 800, height: 600 })
  await stage.open('controls', { box: 'h-[1100px] w-[640px]', stagger: 60_000 })
  await stage.reaches('running')
}

test('focus on a chip of a stage taller than the window is in view when the chip lies', async ({
  stage,
  page,
}) => {
  await tall(stage, page)
  await page.getByText('a button').focus()
  await expect(stage.chip('a button')).toHaveAttribute('data-state', 'resting')
  await expect(page.getByText('a button')).toBeInViewport({ ratio: 0.9 })
})

for (const [what, act] of [
  ['scrolls on', (page: Page) => page.mouse.wheel(0, 30)],
  [
    'scrolls on by a key',
    (page: Page) =>
      page.evaluate(() => {
        document.activeElement!.dispatchEvent(new KeyboardEvent('keydown', { bubbles: true, key: 'PageUp' }))
      }),
  ],
  [
    'scrolls on with a finger',
    (page: Page) =>
      page.evaluate(() => {
        document.body.dispatchEvent(new TouchEvent('touchmove', { bubbles: true }))
      }),
  ],
  [
    'goes elsewhere with the focus',
    (page: Page) => page.evaluate(() => document.querySelector('a')!.focus({ preventScroll: true })),
  ],
] as const) {
  test(`whoever ${what} while the chip with the focus falls is not brought back to it`, async ({
    stage,
    page,
  }) => {
    await tall(stage, page)
    await page.mouse.move(700, 100)
    await page.getByText('a button').focus()
    const before = await page.evaluate(() => scrollY)
    await expect(stage.chip('a button')).toHaveAttribute('data-state', 'falling')
    await act(page)
    const there = before + (what === 'scrolls on' ? 30 : 0)
    await expect.poll(() => page.evaluate(() => scrollY)).toBe(there)
    await expect(stage.chip('a button')).toHaveAttribute('data-state', 'resting')
    await stage.probe((probe) => probe.pass(3))
    expect(await page.evaluate(() => scrollY)).toBe(there)
  })
}

for (const [pressed, selector, interactive] of [
  ['a press on a control that falls', '[data-name=button]', true],
  ['a press on a control that falls and cannot be grabbed', '[data-name=button]', false],
  ['a press on a field that falls', 'input', true],
] as const) {
  test(`${pressed} gives it the focus and does not scroll the page`, async ({ stage, page }) => {
    await page.setViewportSize({ width: 800, height: 600 })
    // Its time is the test's own, so that it is where it was aimed at.
    await page.clock.install({ time: 0 })
    await page.clock.pauseAt(1000)
    await stage.open('controls', { above: 400, stagger: 0, interactive })
    const control = page.locator(selector)
    const chip = stage.chips.filter({ has: control })
    await expect
      .poll(
        async () => {
          await page.clock.runFor(20)
          const falling = (await chip.getAttribute('data-state')) === 'falling'
          return falling && (await stage.centre(control)).y > 440
        },
        { intervals: [0] },
      )
      .toBe(true)
    const { x, y } = await stage.centre(control)
    await page.mouse.click(x, y)
    await expect(control).toBeFocused()
    await page.clock.resume()
    await stage.reaches('resting')
    expect(await page.evaluate(() => scrollY)).toBe(0)
  })
}

test('who has the focus when reduced motion is switched off waits for no turn', async ({ stage, page }) => {
  await page.emulateMedia({ reducedMotion: 'no-preference' })
  await stage.open('controls', { stagger: 60_000 })
  await stage.reaches('running')
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await stage.reaches('static')
  await page.getByText('a button').focus()
  await page.emulateMedia({ reducedMotion: 'no-preference' })
  await expect(stage.chip('a button')).toHaveAttribute('data-state', 'resting')
  await expect(page.getByText('a button')).toBeInViewport()
})

test('the order in which a screen reader reads is the order of the children, falling or piled', async ({
  stage,
}) => {
  await stage.open('pile', { chips: 6 })
  const words = ['design', 'tokens', 'motion', 'springs', 'layout', 'colour']
  expect(await stage.chips.allInnerTexts()).toEqual(words)
  await stage.reaches('resting')
  expect(await stage.chips.allInnerTexts()).toEqual(words)
  await expect(stage.root).toMatchAriaSnapshot(`- text: ${words.join(' ')}`)
})

test('nothing is announced as the chips fall', async ({ stage, page }) => {
  const loud = page.locator(':is([aria-live], [role=status], [role=alert], [role=log])')
  const heard = stage.root.and(loud).or(stage.root.locator(loud))
  await stage.open('pile', { chips: 6 })
  await stage.reaches('running')
  await expect(heard).toHaveCount(0)
  await stage.reaches('resting')
  await expect(heard).toHaveCount(0)
})

test('who closes a dialog that a button in a chip has opened is not scrolled anywhere', async ({
  stage,
  page,
}) => {
  await page.setViewportSize({ width: 800, height: 600 })
  await stage.settled('controls', { above: 400, box: 'h-[500px] w-[640px]' })
  await page.evaluate(() => {
    document.body.style.paddingBottom = '2000px'
    scrollTo(0, 550)
    const dialog = document.body.appendChild(document.createElement('dialog'))
    document.querySelector('[data-name=button]')!.addEventListener('click', () => dialog.showModal())
  })
  // The press takes the chip up, so that it falls as the dialog opens.
  await page.getByText('a button').click()
  await expect(stage.chip('a button')).toHaveAttribute('data-state', 'falling')
  await page.keyboard.press('Escape')
  await expect(page.getByText('a button')).toBeFocused()
  await stage.probe((probe) => probe.pass(3))
  expect(await page.evaluate(() => scrollY)).toBe(550)
})

test('a field that comes with the focus is in view when it lies', async ({ stage, page }) => {
  await page.setViewportSize({ width: 800, height: 320 })
  await stage.settled('surroundings', { kind: 'field' })
  await page.evaluate(() => {
    document.querySelector('main')!.style.paddingTop = '160px'
    scrollTo(0, 0)
  })
  await page.locator('#next').evaluate((button: HTMLElement) => button.click())
  await expect(page.getByLabel('new')).toBeFocused()
  await stage.reaches('running')
  await stage.reaches('resting')
  await expect(page.getByLabel('new')).toBeInViewport({ ratio: 0.9 })
})

test('focus lets in a chip far back in the row at once, also in a stage that nobody has seen', async ({
  stage,
  page,
}) => {
  await page.setViewportSize({ width: 800, height: 600 })
  await stage.open('controls', { above: 3000, stagger: 60000 })
  await page.getByText('inner', { exact: true }).focus()
  const chip = stage.chips.filter({ hasText: 'inner' })
  await expect(chip).toHaveAttribute('data-state', 'resting')
  await expect(page.getByText('inner', { exact: true })).toBeInViewport()
})

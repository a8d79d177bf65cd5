import type { Locator } from '@playwright/test'
import { expect, test } from './fixtures/stage'
import { keepWaits, letTimePass } from './fixtures/time'

const scaleOf = (chip: Locator) =>
  chip.evaluate((element) => {
    const m = new DOMMatrix(getComputedStyle(element).transform)
    return Math.hypot(m.a, m.b)
  })

test('clicks that miss a chip, as when it has hopped away, select no words of the page', async ({
  stage,
  page,
}) => {
  await stage.settled('pile', { chips: 3 })
  await stage.root.evaluate((root) =>
    root.after(Object.assign(document.createElement('p'), { textContent: 'words after the stage' })),
  )
  const { x, y } = (await stage.root.boundingBox())!
  await page.mouse.click(x + 300, y + 40, { clickCount: 3 })
  expect(await page.evaluate(() => `${getSelection()}`)).toBe('')
  await page.getByText('words after').click({ clickCount: 3 })
  expect(await page.evaluate(() => `${getSelection()}`)).toContain('words after')
})

test('words too long for a stage of fractional width lie still in it, not wedged between its walls', async ({
  stage,
}) => {
  await stage.settled('pile', { chips: 8 })
  await stage.root.evaluate((root) => {
    root.style.width = '343.4px'
    root.querySelector('[data-slot=gravity-stack-chip]')!.firstElementChild!.textContent = 'words '.repeat(30)
  })
  const width = () => stage.chips.first().evaluate((chip) => Number.parseFloat(getComputedStyle(chip).width))
  await expect.poll(width).toBeGreaterThan(340)
  expect(await width()).toBeLessThan(343)
  // Its stage hears of it with the next frame.
  await stage.probe((probe) => probe.pass(3))
  await stage.reaches('resting')
  expect(await stage.outside()).toBeLessThan(0.05)
  // Two chips that lean are each drawn to a tenth of a pixel: how exactly they lie apart is asked of the world.
  expect(await stage.overlap()).toBeLessThan(0.25)
})

test('corners that a rule of the page squares by and by are square once they are drawn so', async ({
  stage,
  page,
}) => {
  await stage.settled('children')
  await page.addStyleTag({
    content: '.sharp [data-slot=gravity-stack-chip] > * { border-radius: 0; transition: border-radius 0.1s }',
  })
  await page.evaluate(() => document.body.classList.add('sharp'))
  await expect(stage.chip('three')).toHaveCSS('border-radius', '0px')
  await expect.poll(() => stage.overlap()).toBeLessThan(1)
  await stage.reaches('resting')
})

test('words alone that a rule of the page makes round stay round as they grow', async ({ stage, page }) => {
  await stage.settled('children')
  const chip = stage.chip('text')
  await page.addStyleTag({ content: '[data-slot=gravity-stack-chip] { border-radius: 50% }' })
  /** How far their corners are from half of their height, px. */
  const off = () =>
    chip.evaluate((element: HTMLElement) =>
      Math.abs(element.offsetHeight / 2 - Number.parseFloat(element.style.borderRadius)),
    )
  for (const size of [30, 50]) {
    await chip.evaluate((element, size) => {
      element.style.fontSize = `${size}px`
    }, size)
    await expect.poll(off).toBeLessThan(0.6)
  }
  await stage.reaches('resting')
})

test('beside a chip that has become round, in the corner of its box, nothing is pressed any more', async ({
  stage,
}) => {
  await stage.settled('pile', { chips: 1, shape: 'box' })
  /** What is pressed 2 px inside the lower right corner of its box. */
  const pressed = () =>
    stage.chips.first().evaluate((chip: HTMLElement) => {
      const { x, y, width, height } = chip.getBoundingClientRect()
      const turn = new DOMMatrix(getComputedStyle(chip).transform)
      turn.e = x + width / 2
      turn.f = y + height / 2
      const at = turn.transformPoint({ x: chip.offsetWidth / 2 - 2, y: chip.offsetHeight / 2 - 2 })
      return document.elementFromPoint(at.x, at.y)?.closest('[data-slot]')?.getAttribute('data-slot')
    })
  expect(await pressed()).toBe('gravity-stack-chip')
  await stage.chips.first().evaluate((chip) => {
    const face = chip.firstElementChild as HTMLElement
    face.style.borderRadius = '99px'
  })
  await expect.poll(pressed).toBe('gravity-stack')
})

test('a control that is pressed and let go where it lies has its own size again', async ({ stage, page }) => {
  await stage.settled('controls')
  const chip = stage.chip('a button')
  const { x, y } = await stage.centre(chip)
  await page.mouse.move(x, y)
  await page.mouse.down()
  await expect(chip).toHaveAttribute('data-state', 'held')
  expect(await scaleOf(chip)).toBeCloseTo(0.97, 3)
  await page.mouse.up()
  await stage.reaches('resting')
  expect(await scaleOf(chip)).toBeCloseTo(1, 3)
})

test('a chip falls when the first button goes up, though another is still down', async ({ stage, page }) => {
  await stage.settled('pile', { chips: 3 })
  const chip = stage.chips.first()
  await stage.drag(chip, 0, -60)
  await page.mouse.down({ button: 'right' })
  await page.mouse.up()
  await expect(chip).not.toHaveAttribute('data-state', 'held')
  await page.mouse.up({ button: 'right' })
  await stage.reaches('resting')
})

test('a chip whose release nobody heard falls when the same pointer presses another', async ({ stage }) => {
  await stage.settled('pile', { chips: 3 })
  const press = (n: number) =>
    stage.chips.nth(n).evaluate((chip) => {
      const { x, y, width, height } = chip.getBoundingClientRect()
      const at = { clientX: x + width / 2, clientY: y + height / 2 }
      chip.dispatchEvent(new PointerEvent('pointerdown', { ...at, pointerId: 1, bubbles: true }))
    })
  await press(0)
  await press(1)
  expect(await stage.states()).toEqual(['falling', 'held', 'resting'])
})

test('a stage whose `interactive` changes before anyone has seen it drops as ever', async ({
  stage,
  page,
}) => {
  await page.addInitScript(() =>
    addEventListener('DOMContentLoaded', () => {
      document.body.style.paddingTop = '3000px'
    }),
  )
  await stage.open('extras')
  await page.waitForFunction(() => window.kept?.length)
  await page.locator('#still').evaluate((button: HTMLElement) => button.click())
  await page.evaluate(() => scrollTo(0, 3000))
  await stage.reaches('running')
  await stage.reaches('resting')
})

test('drop() takes a chip out of the hand', async ({ stage, page }) => {
  await stage.settled('extras')
  const chip = stage.chips.first()
  await stage.drag(chip, 0, -60)
  await page.locator('#drop').evaluate((button: HTMLElement) => button.click())
  await stage.reaches('resting')
  expect(await scaleOf(chip)).toBeCloseTo(1, 3)
  await page.mouse.up()
})

test('a child that has gone is watched no more', async ({ stage, page }) => {
  await stage.settled('children')
  const watched = () => stage.probe((probe) => probe.observed.resize)
  expect(await watched()).toBe(12)
  await page.evaluate(() => window.remove('three'))
  await expect(stage.chips).toHaveCount(10)
  await expect.poll(watched).toBe(11)
})

test('what others put into the stage stays as they made it', async ({ stage }) => {
  await stage.settled('pile', { chips: 3 })
  const seen = await stage.root.evaluate(async (root) => {
    const other = root.appendChild(document.createElement('div'))
    other.style.cssText = 'position: absolute; width: 50px; height: 20px'
    const before = other.outerHTML
    await window.probe.pass(10)
    return other.outerHTML === before
  })
  expect(seen).toBe(true)
  await stage.reaches('resting')
})

test.describe('with reduced motion', () => {
  test.use({ contextOptions: { reducedMotion: 'reduce' } })
  test('no hand and no touch in the row says that it can be grabbed', async ({ stage }) => {
    await stage.open('pile')
    await expect.poll(() => stage.probe((probe) => probe.observed.intersection)).toBe(1)
    await expect(stage.chips.first()).toHaveCSS('cursor', 'auto')
    await expect(stage.chips.first()).toHaveCSS('touch-action', 'auto')
  })

  test('a chip of the row that has had the focus covers nothing that lies over the stage', async ({
    stage,
    page,
  }) => {
    await stage.open('controls')
    await stage.root.evaluate((root) => {
      const bar = document.createElement('nav')
      bar.style.cssText = 'position: fixed; inset: 0; z-index: 1; pointer-events: auto'
      root.parentElement!.before(bar)
    })
    await page.getByText('a button').focus()
    const on = await page.getByText('a button').evaluate((button) => {
      const { x, y } = button.getBoundingClientRect()
      return document.elementFromPoint(x + 5, y + 5)?.tagName
    })
    expect(on).toBe('NAV')
  })
})

test('a chip of many words is no wider than the stage', async ({ stage }) => {
  await stage.settled('pile', { chips: 2 })
  await stage.chips.first().evaluate((chip) => {
    chip.firstElementChild!.textContent = 'word '.repeat(60)
  })
  await expect.poll(async () => (await stage.pile()).shapes[0].height).toBeGreaterThan(60)
  expect((await stage.pile()).shapes[0].width).toBeLessThanOrEqual(640)
})

test('chips that come seconds apart come one at a time', async ({ stage }) => {
  await stage.page.addInitScript(() => {
    const fell: number[] = []
    Object.assign(window, { fell })
    new MutationObserver((records) => {
      for (const { target, oldValue } of records)
        if (oldValue === 'waiting' && (target as HTMLElement).dataset.slot === 'gravity-stack-chip')
          fell.push(performance.now())
    }).observe(document, { subtree: true, attributeFilter: ['data-state'], attributeOldValue: true })
  })
  await stage.open('pile', { chips: 3, stagger: 4000 })
  await expect(stage.chips.nth(2)).not.toHaveAttribute('data-state', 'waiting')
  const fell = await stage.page.evaluate(() => (window as unknown as { fell: number[] }).fell)
  // Far from at once, on the slowest machine too.
  expect(fell[2] - fell[1]).toBeGreaterThan(2000)
})

test('a stage that goes just as a finger comes down on it leaves no timer behind', async ({ stage }) => {
  await stage.settled('mounts')
  await stage.chips.first().evaluate((chip) => {
    const { x, y, width, height } = chip.getBoundingClientRect()
    const at = { clientX: x + width / 2, clientY: y + height / 2 }
    chip.dispatchEvent(new PointerEvent('pointerdown', { ...at, pointerType: 'touch', bubbles: true }))
    document.querySelector<HTMLElement>('#toggle')!.click()
  })
  await stage.isGone()
  expect(await stage.probe((probe) => probe.timers)).toBe(0)
})

test('a stage that was scaled to nothing and goes leaves no timer behind', async ({ stage, page }) => {
  await stage.settled('mounts')
  const toggle = () => page.locator('#toggle').evaluate((button: HTMLElement) => button.click())
  await toggle()
  await page.locator('main').evaluate((main) => {
    main.style.transform = 'scale(0)'
  })
  await toggle()
  await stage.reaches('waiting')
  await expect.poll(() => stage.probe((probe) => probe.timers)).toBe(1)
  await toggle()
  await expect(stage.root).toHaveCount(0)
  await stage.probe((probe) => probe.pass(30))
  await stage.isGone()
})

test('who goes to a chip by the keyboard does not hold back the chips to come', async ({ stage, page }) => {
  await letTimePass(page)
  await keepWaits(page, 5000)
  await stage.open('controls', { stagger: 60_000 })
  await expect(stage.chips.first()).toHaveAttribute('data-state', 'resting')
  await page.evaluate(() => {
    window.passed = 20_000
  })
  await page.getByText('a button').focus()
  await expect(stage.chip('a button')).toHaveAttribute('data-state', 'resting')
  await stage.probe((probe) => probe.pass(3))
  // ms from now to the third, which comes 120 s after the first.
  expect(await page.evaluate(() => window.waits.at(-1))).toBeLessThan(105_000)
})

test('drop() and another stagger at once let the first chip fall at once', async ({ stage, page }) => {
  await keepWaits(page, 1000)
  await stage.settled('extras', { stagger: 500 })
  await page.evaluate(() => {
    for (const id of ['drop', 'pace']) document.getElementById(id)!.click()
  })
  await expect(stage.chips.first()).toHaveAttribute('data-state', 'falling')
  expect(await page.evaluate(() => window.waits)).toEqual([])
})

test('in a shadow tree that nobody sees into a drag is a click to nobody either', async ({ page }) => {
  await page.goto('/surroundings?kind=closed')
  const state = () =>
    page.evaluate(
      () =>
        (window as unknown as { inside?: ShadowRoot }).inside?.querySelector<HTMLElement>(
          '[data-slot=gravity-stack]',
        )?.dataset.state,
    )
  await expect.poll(state).toBe('resting')
  const { x, y } = await page.evaluate(() => {
    const link = (window as unknown as { inside: ShadowRoot }).inside.querySelector('a')!
    const box = link.getBoundingClientRect()
    return { x: box.x + box.width / 2, y: box.y + box.height / 2 }
  })
  const clicks = await page.evaluateHandle(() => {
    const heard: string[] = []
    const { inside } = window as unknown as { inside: ShadowRoot }
    inside.addEventListener('click', ({ type }) => heard.push(type))
    return heard
  })
  await page.mouse.move(x, y)
  await page.mouse.down()
  await page.mouse.move(x + 40, y - 60, { steps: 8 })
  await page.mouse.up()
  await expect.poll(state).toBe('resting')
  expect(await clicks.jsonValue()).toEqual([])
  await expect(page).not.toHaveURL(/#there$/)
  // Nor to the stage: a word let go where it hangs falls, it doesn't hop.
  const word = await page.evaluateHandle(
    () => (window as unknown as { inside: ShadowRoot }).inside.querySelector('span')!,
  )
  const top = () => word.evaluate((element) => element.getBoundingClientRect().y)
  const box = (await word.boundingBox())!
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2)
  await page.mouse.down()
  await page.mouse.move(box.x + box.width / 2, box.y - 60, { steps: 8 })
  let hung = Number.NaN
  await expect
    .poll(async () => {
      const before = hung
      hung = await top()
      return Math.abs(hung - before)
    })
    .toBeLessThan(0.5)
  const highest = word.evaluate(async (element) => {
    let top = Number.POSITIVE_INFINITY
    const stage = element.closest<HTMLElement>('[data-slot=gravity-stack]')!
    while (stage.dataset.state === 'running') {
      top = Math.min(top, element.getBoundingClientRect().y)
      await new Promise(requestAnimationFrame)
    }
    return top
  })
  await page.mouse.up()
  expect(await highest).toBeGreaterThan(hung - 10)
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

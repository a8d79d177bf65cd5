import { expect, StagePage, test } from './fixtures/stage'

test('a pile can still be moved after an error in onSettle', async ({ stage, page }) => {
  const errors: string[] = []
  page.on('pageerror', (error) => errors.push(error.message))
  await stage.settled('surroundings', { kind: 'throws' })
  await expect.poll(() => errors).toEqual(['of onSettle'])
  const chip = stage.chip('one')
  const { y } = await stage.drag(chip, 0, -100)
  await expect.poll(async () => Math.abs((await stage.centre(chip)).y - y)).toBeLessThan(20)
  await page.mouse.up()
  await expect.poll(() => errors).toEqual(['of onSettle', 'of onSettle'])
  await stage.probe((probe) => probe.errors.splice(0))
})

test('a tap makes a chip hop, also where all around it can have the focus', async ({ stage }) => {
  await stage.settled('surroundings', { kind: 'focusable' })
  expect(await stage.hop(stage.chip('three'))).toBeGreaterThan(20)
})

for (const kind of ['greedy', 'draggable']) {
  test(`a chip is dragged where what is around it is ${kind}`, async ({ stage, page }) => {
    await stage.settled('surroundings', { kind })
    const chip = stage.chip('two')
    const { y } = await stage.drag(chip, 0, -100)
    await expect.poll(async () => Math.abs((await stage.centre(chip)).y - y)).toBeLessThan(20)
    await page.mouse.up()
    await stage.reaches('resting')
  })
}

test('pause() holds a stage from the start when it is called before anything is seen', async ({ stage }) => {
  await stage.open('surroundings', { kind: 'early' })
  await stage.reaches('paused')
  expect(new Set(await stage.states())).toEqual(new Set(['waiting']))
  expect(await stage.during('frames')).toBe(0)
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

test('drop() lets a paused pile fall', async ({ stage, page }) => {
  await stage.open('extras')
  await expect(stage.chips.nth(1)).toHaveAttribute('data-state', 'falling')
  await page.locator('#pause').click()
  await stage.reaches('paused')
  await page.locator('#drop').click()
  await stage.reaches('running')
  await stage.reaches('resting')
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

test('a chip stays in the hand when a render brings another object for `interactive`', async ({
  stage,
  page,
}) => {
  await stage.settled('surroundings', { kind: 'truthy' })
  await stage.drag(stage.chips.first(), 20, -60)
  await expect(stage.chips.first()).toHaveAttribute('data-state', 'held')
  await page.locator('#next').evaluate((button: HTMLElement) => button.click())
  await page.evaluate(() => window.probe.pass(3))
  await expect(stage.chips.first()).toHaveAttribute('data-state', 'held')
  await page.mouse.up()
  await stage.reaches('resting')
})

test('a chip that is shown on the whole screen keeps its place in the pile', async ({ stage, page }) => {
  await stage.settled('surroundings', { kind: 'screen' })
  const { poses } = await stage.pile()
  await page.getByRole('button', { name: 'whole screen' }).click()
  await expect.poll(() => page.evaluate(() => document.fullscreenElement?.textContent)).toBe('whole screen')
  // The press has woken it.
  await stage.reaches('resting')
  await stage.probe((probe) => probe.states.splice(0))
  // What fills the screen is pressed there, not in the pile behind.
  await page.mouse.move(300, 300)
  await page.mouse.down()
  await page.mouse.move(200, 200, { steps: 4 })
  await page.mouse.up()
  await page.evaluate(() => document.exitFullscreen())
  await expect.poll(() => page.evaluate(() => document.fullscreenElement)).toBe(null)
  await page.evaluate(() => window.probe.pass(3))
  for (const [i, pose] of (await stage.pile()).poses.entries()) {
    expect(Math.hypot(pose.x - poses[i].x, pose.y - poses[i].y)).toBeLessThan(0.5)
  }
  expect(await stage.probe((probe) => probe.states)).toEqual([])
})

test('a text that comes in front of others is a chip of its own, and theirs stay theirs', async ({
  stage,
  page,
}) => {
  await stage.settled('surroundings', { kind: 'texts' })
  const marked = () =>
    stage.chips.evaluateAll((all) =>
      all.map((chip) => `${chip.textContent} ${(chip as HTMLElement).dataset.mark ?? ''}`.trim()),
    )
  await stage.chips.evaluateAll((all) => {
    for (const chip of all) (chip as HTMLElement).dataset.mark = chip.textContent!
  })
  await page.locator('#next').click()
  await expect.poll(marked).toEqual(['first', 'second second', 'third third'])
  await stage.reaches('resting')
  await page.locator('#next').click()
  await expect.poll(marked).toEqual(['second second', 'third third'])
})

test('drop() goes by the order of the children, not by when they came', async ({ stage, page }) => {
  await stage.settled('surroundings', { kind: 'front' })
  await page.locator('#next').click()
  await expect(stage.chips.first()).toHaveText('new')
  await expect(stage.chips.first()).toHaveAttribute('data-state', 'resting')
  await page.locator('#drop').click()
  await stage.reaches('running')
  await stage.reaches('resting')
  const order = await stage.probe((probe) => probe.releases.map(([chip]) => chip))
  expect(order.slice(-4)).toEqual([0, 1, 2, 3])
})

test('a picture that loads lazily loads, and falls', async ({ stage, page }) => {
  await page.route('**/late.svg', (route) =>
    route.fulfill({
      contentType: 'image/svg+xml',
      body: '<svg xmlns="http://www.w3.org/2000/svg" width="80" height="40"><rect width="80" height="40"/></svg>',
    }),
  )
  await stage.open('surroundings', { kind: 'lazy' })
  await expect(stage.chips.first()).not.toHaveAttribute('data-state', 'waiting')
  await stage.reaches('resting')
  expect(await stage.overlap()).toBeLessThan(1)
})

test('of a stage inside a chip of another one press takes the inner chip alone', async ({ stage, page }) => {
  await stage.settled('surroundings', { kind: 'nested' })
  const inner = page.getByText('inner', { exact: true })
  const box = (await inner.boundingBox())!
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2)
  await page.mouse.down()
  const held = page.locator('[data-state=held]')
  await expect(held).toHaveCount(1)
  await expect(held).toHaveText('inner')
  await page.mouse.up()
})

test('a stage that grows out of nothing at the edge of the window waits until it is seen', async ({
  stage,
  page,
}) => {
  await stage.open('surroundings', { kind: 'grows' })
  await stage.probe((probe) => probe.pass(3))
  await page.locator('#next').click()
  await stage.reaches('waiting')
  await stage.probe((probe) => probe.pass(5))
  await stage.reaches('waiting')
  await page.mouse.wheel(0, 400)
  await stage.reaches('running')
})

test('a stage that was scaled to nothing drops once it has grown', async ({ stage, page }) => {
  await stage.open('surroundings', { kind: 'scaled' })
  await stage.reaches('waiting')
  await stage.probe((probe) => probe.pass(3))
  await page.locator('#next').click()
  await stage.reaches('running')
})

for (const [kind, larger] of [
  ['panel', 'higher'],
  ['wide', 'wider'],
  ['clipped', 'wider'],
  ['shadowed', 'higher'],
]) {
  test(`a ${kind} stage much ${larger} than what it scrolls in drops when it fills what can be seen of it`, async ({
    stage,
  }) => {
    await stage.open('surroundings', { kind })
    await stage.reaches('running')
  })
}

for (const [kind, larger] of [
  ['framed', 'higher'],
  ['framed wide', 'wider'],
]) {
  test(`a stage much ${larger} than the frame that it stands in drops`, async ({ page }) => {
    await page.goto(`/surroundings?kind=${kind}`)
    const root = page.frameLocator('iframe').locator('[data-slot=gravity-stack]')
    await expect(root).toHaveAttribute('data-state', 'running')
  })
}

test('a stage of which a tenth is in view waits, though the body that clips it has no height', async ({
  stage,
  page,
}) => {
  await stage.open('surroundings', { kind: 'bodiless' })
  await expect.poll(() => stage.probe((probe) => probe.observed.intersection)).toBe(1)
  await page.evaluate(() => window.probe.pass(10))
  await stage.reaches('waiting')
  await page.mouse.wheel(0, 200)
  await stage.reaches('running')
})

test('what a portal among the chips shows keeps what was typed there when a chip comes before it', async ({
  stage,
  page,
}) => {
  await stage.settled('surroundings', { kind: 'portal' })
  await page.getByLabel('elsewhere').fill('typed')
  await page.locator('#next').click()
  await expect(stage.chip('new')).toHaveAttribute('data-state', 'falling')
  await expect(page.getByLabel('elsewhere')).toHaveValue('typed')
})

for (const kind of ['column', 'row', 'grid']) {
  test(`a stage in the middle of a ${kind} is as wide as that is`, async ({ stage }) => {
    await stage.settled('surroundings', { kind })
    expect(await stage.root.evaluate((root) => root.clientWidth)).toBe(500)
  })
}

test('a stage just below the window is not looked at again and again', async ({ stage, page }) => {
  await page.addInitScript(() => {
    const { observe } = IntersectionObserver.prototype
    Object.assign(window, { looks: 0 })
    IntersectionObserver.prototype.observe = function (target) {
      ;(window as unknown as { looks: number }).looks++
      observe.call(this, target)
    }
  })
  const looks = () => page.evaluate(() => (window as unknown as { looks: number }).looks)
  await stage.open('surroundings', { kind: 'below' })
  await stage.probe((probe) => probe.pass(30))
  const before = await looks()
  await stage.probe((probe) => probe.pass(60))
  expect(await looks()).toBe(before)
  await page.evaluate(() => scrollTo(0, 300))
  await stage.reaches('resting')
})

test('chips that come when a hundred that waited have gone fall at once', async ({ stage, page }) => {
  await stage.open('surroundings', { kind: 'filtered' })
  await expect(stage.chips.nth(3)).not.toHaveAttribute('data-state', 'waiting')
  await page.locator('#next').click()
  await expect(stage.chips).toHaveCount(3)
  await stage.reaches('resting')
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

test('a stage in a window that the page has opened drops its chips', async ({ stage, page, context }) => {
  await stage.open('surroundings', { kind: 'popup' })
  const [popup] = await Promise.all([context.waitForEvent('page'), page.locator('#open').click()])
  await expect(popup.locator('[data-slot=gravity-stack]')).toHaveAttribute('data-state', 'resting')
})

test('a press on a slider, or on what its owner has marked, is theirs; one on words that can’t be edited takes the chip', async ({
  stage,
  page,
}) => {
  await stage.settled('surroundings', { kind: 'owned' })
  for (const [what, state] of [
    ['[role=slider]', 'resting'],
    ['[data-slot=slider-track]', 'resting'],
    ['[data-no-grab]', 'resting'],
    ['[contenteditable=false]', 'held'],
  ]) {
    const box = await stage.root.locator(what).boundingBox()
    await page.mouse.move(box!.x + box!.width / 2, box!.y + box!.height / 2)
    await page.mouse.down()
    await page.mouse.move(box!.x + box!.width / 2 + 40, box!.y + box!.height / 2 - 20, { steps: 6 })
    await expect(stage.chips.filter({ has: page.locator(what) })).toHaveAttribute('data-state', state)
    await page.mouse.up()
    await stage.reaches('resting')
  }
})

test('a shake while motion is reduced is none, also once it is not', async ({ stage, page }) => {
  await stage.settled('surroundings', { kind: 'front' })
  const { poses } = await stage.pile()
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await stage.reaches('static')
  await page.locator('#shake').click()
  await page.emulateMedia({ reducedMotion: 'no-preference' })
  await stage.reaches('resting')
  expect((await stage.pile()).poses).toEqual(poses)
})

for (const mocked of [false, true]) {
  const has = mocked ? 'mocks that call back at once' : 'nothing that watches'
  test(`in a test’s document, which has no transitions and ${has}, the children are there and nothing is thrown`, async ({
    stage,
    page,
  }) => {
    await page.addInitScript((mocks) => {
      Object.assign(window, { CSSTransition: undefined })
      if (!mocks) {
        Object.assign(window, {
          matchMedia: undefined,
          IntersectionObserver: undefined,
          ResizeObserver: undefined,
        })
        return
      }
      window.IntersectionObserver = class extends IntersectionObserver {
        constructor(private told: IntersectionObserverCallback) {
          super(told)
        }
        override observe(target: Element) {
          const box = target.getBoundingClientRect()
          const entry = { target, isIntersecting: true, intersectionRatio: 1, intersectionRect: box }
          this.told([{ ...entry, boundingClientRect: box, rootBounds: null, time: 0 }], this)
        }
      }
    }, mocked)
    await stage.open('surroundings', { kind: 'front' })
    await page.locator('#next').click()
    await expect(stage.chip('new')).toBeAttached()
    await stage.reaches('static')
  })
}

test('over what keeps its presses the hand is not offered, and a cursor of its own stays', async ({
  stage,
  page,
}) => {
  await stage.settled('surroundings', { kind: 'owned' })
  await expect(stage.chips.first()).toHaveCSS('cursor', 'grab')
  const canvas = stage.root.locator('canvas')
  await expect(canvas).toHaveCSS('cursor', 'auto')
  await expect(stage.root.getByText('fixed')).toHaveCSS('cursor', 'grab')
  await page.addStyleTag({ content: '@layer utilities { .own { cursor: crosshair } }' })
  await canvas.evaluate((element) => element.classList.add('own'))
  await expect(canvas).toHaveCSS('cursor', 'crosshair')
})

test('a press on a popover of a chip moves no chip; its words can be selected', async ({ stage, page }) => {
  await stage.settled('surroundings', { kind: 'popover' })
  await expect(page.getByText('read me')).toHaveCSS('cursor', 'auto')
  const box = (await page.getByText('read me').boundingBox())!
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2)
  await page.mouse.down()
  await page.mouse.move(box.x + 40, box.y - 60, { steps: 4 })
  expect(await stage.states()).not.toContain('held')
  await page.mouse.up()
  await stage.reaches('resting')
  await page.getByText('read me').click({ clickCount: 3 })
  expect(await page.evaluate(() => `${getSelection()}`.trim())).toBe('read me')
})

test('a tap on a button in a shadow tree is the button’s: its chip does not hop', async ({ stage, page }) => {
  await stage.settled('surroundings', { kind: 'shadow' })
  await page.evaluate(() =>
    addEventListener('click', ({ target }) => {
      if (target instanceof HTMLElement && target.shadowRoot) document.title = 'pressed'
    }),
  )
  expect(await stage.hop(stage.chips.first())).toBeLessThan(10)
  await expect(page).toHaveTitle('pressed')
})

test('chips come down while the stagger changes with every frame', async ({ stage }) => {
  await stage.open('surroundings', { kind: 'restless' })
  await expect(stage.chips.nth(2)).not.toHaveAttribute('data-state', 'waiting')
})

test('what one reads stays where it is when the page grows above the stage, in mid-fall and at rest', async ({
  stage,
  page,
}) => {
  await stage.open('pile', { above: 1000, below: 2000, shaker: true })
  await page.evaluate(() => scrollTo(0, 1100))
  await stage.reaches('running')
  for (const state of ['running', 'resting']) {
    await stage.reaches(state)
    const before = await stage.root.boundingBox()
    await page.evaluate(async () => {
      const above = document.querySelector<HTMLElement>('main > div')!
      above.style.height = `${above.offsetHeight + 100}px`
      await window.probe.pass(3)
    })
    expect((await stage.root.boundingBox())!.y, state).toBe(before!.y)
  }
})

test('a held chip stays with a pointer that stands still while the page scrolls', async ({ stage, page }) => {
  await stage.settled('surroundings', { kind: 'tall' })
  const chip = stage.chip('two')
  await stage.drag(chip, 0, -60)
  await stage.hangs(chip)
  const { y } = await stage.centre(chip)
  await page.mouse.wheel(0, 60)
  await expect.poll(() => page.evaluate(() => scrollY)).toBe(60)
  await expect.poll(async () => Math.abs((await stage.centre(chip)).y - y)).toBeLessThan(5)
  await page.mouse.up()
})

test('chips are where they are drawn, though the page gives every element a transition', async ({
  stage,
  page,
}) => {
  await stage.open('surroundings', { kind: 'transitions' })
  await stage.reaches('running')
  const off = await page.evaluate(async () => {
    let most = 0
    for (let i = 0; i < 30; i++) {
      await window.probe.pass(1)
      for (const chip of document.querySelectorAll<HTMLElement>('[data-slot=gravity-stack-chip]')) {
        if (!chip.style.transform) continue
        const [drawn, written] = [getComputedStyle(chip).transform, chip.style.transform].map(
          (transform) => new DOMMatrix(transform),
        )
        most = Math.max(most, Math.hypot(drawn.e - written.e, drawn.f - written.f))
      }
    }
    return most
  })
  expect(off).toBeLessThan(0.01)
  await stage.reaches('resting')
})

test('chips are where they are drawn, and hang below the pointer, though the page gives every element a margin', async ({
  stage,
  page,
}) => {
  await stage.settled('pile', { chips: 4 })
  await page.addStyleTag({
    content: '* + * { margin-top: 24px } div, i { margin-left: 24px } i:empty { display: none }',
  })
  const off = await stage.root.evaluate((root) => {
    const box = root.getBoundingClientRect()
    return [...root.querySelectorAll<HTMLElement>('[data-slot=gravity-stack-chip]')].map((chip) => {
      const drawn = chip.getBoundingClientRect()
      const { width, height, transform } = getComputedStyle(chip)
      const { e, f } = new DOMMatrix(transform)
      return [
        drawn.x + drawn.width / 2 - (box.x + e + Number.parseFloat(width) / 2),
        drawn.y + drawn.height / 2 - (box.y + f + Number.parseFloat(height) / 2),
      ]
    })
  })
  for (const distance of off.flat()) expect(distance).toBeCloseTo(0, 1)
  const chip = stage.chips.first()
  const pointer = await stage.drag(chip, 0, -120)
  await stage.hangs(chip)
  const centre = await stage.centre(chip)
  expect(Math.hypot(centre.x - pointer.x, centre.y - pointer.y)).toBeLessThan(4)
  await page.mouse.up()
})

test('a pill that begins with words and styles nobody sees falls as the pill it is', async ({
  stage,
  page,
}) => {
  await stage.settled('surroundings', { kind: 'unseen' })
  const other = new StagePage(page, page.locator('[data-slot=gravity-stack]').nth(1))
  await other.reaches('resting')
  const [{ poses: plain }, { poses: wordy }] = await Promise.all([stage.pile(), other.pile()])
  // What moves by less than a tenth of a pixel is not drawn again, so which frames fell into the last steps shows that much.
  const off = plain.map(({ x, y }, i) => Math.hypot(x - wordy[i].x, y - wordy[i].y))
  expect(Math.max(...off)).toBeLessThan(0.25)
})

test('a stage that is hidden when its last chip goes is not told that the others are too large for it', async ({
  stage,
}) => {
  await stage.open('pile', { chips: 2, stagger: 60000 })
  await expect(stage.chips.first()).toHaveAttribute('data-state', 'resting')
  await stage.root.evaluate((root) => {
    root.style.display = 'none'
  })
  await stage.reaches('paused')
  await stage.chips.nth(1).evaluate((chip) => chip.remove())
  await stage.reaches('resting')
  expect(await stage.probe((probe) => probe.warnings)).toEqual([])
})

test('a stage that opens by and by is not told that its chips are too large for it', async ({
  stage,
  page,
}) => {
  await stage.open('surroundings', { kind: 'opens' })
  await stage.reaches('running')
  await page.locator('#next').click()
  await stage.reaches('resting')
  expect(await stage.probe((probe) => probe.warnings)).toEqual([])
})

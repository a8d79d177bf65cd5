import { expect, readOutside, StagePage, test } from './fixtures/stage'

const kinds = [
  'plain',
  'scaled',
  'rotated',
  'own',
  'rtl',
  'scroller',
  'columns',
  'second column',
  'split',
  'growing',
  'shadow',
  'frame',
]

for (const kind of kinds) {
  test(`the pointer grabs and carries the right point of a chip: ${kind} stage`, async ({
    stage: outer,
    page,
  }) => {
    const second = kind === 'second column'
    await outer.open('places', { kind: second ? 'columns' : kind })
    const scope = kind === 'frame' ? page.frameLocator('iframe') : page
    const stage = new StagePage(page, scope.locator('[data-slot=gravity-stack]').nth(second ? 1 : 0))
    await stage.reaches('resting')
    if (kind === 'scroller') {
      await page.locator('#scroller').evaluate((element) => element.scrollTo(60, 40))
    }
    expect(await stage.overlap()).toBeLessThan(1)
    // In one piece: the pile of one that is broken in two lies in its upper half, cut off.
    expect(await stage.root.evaluate((element) => element.getClientRects().length)).toBe(1)
    const chip = stage.chips.nth(1)
    // A mark in the chip tells where its point is on the screen, whatever turns or scales the stage.
    await chip.evaluate((element) => {
      const mark = element.ownerDocument.createElement('i')
      mark.id = 'mark'
      mark.style.cssText = 'position:absolute;left:30%;top:50%'
      element.append(mark)
    })
    const mark = async () => {
      const box = await stage.root.locator('#mark').evaluate((element) => {
        const { x, y } = element.getBoundingClientRect()
        return { x, y }
      })
      const frame = kind === 'frame' ? await page.locator('iframe').boundingBox() : undefined
      return { x: box.x + (frame?.x ?? 0), y: box.y + (frame?.y ?? 0) }
    }
    const from = await mark()
    const middle = await stage.root.boundingBox()
    const to = { x: middle!.x + middle!.width / 2, y: middle!.y + middle!.height / 2 }
    await page.mouse.move(from.x, from.y)
    await page.mouse.down()
    await expect(chip).toHaveAttribute('data-state', 'held')
    await page.mouse.move(to.x, to.y, { steps: 8 })
    await stage.hangs(chip)
    if (kind === 'growing') {
      // It may have grown on since the last move, of which the pointer tells nothing.
      await page.mouse.move(to.x, to.y - 1)
      await page.mouse.move(to.x, to.y)
      await stage.hangs(chip)
    }
    const at = await mark()
    expect(Math.hypot(at.x - to.x, at.y - to.y)).toBeLessThan(9)
    if (kind === 'scroller') {
      await page.locator('#scroller').evaluate((element) => element.scrollBy(40, 25))
      await page.mouse.move(to.x + 1, to.y)
      await stage.hangs(chip)
      const scrolled = await mark()
      expect(Math.hypot(scrolled.x - to.x - 1, scrolled.y - to.y)).toBeLessThan(9)
    }
    await page.mouse.up()
    await stage.reaches('resting')
  })
}

test('when the stage becomes narrower or lower, walls and floor move and the pile follows', async ({
  stage,
  page,
}) => {
  await stage.settled('places', { kind: 'sizes' })
  for (let i = 0; i < 3; i++) {
    const { stage: before } = await stage.pile()
    await page.locator('#next').click()
    await expect.poll(async () => (await stage.pile()).stage).not.toEqual(before)
    await page.evaluate(() => window.probe.pass(2))
    await stage.reaches('resting')
    expect(await stage.overlap()).toBeLessThan(1)
    expect(await stage.outside()).toBeLessThan(1)
  }
})

test('what of a pile reaches out of its stage is cut off, and takes no press there', async ({ stage }) => {
  await stage.settled('pile', { chips: 60, above: 200, box: 'h-40 w-64' })
  const { chips, pressed } = await stage.root.evaluate(readOutside)
  expect(chips).toBeGreaterThan(3)
  expect(pressed).toBe(0)
})

test('ten stages on a page share Motion’s frame loop, and each asks for one frame more at a time, in case that ends', async ({
  stage,
  page,
}) => {
  await page.setViewportSize({ width: 800, height: 1000 })
  await stage.open('places', { kind: 'many' })
  const running = page.locator('[data-slot=gravity-stack][data-state=running]')
  await expect(running).toHaveCount(10)
  const { asked, passed } = await page.evaluate(async () => {
    const before = window.probe.frames
    await window.probe.pass(10)
    return { asked: window.probe.frames - before, passed: 10 }
  })
  expect(asked).toBeLessThanOrEqual(11 * (passed + 1))
  await expect(page.locator('[data-slot=gravity-stack][data-state=resting]')).toHaveCount(10)
  expect(await stage.during('frames')).toBe(0)
  expect(await stage.probe((probe) => probe.observed.intersection)).toBe(10)
})

test('zoomed to 400 % the pile still lies inside, whole and apart', async ({ stage, page }) => {
  await page.setViewportSize({ width: 320, height: 256 })
  await stage.open('pile', { box: 'h-[240px] w-full', chips: 8 })
  await stage.reaches('resting')
  expect(await stage.overlap()).toBeLessThan(1)
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(320)
})

for (const kind of ['column', 'row', 'grid']) {
  test(`a stage in the middle of a ${kind} is as wide as that is`, async ({ stage }) => {
    await stage.settled('surroundings', { kind })
    expect(await stage.root.evaluate((root) => root.clientWidth)).toBe(500)
  })
}

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

test('an element that keeps its presses shows no hand as cursor, and a cursor of its own stays', async ({
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

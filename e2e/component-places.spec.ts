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

for (const kind of ['zero', 'hidden']) {
  test(`a stage that begins ${kind === 'zero' ? 'without size, as a developer is told,' : 'hidden'} drops its chips once it is shown, and survives vanishing`, async ({
    stage,
    page,
  }) => {
    await stage.open('places', { kind })
    await page.evaluate(() => window.probe.pass(10))
    expect(new Set(await stage.states())).toEqual(new Set(['waiting']))
    const warnings = await stage.probe((probe) => probe.warnings)
    // What is hidden may well be so on purpose.
    if (kind === 'hidden') expect(warnings).toEqual([])
    else expect(warnings.join()).toMatch(/400 px wide and 0 px high, so nothing falls .+ Give it a height/)
    await page.locator('#next').click()
    await stage.reaches('resting')
    const { poses } = await stage.pile()
    await page.locator('#next').click()
    await page.evaluate(() => window.probe.pass(10))
    expect(await stage.during('frames')).toBe(0)
    await page.locator('#next').click()
    await page.evaluate(() => window.probe.pass(10))
    await stage.reaches('resting')
    const after = (await stage.pile()).poses
    // The stage has lost its last 100 px; whoever lay left of them has hardly noticed.
    expect(Math.abs(after[0].y - poses[0].y)).toBeLessThan(80)
    expect(await stage.overlap()).toBeLessThan(1)
    expect(await stage.outside()).toBeLessThan(1)
  })
}

test('what of a pile reaches out of its stage is cut off, and takes no press there', async ({ stage }) => {
  await stage.settled('pile', { chips: 60, above: 200, box: 'h-40 w-64' })
  const { chips, pressed } = await stage.root.evaluate(readOutside)
  expect(chips).toBeGreaterThan(3)
  expect(pressed).toBe(0)
})

test('ten stages on a page share one frame loop', async ({ stage, page }) => {
  await page.setViewportSize({ width: 800, height: 1000 })
  await stage.open('places', { kind: 'many' })
  const running = page.locator('[data-slot=gravity-stack][data-state=running]')
  await expect(running).toHaveCount(10)
  const { asked, passed } = await page.evaluate(async () => {
    const before = window.probe.frames
    await window.probe.pass(10)
    return { asked: window.probe.frames - before, passed: 10 }
  })
  expect(asked).toBeLessThanOrEqual(passed + 1)
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

test('with the text spacing of WCAG 1.4.12 each chip takes its new size and nothing overlaps', async ({
  stage,
  page,
}) => {
  await stage.settled('pile', { chips: 12 })
  await page.addStyleTag({
    content:
      '* { letter-spacing: 0.12em !important; word-spacing: 0.16em !important; line-height: 1.5 !important }',
  })
  await stage.reaches('running')
  await stage.reaches('resting')
  expect(await stage.overlap()).toBeLessThan(1)
})

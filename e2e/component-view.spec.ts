import { hideTab } from './fixtures/hide-tab'
import { expect, test } from './fixtures/stage'

test('out of view the stage pauses, and goes on where it was', async ({ stage, page }) => {
  await page.setViewportSize({ width: 800, height: 500 })
  await stage.open('pile', { chips: 40, below: 2000 })
  await expect(stage.chips.nth(5)).toHaveAttribute('data-state', 'falling')
  await page.mouse.wheel(0, 1500)
  await stage.reaches('paused')
  expect(await stage.during('frames')).toBe(0)
  expect(await stage.probe((probe) => probe.timers)).toBe(0)
  const { poses } = await stage.pile()
  expect(new Set(await layers(stage.chips))).toEqual(new Set(['auto']))
  expect((await stage.pile()).poses).toEqual(poses)
  await page.mouse.wheel(0, -1500)
  await stage.reaches('resting')
  expect(await stage.overlap()).toBeLessThan(1)
  // A drop that began anew would have let go of the first ones twice.
  const released = await stage.probe((probe) => probe.releases.map(([chip]) => chip))
  expect(released).toEqual([...Array(40).keys()])
})

test('a stage that folds up in mid-fall pauses, and goes on where it was once it opens', async ({
  stage,
}) => {
  await stage.open('pile', { chips: 12 })
  await expect(stage.chips.nth(3)).toHaveAttribute('data-state', 'falling')
  // Without a height it still counts as in view.
  await stage.root.evaluate((root) => {
    root.style.height = '0'
  })
  await stage.reaches('paused')
  expect(await stage.during('frames')).toBe(0)
  expect(await stage.probe((probe) => probe.timers)).toBe(0)
  await stage.root.evaluate((root) => {
    root.style.height = ''
  })
  await stage.reaches('resting')
  expect(await stage.overlap()).toBeLessThan(1)
  const released = await stage.probe((probe) => probe.releases.map(([chip]) => chip))
  expect(released).toEqual([...Array(12).keys()])
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

test('a stage hidden with its pile shows the same pile again, and has not settled anew', async ({
  stage,
  page,
}) => {
  await stage.settled('extras')
  const before = await stage.pile()
  const main = page.locator('main')
  await main.evaluate((element) => {
    element.style.display = 'none'
  })
  await stage.probe((probe) => probe.pass(3))
  await main.evaluate((element) => {
    element.style.display = ''
  })
  await stage.probe((probe) => probe.pass(3))
  expect(await stage.pile()).toEqual(before)
  expect(await stage.probe((probe) => probe.releases.length)).toBe(6)
  await expect(page.locator('#settled')).toHaveText('1')
})

test('a chip hidden while its stage is hidden has gone when the stage is shown, and what it carried falls', async ({
  stage,
  page,
}) => {
  await stage.settled('pile', { chips: 9, box: 'h-[340px] w-[160px]', stagger: 20 })
  await page.locator('main').evaluate(async (main) => {
    main.style.display = 'none'
    await window.probe.pass(3)
    for (const face of main.querySelectorAll<HTMLElement>(
      '[data-slot=gravity-stack-chip]:nth-child(-n+3) > *',
    ))
      face.style.display = 'none'
    await window.probe.pass(3)
    main.style.display = ''
  })
  await expect.poll(() => stage.states()).toContain('waiting')
  await stage.reaches('resting')
  expect(await stage.states()).toEqual([...Array(3).fill('waiting'), ...Array(6).fill('resting')])
  const { shapes, poses, stage: size } = await stage.pile()
  const lowest = Math.max(...poses.slice(3).map(({ y }, i) => y + shapes[i + 3].height / 2))
  expect(lowest).toBeGreaterThan(size.height - 1)
})

const layers = (chips: import('@playwright/test').Locator) =>
  chips.evaluateAll((all) => all.map((chip) => getComputedStyle(chip).willChange))

test('in a hidden tab the stage pauses, and a held chip is let go', async ({ stage, page }) => {
  await stage.open('pile', { chips: 2, stagger: 60000 })
  const chip = stage.chips.nth(0)
  await expect(chip).toHaveAttribute('data-state', 'resting')
  await stage.drag(chip, 0, -40)
  await expect(chip).toHaveAttribute('data-state', 'held')
  await page.evaluate(hideTab, true)
  await stage.reaches('paused')
  await expect(chip).not.toHaveAttribute('data-state', 'held')
  expect(await stage.during('frames')).toBe(0)
  expect(await stage.probe((probe) => probe.timers)).toBe(0)
  await page.evaluate(hideTab, false)
  await stage.reaches('running')
  await expect(chip).toHaveAttribute('data-state', 'resting')
  await page.mouse.up()
})

for (const height of [360, 390])
  test(`chips drop when a link to the text of one leads to the stage, in a window ${height} px high`, async ({
    stage,
    page,
  }) => {
    await page.setViewportSize({ width: 800, height })
    await stage.page.goto('/pile?stagger=40&above=900&below=900#:~:text=springs')
    await stage.reaches('running')
    await stage.reaches('resting')
  })

test('a stage eight windows high drops once it fills half of the window', async ({ stage, page }) => {
  await stage.open('places', { kind: 'tall', above: 600 })
  await stage.reaches('waiting')
  await page.evaluate(() => window.scrollTo(0, 300))
  await stage.reaches('running')
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

test('a stage in a window that the page has opened drops its chips', async ({ stage, page, context }) => {
  await stage.open('surroundings', { kind: 'popup' })
  const [popup] = await Promise.all([context.waitForEvent('page'), page.locator('#open').click()])
  await expect(popup.locator('[data-slot=gravity-stack]')).toHaveAttribute('data-state', 'resting')
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

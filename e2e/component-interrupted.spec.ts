import type { Page } from '@playwright/test'
import { hideTab } from './fixtures/hide-tab'
import { expect, test } from './fixtures/stage'
import { keepWaits, letTimePass } from './fixtures/time'

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

test('a new stagger leaves a pile at rest alone', async ({ stage, page }) => {
  await stage.settled('extras')
  await page.locator('#pace').click()
  await stage.probe((probe) => probe.pass(5))
  await expect(stage.root).toHaveAttribute('data-state', 'resting')
  expect(await stage.probe((probe) => probe.states.filter((state) => state === 'running').length)).toBe(1)
})

/** Counts from now on how many chips each frame releases. */
async function countReleases(page: Page) {
  await page.addInitScript(() => {
    const together: number[] = []
    Object.assign(window, { together })
    new MutationObserver((records) => {
      const released = records.filter(
        ({ target, oldValue }) =>
          oldValue === 'waiting' && (target as HTMLElement).dataset.slot === 'gravity-stack-chip',
      )
      if (released.length > 0) together.push(released.length)
    }).observe(document, { subtree: true, attributeFilter: ['data-state'], attributeOldValue: true })
  })
  return async () =>
    Math.max(...(await page.evaluate(() => (window as unknown as { together: number[] }).together)))
}

test('a new stagger holds for chips that wait already: they come one by one', async ({ stage, page }) => {
  const mostAtOnce = await countReleases(page)
  await stage.open('extras', { stagger: 60000 })
  await expect(stage.chips.first()).toHaveAttribute('data-state', 'resting')
  expect(await stage.states()).toContain('waiting')
  await page.locator('#pace').click()
  await expect.poll(() => stage.states()).not.toContain('waiting')
  await stage.reaches('resting')
  expect(await mostAtOnce()).toBeLessThan(5)
})

test('chips to come still come one by one when one is tapped after the computer has slept', async ({
  stage,
  page,
}) => {
  await letTimePass(page)
  const mostAtOnce = await countReleases(page)
  await stage.open('pile', { chips: 4, stagger: 2500 })
  const first = stage.chips.first()
  await expect(first).toHaveAttribute('data-state', 'resting')
  const { x, y } = await stage.centre(first)
  await page.evaluate(() => {
    window.passed = 30_000
  })
  await page.mouse.click(x, y)
  await stage.reaches('resting')
  expect(await mostAtOnce()).toBe(1)
})

test('no time passes for the chips to come while the tab is hidden', async ({ stage, page }) => {
  await letTimePass(page)
  await keepWaits(page, 5000)
  await stage.open('pile', { chips: 2, stagger: 60000 })
  await expect(stage.chips.first()).toHaveAttribute('data-state', 'resting')
  await page.evaluate(hideTab, true)
  await stage.reaches('paused')
  await page.evaluate(() => {
    window.passed = 20_000
  })
  await page.evaluate(hideTab, false)
  await stage.reaches('running')
  expect(await page.evaluate(() => window.waits.at(-1))).toBeGreaterThan(45_000)
})

test('who plays with the pile does not hold back the chips to come', async ({ stage, page }) => {
  await letTimePass(page)
  await keepWaits(page, 5000)
  await stage.open('pile', { chips: 2, stagger: 60000 })
  const [first, second] = [stage.chips.nth(0), stage.chips.nth(1)]
  await expect(first).toHaveAttribute('data-state', 'resting')
  await page.evaluate(() => {
    window.passed = 20_000
  })
  const { x, y } = await stage.centre(first)
  await page.mouse.click(x, y)
  await expect(first).toHaveAttribute('data-state', 'falling')
  await expect(first).toHaveAttribute('data-state', 'resting')
  await expect(second).toHaveAttribute('data-state', 'waiting')
  // ms that the second was still to wait when the first lay still, before and after the tap.
  const [before, after] = await page.evaluate(() => window.waits.slice(-2))
  expect(before - after).toBeGreaterThan(20_000)
})

test('a chip that loses its size in a hand has left it, and falls anew when it has one again', async ({
  stage,
  page,
}) => {
  await stage.settled('pile', { chips: 3 })
  const chip = stage.chips.nth(0)
  await stage.drag(chip, 0, -100)
  const show = (display: string) =>
    chip.evaluate((wrapper, display) => {
      ;(wrapper.firstElementChild as HTMLElement).style.display = display
    }, display)
  await show('none')
  await expect(chip).toHaveAttribute('data-state', 'waiting')
  await page.mouse.move(300, 60, { steps: 3 })
  await page.mouse.up()
  await expect(chip).toHaveAttribute('data-state', 'waiting')
  await show('')
  await expect(chip).toHaveAttribute('data-state', 'resting')
  await stage.reaches('resting')
  expect(await stage.overlap()).toBeLessThan(1)
})

test('a chip whose release was lost to something else is let go when the pointer comes back', async ({
  stage,
  page,
}) => {
  // Before the stage's own listener, as where the release never comes to the page.
  await page.addInitScript(() =>
    window.addEventListener('pointerup', (event) => event.stopImmediatePropagation(), {
      capture: true,
      once: true,
    }),
  )
  await stage.settled('pile', { chips: 3 })
  const chip = stage.chips.nth(0)
  const { x, y } = await stage.centre(chip)
  await page.mouse.move(x, y)
  await page.mouse.down()
  await expect(chip).toHaveAttribute('data-state', 'held')
  await page.mouse.up()
  await expect(chip).toHaveAttribute('data-state', 'held')
  await page.mouse.move(x + 40, y - 60, { steps: 3 })
  await expect(chip).not.toHaveAttribute('data-state', 'held')
  await stage.reaches('resting')
})

test('a chip whose content captures the pointer itself is dragged like any other', async ({
  stage,
  page,
}) => {
  await stage.settled('pile', { chips: 3 })
  const chip = stage.chips.nth(0)
  await chip.evaluate(({ firstElementChild: face }) =>
    face!.addEventListener('pointerdown', (event) =>
      face!.setPointerCapture((event as PointerEvent).pointerId),
    ),
  )
  const { y } = await stage.drag(chip, 0, -120)
  await stage.hangs(chip)
  await expect(chip).toHaveAttribute('data-state', 'held')
  expect(Math.abs((await stage.centre(chip)).y - y)).toBeLessThan(30)
  await page.mouse.up()
  await expect(chip).not.toHaveAttribute('data-state', 'held')
})

test('a new order of the children leaves a chip in the hand that drags it', async ({ stage, page }) => {
  await stage.settled('children')
  const chip = stage.chip('one')
  await stage.drag(chip, 0, -80)
  await page.locator('#reverse').evaluate((button: HTMLElement) => button.click())
  await expect(stage.chips.first()).toHaveText('eight')
  await stage.probe((probe) => probe.pass(3))
  await expect(chip).toHaveAttribute('data-state', 'held')
  const { x } = await stage.centre(chip)
  const way = x < 320 ? 1 : -1
  await page.mouse.move(x + way * 150, 100, { steps: 5 })
  await stage.hangs(chip)
  expect(way * ((await stage.centre(chip)).x - x)).toBeGreaterThan(100)
  await page.mouse.up()
  await expect(chip).not.toHaveAttribute('data-state', 'held')
})

test('taken from a hand that has stood still a chip falls straight down', async ({ stage, page }) => {
  await stage.settled('extras')
  const chip = stage.chips.nth(0)
  const from = await stage.centre(chip)
  const way = from.x < 250 ? 1 : -1
  await stage.drag(chip, way * 150, -140, 2)
  await stage.hangs(chip)
  const { x } = await stage.centre(chip)
  await page.locator('#pause').evaluate((button: HTMLElement) => button.click())
  await expect(chip).not.toHaveAttribute('data-state', 'held')
  expect(Math.abs((await stage.centre(chip)).x - x)).toBeLessThan(15)
  const watched = await chip.evaluateHandle((element) => {
    const at = () => {
      const box = element.getBoundingClientRect()
      return { x: box.x + box.width / 2, y: box.y + box.height / 2 }
    }
    // Until it has fallen 40 px, with nothing in its way: on a busy machine few frames are a long time.
    async function farthest() {
      let way = 0
      const from = at()
      for (let now = from; now.y - from.y < 40; now = at()) {
        way = Math.max(way, Math.abs(now.x - from.x))
        await window.probe.pass(1)
      }
      return way
    }
    return { farthest: farthest() }
  })
  await page.locator('#resume').evaluate((button: HTMLElement) => button.click())
  expect(await watched.evaluate(({ farthest }) => farthest)).toBeLessThan(15)
  await page.mouse.up()
})

test('a stage eight windows high drops once it fills half of the window', async ({ stage, page }) => {
  await stage.open('places', { kind: 'tall', above: 600 })
  await stage.reaches('waiting')
  await page.evaluate(() => window.scrollTo(0, 300))
  await stage.reaches('running')
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

test('actions of a stage that has gone do nothing', async ({ stage, page }) => {
  await stage.settled('extras')
  await page.evaluate(() => window.unmount())
  expect(await page.evaluate(() => window.kept.map((act) => act()))).toEqual(Array(4).fill(undefined))
  expect(await stage.during('frames')).toBe(0)
  await expect(page.locator('#settled')).toHaveText('1')
})

import AxeBuilder from '@axe-core/playwright'
import type { Page } from '@playwright/test'
import { expect, type StagePage, test } from './fixtures/stage'
import { withhold } from './page'

/**
 * Expects every chip upright, unmoved and inside. Returns px between the nearest two, and below the lowest.
 */
async function readable(page: Page) {
  return page.locator('[data-slot=gravity-stack]').evaluate((root) => {
    const stage = root.getBoundingClientRect()
    const chips = [...root.querySelectorAll('[data-slot=gravity-stack-chip]')]
    const boxes = chips.map((chip) => chip.getBoundingClientRect())
    const between = boxes.flatMap((a, i) =>
      boxes
        .slice(0, i)
        .map((b) => Math.max(b.left - a.right, a.left - b.right, b.top - a.bottom, a.top - b.bottom)),
    )
    const inside = boxes.every(
      (box) =>
        box.left >= stage.left &&
        box.right <= stage.right &&
        box.top >= stage.top &&
        box.bottom <= stage.bottom,
    )
    const upright = chips.every((chip) => getComputedStyle(chip).transform === 'none')
    const shown = chips.every((chip) => getComputedStyle(chip).opacity === '1')
    const lowest = Math.max(...boxes.map((box) => box.bottom))
    return {
      between: Math.round(Math.min(...between)),
      inside,
      upright,
      shown,
      below: Math.round(stage.bottom - lowest),
      height: stage.height,
    }
  })
}

const row = { between: 8, inside: true, upright: true, shown: true, below: 16, height: 340 }

/** Waits until React has the page and the stage has begun. */
const begun = (stage: StagePage) =>
  expect.poll(() => stage.probe((probe) => probe.observed.intersection)).toBe(1)

/** The stage with a sheet of its own behind its chips; how many chips that sheet covers. */
async function covered(stage: StagePage, page: Page) {
  await page.addStyleTag({
    content:
      '[data-slot=gravity-stack]::before { content: ""; position: absolute; inset: 0; background: #ddd }',
  })
  return stage.chips.evaluateAll(
    (all) =>
      all.filter((chip) => {
        const { x, y, width, height } = chip.getBoundingClientRect()
        return !chip.contains(document.elementFromPoint(x + width / 2, y + height / 2))
      }).length,
  )
}

test.describe('with reduced motion', () => {
  test.use({ contextOptions: { reducedMotion: 'reduce' } })

  test('the chips stand upright in a row at the bottom, and nothing moves', async ({ stage, page }) => {
    await stage.open('pile')
    await begun(stage)
    await expect.poll(() => readable(page)).toEqual(row)
    await page.mouse.move(300, 300)
    await page.mouse.down()
    await page.mouse.move(320, 100, { steps: 4 })
    await page.mouse.up()
    expect(await readable(page)).toEqual(row)
    await stage.reaches('static')
    expect(await stage.probe((probe) => [probe.frames, probe.styleWrites, probe.timers])).toEqual([0, 0, 0])
  })

  test('the row is there before the script has come, and hydration moves nothing', async ({
    stage,
    page,
  }) => {
    const letCome = await withhold(page, '**/client-*.js')
    await page.goto('/pile', { waitUntil: 'commit' })
    await expect(stage.chips).toHaveCount(12)
    await expect.poll(() => readable(page)).toEqual(row)
    const boxes = () =>
      stage.chips.evaluateAll((all) => all.map((chip) => JSON.stringify(chip.getBoundingClientRect())))
    const before = await boxes()
    letCome()
    await begun(stage)
    expect(await boxes()).toEqual(before)
    await stage.reaches('static')
  })

  test('what decorates the stage lies behind the chips', async ({ stage, page }) => {
    await stage.open('pile')
    await begun(stage)
    expect(await covered(stage, page)).toBe(0)
  })

  test('a badge at the corner of a chip is at its corner', async ({ stage }) => {
    await stage.open('pile')
    await begun(stage)
    const away = await stage.chips.nth(5).evaluate((chip) => {
      const badge = document.createElement('i')
      badge.style.cssText = 'position: absolute; right: 0; top: 0; width: 8px; height: 8px'
      chip.firstElementChild!.append(badge)
      const { right, top } = chip.getBoundingClientRect()
      const at = badge.getBoundingClientRect()
      return [at.right - right, at.top - top]
    })
    expect(away).toEqual([0, 0])
  })

  test('in Tailwind’s important mode the chips stand in the row as well', async ({ stage, page }) => {
    await stage.open('pile', { important: true })
    await begun(stage)
    await expect.poll(() => readable(page)).toEqual(row)
  })

  test('more chips than fit make the stage taller; none is cut off', async ({ stage, page }) => {
    await stage.open('pile', { chips: 120 })
    const shown = await readable(page)
    expect(shown).toEqual({ ...row, height: shown.height })
    expect(shown.height).toBeGreaterThan(340)
  })

  test('chips of different heights stand on one line', async ({ stage }) => {
    await stage.open('pile', { chips: 4, shape: 'all' })
    const boxes = await stage.chips.evaluateAll((all) =>
      all.map((chip) => {
        const { height, bottom } = chip.getBoundingClientRect()
        return { height, bottom }
      }),
    )
    expect(new Set(boxes.map(({ height }) => height)).size).toBeGreaterThan(1)
    expect(new Set(boxes.map(({ bottom }) => bottom)).size).toBe(1)
  })

  test('a chip wider than its stage is seen whole', async ({ stage }) => {
    await stage.open('inputs', { children: 'wide' })
    const seen = await stage.chip('wide').evaluate((chip) => {
      const { x, y, width, height } = chip.firstElementChild!.getBoundingClientRect()
      return chip.contains(document.elementFromPoint(x + width - 1, y + height / 2))
    })
    expect(seen).toBe(true)
    const { width } = (await stage.root.boundingBox())!
    expect(await stage.chip('wide').evaluate((chip) => chip.firstElementChild!.clientWidth)).toBeGreaterThan(
      width,
    )
  })

  test('the markup is the server’s, and hydration has nothing to say', async ({ stage, page, request }) => {
    await stage.open('pile')
    await begun(stage)
    const served = await page.evaluate(
      (html) => new DOMParser().parseFromString(html, 'text/html').querySelector('main')!.innerHTML,
      await (await request.get('/pile')).text(),
    )
    expect(await page.locator('main').innerHTML()).toBe(served)
  })

  test('switched off live, the chips fall; switched on again, they stand in the row, in the same elements', async ({
    stage,
    page,
  }) => {
    await stage.open('pile')
    const mark = await stage.chips.first().evaluateHandle((chip) => chip)
    await page.emulateMedia({ reducedMotion: 'no-preference' })
    await stage.reaches('running')
    await expect(stage.chips.nth(3)).toHaveAttribute('data-state', 'falling')
    await page.emulateMedia({ reducedMotion: 'reduce' })
    await stage.reaches('static')
    expect(await readable(page)).toEqual(row)
    expect(await stage.during('frames')).toBe(0)
    await page.emulateMedia({ reducedMotion: 'no-preference' })
    await stage.reaches('resting')
    expect(await stage.overlap()).toBeLessThan(1)
    expect(await stage.chips.first().evaluate((chip, before) => chip === before, mark)).toBe(true)
  })

  test('switched off while the tab is hidden, the chips fall when it comes back', async ({ stage, page }) => {
    // Chromium tells a query nothing of what has been read of it before: here it never does.
    await page.addInitScript(() =>
      Object.assign(MediaQueryList.prototype, { addEventListener() {}, addListener() {} }),
    )
    await stage.open('pile')
    await begun(stage)
    // Until it has been told that it is in view, too: that would have it look.
    await page.evaluate(() => window.probe.pass(5))
    await page.emulateMedia({ reducedMotion: 'no-preference' })
    await stage.reaches('static')
    await page.evaluate(() => document.dispatchEvent(new Event('visibilitychange')))
    await stage.reaches('resting')
    expect(await stage.overlap()).toBeLessThan(1)
  })

  test('who goes by the keyboard to a chip in view scrolls nothing, however tall the stage', async ({
    stage,
    page,
  }) => {
    await stage.open('controls', { above: 100 })
    await stage.root.evaluate((root) => {
      root.style.cssText = 'height: 1500px; align-content: start'
    })
    await page.evaluate(() => window.probe.pass(10))
    await page.getByText('before').focus()
    await page.keyboard.press('Tab')
    await expect(page.getByText('Read the docs')).toBeFocused()
    await page.evaluate(() => window.probe.pass(10))
    expect(await page.evaluate(() => scrollY)).toBe(0)
  })

  test('axe finds nothing', async ({ stage, page }) => {
    await stage.open('controls')
    expect(
      (await new AxeBuilder({ page }).include('[data-slot=gravity-stack]').analyze()).violations,
    ).toEqual([])
  })

  test('in the row no cursor and no touch says that a chip can be grabbed', async ({ stage }) => {
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

test('what decorates a stage lies behind the chips, in the pile and on paper', async ({ stage, page }) => {
  await stage.open('pile')
  await expect(stage.chips.nth(4)).toHaveAttribute('data-state', 'falling')
  await page.emulateMedia({ media: 'print' })
  expect(await covered(stage, page)).toBe(0)
  await page.emulateMedia({ media: 'screen' })
  await stage.reaches('resting')
  expect(await covered(stage, page)).toBe(0)
})

test.describe('without script', () => {
  test.use({ javaScriptEnabled: false })

  test('every chip is readable in the row', async ({ page }) => {
    await page.goto('/pile')
    const boxes = await page.locator('[data-slot=gravity-stack-chip]').all()
    const stage = (await page.locator('[data-slot=gravity-stack]').boundingBox())!
    expect(boxes).toHaveLength(12)
    for (const chip of boxes) {
      await expect(chip).toBeVisible()
      const box = (await chip.boundingBox())!
      expect(box.y).toBeGreaterThanOrEqual(stage.y)
      expect(box.y + box.height).toBeLessThanOrEqual(stage.y + stage.height)
    }
    const bottoms = await Promise.all(boxes.map(async (chip) => (await chip.boundingBox())!))
    expect(Math.max(...bottoms.map((box) => box.y + box.height))).toBeCloseTo(stage.y + stage.height - 16, 0)
  })
})

test('before the script has come, people whose chips will fall see no row that then vanishes', async ({
  stage,
  page,
}) => {
  await page.route('**/client-*.js', () => {})
  await page.goto('/pile', { waitUntil: 'commit' })
  await expect(stage.chips).toHaveCount(12)
  // The stylesheet has come.
  await expect(stage.root).toHaveCSS('position', 'relative')
  const before = await stage.root.screenshot()
  await stage.root.evaluate((root) => root.replaceChildren())
  expect(before.equals(await stage.root.screenshot())).toBe(true)
})

test('nothing on the page shifts while the stage comes to life', async ({ stage, page }) => {
  await page.addInitScript(() => {
    const shifts: number[] = []
    Object.assign(window, { shifts })
    new PerformanceObserver((list) => {
      for (const entry of list.getEntries()) shifts.push((entry as unknown as { value: number }).value)
    }).observe({ type: 'layout-shift', buffered: true })
  })
  await stage.settled('pile', { chips: 20, below: 200 })
  expect(await page.evaluate(() => (window as unknown as { shifts: number[] }).shifts)).toEqual([])
})

test('on paper the pile is a row, before, during and after the fall; on screen it goes on where it was', async ({
  stage,
  page,
}) => {
  await page.setViewportSize({ width: 800, height: 500 })
  await stage.open('pile', { above: 1500 })
  await stage.reaches('static')
  await page.emulateMedia({ media: 'print' })
  expect(await readable(page)).toEqual(row)
  await page.emulateMedia({ media: 'screen' })
  await page.setViewportSize({ width: 1280, height: 720 })
  await stage.open('pile')
  await expect(stage.chips.nth(4)).toHaveAttribute('data-state', 'falling')
  await page.emulateMedia({ media: 'print' })
  expect(await readable(page)).toEqual(row)
  await stage.reaches('static')
  await page.emulateMedia({ media: 'screen' })
  await stage.reaches('resting')
  const { poses } = await stage.pile()
  await page.emulateMedia({ media: 'print' })
  expect(await readable(page)).toEqual(row)
  await page.emulateMedia({ media: 'screen' })
  await stage.reaches('resting')
  expect((await stage.pile()).poses).toEqual(poses)
})

test('in forced colours every chip keeps an outline, and the focused control its own', async ({
  stage,
  page,
}) => {
  await page.emulateMedia({ forcedColors: 'active' })
  await stage.settled('controls')
  const outlines = () =>
    stage.chips.evaluateAll((all) =>
      all.map((chip) => {
        const { outlineStyle, outlineOffset } = getComputedStyle(chip.firstElementChild!)
        return `${outlineStyle} ${outlineOffset}`
      }),
    )
  // Just inside the chip: at the walls the stage would cut it off.
  expect(new Set(await outlines())).toEqual(new Set(['solid -1px']))
  await page.getByText('before').focus()
  await page.keyboard.press('Tab')
  expect((await outlines())[0]).toMatch(/^auto/)
})

test('in forced colours a chip of mere words has an outline too', async ({ stage, page }) => {
  await page.emulateMedia({ forcedColors: 'active' })
  await stage.settled('surroundings', { kind: 'texts' })
  for (const chip of await stage.chips.all()) {
    await expect(chip).toHaveCSS('outline-style', 'solid')
    await expect(chip).toHaveCSS('outline-offset', '-1px')
  }
})

test('drop() leaves a pile that stands in its row alone: it lies as before once motion is welcome again', async ({
  stage,
  page,
}) => {
  await stage.settled('surroundings', { kind: 'front' })
  const { poses } = await stage.pile()
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await stage.reaches('static')
  await page.locator('#drop').click()
  await page.emulateMedia({ reducedMotion: 'no-preference' })
  await stage.reaches('resting')
  expect((await stage.pile()).poses).toEqual(poses)
})

for (const state of ['waiting', 'running', 'resting']) {
  test(`axe finds nothing while the stage is ${state}`, async ({ stage, page }) => {
    await page.setViewportSize({ width: 800, height: 500 })
    await stage.open('controls', {
      above: state === 'waiting' ? 440 : 0,
      stagger: state === 'running' ? 60000 : 50,
    })
    await stage.reaches(state)
    expect(
      (await new AxeBuilder({ page }).include('[data-slot=gravity-stack]').analyze()).violations,
    ).toEqual([])
  })
}

test('axe finds nothing while the stage is paused in mid-fall', async ({ stage, page }) => {
  await stage.open('extras')
  await expect(stage.chips.nth(2)).toHaveAttribute('data-state', 'falling')
  await page.locator('#pause').click()
  await stage.reaches('paused')
  expect((await new AxeBuilder({ page }).include('[data-slot=gravity-stack]').analyze()).violations).toEqual(
    [],
  )
  await stage.reaches('paused')
})

test('axe finds nothing while a chip is held', async ({ stage, page }) => {
  await stage.settled('controls')
  const chip = stage.chip('plain')
  await stage.drag(chip, 20, -60)
  await expect(chip).toHaveAttribute('data-state', 'held')
  expect((await new AxeBuilder({ page }).include('[data-slot=gravity-stack]').analyze()).violations).toEqual(
    [],
  )
  await expect(chip).toHaveAttribute('data-state', 'held')
  await page.mouse.up()
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

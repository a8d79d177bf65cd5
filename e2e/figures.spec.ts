import { expect } from '@playwright/test'
import { painted, test, watchShifts } from './page'

test.describe('how it works', () => {
  test('each figure can be scrubbed with the keyboard', async ({ page }) => {
    await page.emulateMedia({ reducedMotion: 'reduce' })
    await page.goto('/docs/how-it-works')
    const times = page.getByLabel('Time', { exact: true })
    await expect(times).toHaveCount(7)
    for (const time of await times.all()) {
      await time.scrollIntoViewIfNeeded()
      await time.focus()
      await page.keyboard.press('End')
      await page.keyboard.press('ArrowLeft')
      await expect(time).not.toHaveValue('0')
    }
  })

  test('the figures run the solver: an impact meets its formula, a flight its curve', async ({ page }) => {
    await page.emulateMedia({ reducedMotion: 'reduce' })
    await page.goto('/docs/how-it-works')
    const [flight, impact] = await page.locator('[data-slot=figure]').all()
    await flight.getByLabel('Time', { exact: true }).press('End')
    await expect(flight).toContainText(/this solver (0|\d\.\d\s·\s10⁻¹.)\spx/)
    await impact.getByLabel('Time', { exact: true }).press('End')
    await expect(impact).toContainText(/Speed ([\d.]+) px\/sby formula \1/)
    await expect(impact).toContainText(/Spin ([\d.]+) rad\/sby formula \1/)
  })

  test('on paper every figure stands at a moment that shows something', async ({ page }) => {
    await page.emulateMedia({ reducedMotion: 'reduce' })
    await page.goto('/docs/how-it-works')
    const times = page.getByLabel('Time', { exact: true })
    await expect(times).toHaveCount(7)
    await expect(async () => {
      await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')))
      expect(
        await times.evaluateAll((all) => all.map((time) => (time as HTMLInputElement).value)),
      ).not.toContain('0')
    }).toPass()
    for (const figure of await page.locator('[data-slot=figure]').all()) {
      await expect(figure).not.toContainText('…')
    }
    // Where somebody has left it, it stays.
    await times.first().press('Home')
    await times.first().press('ArrowRight')
    await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')))
    await expect(times.first()).toHaveValue('1')
  })

  test('a figure plays when it is seen, unless the reader prefers reduced motion', async ({ page }) => {
    await page.goto('/docs/how-it-works')
    const time = page.getByLabel('Time', { exact: true }).first()
    await page.locator('[data-slot=figure] canvas').first().scrollIntoViewIfNeeded()
    await expect(time).not.toHaveValue('0')
    await page.emulateMedia({ reducedMotion: 'reduce' })
    await page.reload()
    await page.locator('[data-slot=figure] canvas').first().scrollIntoViewIfNeeded()
    await expect(page.locator('[data-slot=figure]').first()).toContainText('px')
    await expect(time).toHaveValue('0')
  })
})

test('every control of a figure changes what it says', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/docs/how-it-works')
  const figures = page.locator('[data-slot=figure]')
  await expect(figures).toHaveCount(7)
  for (const figure of await figures.all()) {
    await figure.scrollIntoViewIfNeeded()
    const time = figure.getByLabel('Time', { exact: true })
    await time.press('End')
    await time.press('ArrowLeft')
    const said = figure.locator(':scope > div > div').last()
    await expect(said).not.toContainText('…')
    for (const control of await figure
      .locator('input:not([id$=time])[type=range], input[type=radio]:not(:checked)')
      .all()) {
      const before = await said.textContent()
      if ((await control.getAttribute('type')) === 'radio') await control.press('Space')
      else
        await control.press('ArrowLeft').then(async () => {
          if ((await said.textContent()) === before) await control.press('ArrowRight')
        })
      await expect(said).not.toHaveText(before!)
    }
  }
})

test('a box slides as far as its friction lets it', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/docs/how-it-works')
  const friction = page.getByRole('slider', { name: 'Friction' })
  const figure = page.locator('[data-slot=figure]', { has: friction })
  await friction.press('End')
  await figure.getByLabel('Time', { exact: true }).press('End')
  await expect(figure).toContainText(/Box: gone (\d+)\.\d+ px\s*of \1\./)
})

test('with all asleep the islands figure asks for no frame', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/docs/how-it-works')
  const figure = page.locator('[data-slot=figure]', {
    has: page.getByRole('img', { name: /^Chips pour onto the floor/ }),
  })
  await figure.scrollIntoViewIfNeeded()
  await figure.getByLabel('Time', { exact: true }).press('End')
  await expect(figure).toContainText('Awake 0 of 14')
  await expect(figure).toContainText('Frame callbacks none')
})

test('of the same drop, as released and planned, half turns leave every outline where it is and no word upside down', async ({
  page,
}) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/docs/how-it-works')
  const drop = page.getByRole('slider', { name: 'Drop' })
  const figure = page.locator('[data-slot=figure]', { has: drop })
  const time = figure.getByLabel('Time', { exact: true })
  for (let number = 1; number <= 9; number++) {
    await expect(drop).toHaveValue(String(number))
    await time.press('End')
    await expect(figure).toContainText(/as released [1-9]\d* of 12/)
    await expect(figure).toContainText('planned 0 of 12')
    // In the middle of the fall too.
    for (const frame of ['90', '200']) {
      await time.fill(frame)
      await expect(figure).toContainText(/Outlines apart (0|\d(\.\d)?\s·\s10⁻¹.)\spx/)
    }
    await drop.press('ArrowRight')
  }
})

test('a figure plays to its end at a press, and again from its start at another', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/docs/how-it-works')
  const figure = page.locator('[data-slot=figure]').first()
  const time = figure.getByLabel('Time', { exact: true })
  const last = (await time.getAttribute('max'))!
  await figure.getByRole('button', { name: 'Play' }).click()
  await expect(time).toHaveValue(last)
  await figure.getByRole('button', { name: 'Play' }).click()
  await expect(figure.getByRole('button', { name: 'Pause' })).toBeVisible()
  await expect(time).not.toHaveValue(last)
})

test('a figure that was paused stays so when it is seen again', async ({ page }) => {
  await page.goto('/docs/how-it-works')
  const figure = page.locator('[data-slot=figure]').first()
  const picture = figure.getByRole('img')
  await picture.scrollIntoViewIfNeeded()
  await figure.getByRole('button', { name: 'Pause' }).click()
  await page.evaluate(() => scrollTo(0, document.body.scrollHeight))
  await expect(picture).not.toBeInViewport()
  await picture.evaluate(async (canvas) => {
    canvas.scrollIntoView({ block: 'center' })
    await new Promise<void>((done) => {
      const seen = ([entry]: IntersectionObserverEntry[]) => entry.intersectionRatio > 0.9 && done()
      new IntersectionObserver(seen, { threshold: 0.9 }).observe(canvas)
    })
    // Who has heard of it as well has drawn what comes of it.
    for (let frame = 0; frame < 3; frame++) await new Promise(requestAnimationFrame)
  })
  // Not in the end: by then it has played.
  expect(await figure.getByRole('button').textContent()).toBe('Play')
})

test('what passes while a laptop is closed is not played, and who scrubs pauses', async ({ page }) => {
  await page.clock.install({ time: 0 })
  await page.clock.pauseAt(1000)
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/docs/how-it-works')
  const figure = page.locator('[data-slot=figure]').nth(1)
  await figure.getByRole('button', { name: 'Play' }).click()
  const shown = async () => Number(await figure.getByLabel('Time', { exact: true }).inputValue())
  // At half the speed of life.
  await page.clock.runFor(500)
  const before = await shown()
  expect(Math.abs(before - 15)).toBeLessThan(3)
  await page.clock.fastForward(600_000)
  await page.clock.runFor(100)
  expect(await shown()).toBeLessThan(before + 9)
  await expect(figure.getByRole('button', { name: 'Pause' })).toBeVisible()
  await figure.getByLabel('Time', { exact: true }).press('ArrowLeft')
  await expect(figure.getByRole('button', { name: 'Play' })).toBeVisible()
})

test('a figure is drawn anew in the colours of another theme', async ({ page }) => {
  await page.emulateMedia({ colorScheme: 'light', reducedMotion: 'reduce' })
  await page.goto('/docs/how-it-works')
  const picture = page.locator('[data-slot=figure]').first().getByRole('img')
  await picture.scrollIntoViewIfNeeded()
  const drawn = () => picture.evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL())
  const empty = await page.evaluate(() => document.createElement('canvas').toDataURL())
  await expect.poll(drawn).not.toBe(empty)
  const light = await drawn()
  await page.emulateMedia({ colorScheme: 'dark' })
  await expect.poll(async () => (await drawn()) === light).toBe(false)
  await page.emulateMedia({ colorScheme: 'light' })
  await expect.poll(async () => (await drawn()) === light).toBe(true)
})

test.describe('on a fine screen', () => {
  test.use({ deviceScaleFactor: 2 })

  test('a figure is drawn to the screen’s own pixels, at any width', async ({ page }) => {
    await page.emulateMedia({ reducedMotion: 'reduce' })
    await page.goto('/docs/how-it-works')
    const picture = page.locator('[data-slot=figure]').first().getByRole('img')
    await picture.scrollIntoViewIfNeeded()
    const scale = () => picture.evaluate((canvas: HTMLCanvasElement) => canvas.width / canvas.clientWidth)
    for (const width of [1280, 500]) {
      await page.setViewportSize({ width, height: 700 })
      await expect.poll(scale).toBeCloseTo(2, 1)
    }
  })
})

test('another scene or seed starts at its beginning, and leaves the focus where it is', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/docs/stability')
  const figures = page.locator('[data-slot=figure]')
  await expect(figures).toHaveCount(2)
  for (const figure of await figures.all()) {
    await figure.scrollIntoViewIfNeeded()
    await expect(figure).not.toContainText('…')
    const time = figure.getByLabel('Time', { exact: true })
    const toEnd = async () => {
      await time.press('End')
      await expect(time).not.toHaveValue('0')
    }
    await toEnd()
    const seed = figure.getByRole('button', { name: /^Seed/ })
    await seed.press('Enter')
    await expect(seed).toHaveText(/^Seed 2/)
    await expect(seed).toBeFocused()
    await expect(time).toHaveValue('0')
    await toEnd()
    const scene = figure.getByRole('combobox', { name: 'Scene' })
    const before = await scene.inputValue()
    await scene.press('ArrowUp')
    await expect(scene).not.toHaveValue(before)
    await expect(scene).toBeFocused()
    await expect(time).toHaveValue('0')
    await page.emulateMedia({ reducedMotion: 'no-preference' })
    await scene.press('ArrowDown')
    await expect(time).not.toHaveValue('0')
    await expect(seed).toHaveText(/^Seed 1 /)
    await page.emulateMedia({ reducedMotion: 'reduce' })
  }
})

test('after the last seed comes the first', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/docs/stability')
  const seed = page.locator('[data-slot=figure]').last().getByRole('button', { name: /^Seed/ })
  await expect(seed).toHaveText('Seed 1 of 12: next')
  // Faster than any of them is computed.
  await seed.evaluate(async (button: HTMLElement) => {
    for (let presses = 0; presses < 11; presses++) {
      button.click()
      await Promise.resolve()
    }
  })
  await expect(seed).toHaveText('Seed 12 of 12: next')
  await seed.click()
  await expect(seed).toHaveText('Seed 1 of 12: next')
})

test('a scene is seen to be chosen before the page is busy with it, and no scene moves its controls', async ({
  page,
}) => {
  await page.goto('/docs/stability')
  for (const [n, scene] of ['A column of forty boxes stands', 'A pill falls for a second'].entries()) {
    const figure = page.locator('[data-slot=figure]').nth(n)
    await figure.scrollIntoViewIfNeeded()
    await expect(figure.locator('strong').first()).toBeVisible()
    const choice = figure.getByRole('combobox', { name: 'Scene' })
    const picture = figure.getByRole('img')
    const { height } = (await picture.boundingBox())!
    const before = await picture.getAttribute('aria-label')
    const atOnce = await choice.evaluate(async (select: HTMLSelectElement, text) => {
      select.selectedIndex = [...select.options].findIndex((option) => option.text.includes(text))
      select.dispatchEvent(new Event('change', { bubbles: true }))
      await Promise.resolve()
      return select.closest('[data-slot=figure]')!.querySelector('canvas')!.ariaLabel
    }, scene)
    expect(atOnce).toBe(before)
    await expect(picture).toHaveAccessibleName(new RegExp(scene))
    expect((await picture.boundingBox())!.height, 'a scene higher than wide is drawn smaller').toBeLessThan(
      2 * height,
    )
  }
})

for (const path of ['/docs/how-it-works', '/docs/stability']) {
  test(`at 320 px nothing on ${path} moves when a figure gets its numbers`, async ({ page }) => {
    // Played, numbers that grow wider move the next ones.
    await page.emulateMedia({ reducedMotion: 'reduce' })
    const shifted = await watchShifts(page)
    await page.setViewportSize({ width: 320, height: 900 })
    await page.goto(path)
    for (const figure of await page.locator('[data-slot=figure]').all()) {
      await figure.scrollIntoViewIfNeeded()
      await expect(figure.locator('strong').first()).toBeVisible()
    }
    await painted(page)
    expect(await shifted()).toBeLessThan(0.01)
  })
}

test('a scene that breaks solvers is drawn with both its walls', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/docs/stability')
  const canvas = page.locator('[data-slot=figure] canvas').first()
  const walls = () =>
    canvas.evaluate((element: HTMLCanvasElement) => {
      const { width, height } = element
      const { data } = element.getContext('2d')!.getImageData(0, 0, width, height)
      return [0, width - 1].map((x) =>
        Array.from({ length: height }, (_, y) => data[4 * (y * width + x) + 3]).every((alpha) => alpha > 0),
      )
    })
  await expect.poll(walls).toEqual([true, true])
})

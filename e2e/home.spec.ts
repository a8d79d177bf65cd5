import { readFileSync } from 'node:fs'
import { expect } from '@playwright/test'
import { test } from './page'

const json = (file: string) => JSON.parse(readFileSync(`bench/results/${file}`, 'utf8'))

for (const size of [
  { width: 1280, height: 720 },
  { width: 375, height: 667 },
]) {
  test(`at ${size.width} px the first screen says what it is, what it costs and how to add it`, async ({
    page,
  }) => {
    await page.setViewportSize(size)
    await page.goto('/')
    const words = [
      'A React component whose children drop in',
      /^\d+\.\d kB not counting React and cn$/,
      /^\d+ µs of physics a frame, 60 chips$/,
      /^0 frames at rest$/,
    ]
    for (const word of words) await expect(page.getByText(word)).toBeInViewport({ ratio: 1 })
    // The command is longer than a narrow screen, and scrolls.
    await expect(page.getByText('npx shadcn@latest add')).toBeInViewport()
    await expect(page.getByRole('button', { name: 'Copy command' })).toBeInViewport({ ratio: 1 })
  })
}

for (const [width, height] of [
  [640, 900],
  [768, 1024],
  [820, 1180],
  [1024, 768],
  [1280, 720],
  [1440, 900],
]) {
  test(`at ${width} × ${height} the pile at rest covers neither the command nor the button under it`, async ({
    page,
  }) => {
    await page.setViewportSize({ width, height })
    await page.goto('/')
    await expect(page.locator('[data-slot=gravity-stack]')).toHaveAttribute('data-state', 'resting')
    const free = [
      page.locator('section .code', { has: page.getByText('npx shadcn') }),
      page.getByRole('link', { name: 'Read the docs' }),
    ]
    for (const words of free) {
      const covers = await words.evaluate((element) => {
        const { left, right, top, bottom } = element.getBoundingClientRect()
        const found = new Set<string>()
        for (let x = left + 4; x < right; x += 8) {
          for (let y = top + 4; y < bottom; y += 8) {
            const chip = document.elementFromPoint(x, y)?.closest('[data-slot=gravity-stack-chip]')
            if (chip) found.add(chip.textContent!)
          }
        }
        return [...found]
      })
      expect(covers).toEqual([])
    }
  })
}

test('the home page has the figures of the committed benchmark', async ({ page }) => {
  const { cost } = json('results.json').pourCosts.find(
    (row: { engine: string; chips: number }) => row.engine === 'gravity-stack' && row.chips === 60,
  )
  const { script } = json('browser.json').stages['gravity-stack'].drops.find(
    (drop: { chips: number; throttle: number }) => drop.chips === 60 && drop.throttle === 1,
  )
  await page.goto('/')
  await expect(page.getByText(`${Math.round(cost.mean)} µs`, { exact: true })).toHaveCount(2)
  await expect(page.getByText(`${script.median.toFixed(1)} ms of script`)).toBeVisible()
})

test('the home page performs what its buttons say and shows the code for it', async ({ page }) => {
  await page.goto('/')
  const stage = page.locator('[data-slot=gravity-stack]')
  const colour = () =>
    page.getByText('grab me', { exact: true }).evaluate((chip) => getComputedStyle(chip).backgroundColor)
  await expect(stage).toHaveAttribute('data-state', 'resting')
  const tinted = await colour()
  await page.getByRole('button', { name: 'Neutral' }).click()
  await expect(page.getByText('bg-elevation-3')).toBeVisible()
  await expect.poll(colour).not.toBe(tinted)
  await page.getByRole('button', { name: 'Tinted' }).click()
  await expect(page.getByText('bg-amber-300')).toBeVisible()
  await expect.poll(colour).toBe(tinted)
  const moves = {
    'Drop again': 'actions.current?.drop()',
    Shake: 'actions.current?.shake()',
    Heavier: 'gravity={6000}',
    Bouncier: 'bounce={0.7}',
  }
  for (const [name, code] of Object.entries(moves)) {
    await expect(stage).toHaveAttribute('data-state', 'resting')
    await page.getByRole('button', { name }).click()
    await expect(stage).toHaveAttribute('data-state', 'running')
    await expect(page.getByText(code)).toBeVisible()
  }
  // The code is of all that is set, not of the last press alone.
  for (const code of ['bg-amber-300', 'gravity={6000} bounce={0.7}', 'import { useRef }'])
    await expect(page.getByText(code)).toBeVisible()
})

test('on the home page an action is not left pressed, and leaves what was set as it is', async ({ page }) => {
  await page.goto('/')
  const stage = page.locator('[data-slot=gravity-stack]')
  const pressed = page.locator('button[aria-pressed=true]')
  await expect(stage).toHaveAttribute('data-state', 'resting')
  await expect(pressed).toHaveText(['Tinted'])
  await page.getByRole('button', { name: 'Heavier' }).click()
  await page.getByRole('button', { name: 'Neutral' }).click()
  for (const name of ['Drop again', 'Shake']) {
    await page.getByRole('button', { name }).click()
    await expect(pressed).toHaveText(['Neutral', 'Heavier'])
    await expect(stage).toHaveAttribute('data-state', 'resting')
  }
  await page.getByRole('button', { name: 'Heavier' }).click()
  await expect(stage).toHaveAttribute('data-state', 'running')
  await expect(pressed).toHaveText(['Neutral'])
  await expect(page.getByText('gravity={6000}')).toHaveCount(0)
})

for (const name of ['Heavier', 'Bouncier'])
  test(`${name} on the home page makes another pile, and the first one comes back without it`, async ({
    page,
  }) => {
    await page.goto('/')
    const stage = page.locator('[data-slot=gravity-stack]')
    const pile = async () => {
      await expect(stage).toHaveAttribute('data-state', 'resting')
      return stage
        .locator('[data-slot=gravity-stack-chip]')
        .evaluateAll((all) => all.map((e) => new DOMMatrix(getComputedStyle(e).transform).e))
    }
    const first = await pile()
    const moved = async () => {
      await page.getByRole('button', { name }).click()
      await expect(stage).toHaveAttribute('data-state', 'running')
      return Math.max(...(await pile()).map((x, i) => Math.abs(x - first[i])))
    }
    expect(await moved()).toBeGreaterThan(5)
    expect(await moved()).toBeLessThan(1)
  })

test('the drop on the home page can be paused, and goes on with whatever is pressed next', async ({
  page,
}) => {
  await page.goto('/')
  const stage = page.locator('[data-slot=gravity-stack]')
  const pause = page.getByRole('button', { name: 'Pause' })
  for (const next of ['Resume', 'Shake', 'Drop again', 'Heavier']) {
    await expect(stage).toHaveAttribute('data-state', 'resting')
    await page.getByRole('button', { name: 'Drop again' }).click()
    await expect(stage).toHaveAttribute('data-state', 'running')
    await pause.click()
    await expect(stage).toHaveAttribute('data-state', 'paused')
    await expect(page.getByText('actions.current?.pause()')).toBeVisible()
    // One button for both, which the keyboard stays on.
    await expect(page.getByRole('button', { name: 'Resume' })).toBeFocused()
    await page.getByRole('button', { name: next }).click()
    await expect(stage).toHaveAttribute('data-state', 'running')
    await expect(pause).toBeVisible()
  }
})

test('with reduced motion the home page says why its buttons do nothing, on paper it has none', async ({
  page,
}) => {
  await page.goto('/')
  const why = page.getByText('Motion is off, as your system asks.')
  await expect(why).toBeHidden()
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await expect(why).toBeVisible()
  await page.emulateMedia({ media: 'print' })
  await expect(page.getByRole('button', { name: 'Shake' })).toBeHidden()
})

test('the tints of the home page are those in its code', async ({ page }) => {
  await page.goto('/')
  await page.getByRole('button', { name: 'Tinted' }).click()
  const code = await page.locator('pre', { hasText: 'const tints' }).textContent()
  const chips = page.locator('[data-slot=gravity-stack-chip] > span')
  for (const [index, name] of [...code!.matchAll(/'(bg-[\w-]+)'/g)].map(([, name]) => name).entries())
    await expect(chips.nth(index)).toContainClass(name)
})

test.describe('without script', () => {
  test.use({ javaScriptEnabled: false })

  test('a visitor flips the words of a pile over and back, and no chip moves', async ({ page }) => {
    await page.emulateMedia({ reducedMotion: 'reduce' })
    await page.goto('/')
    const flip = page.getByRole('group', { name: 'How the words of a pile lie' })
    const upsideDown = () =>
      flip.locator('text').evaluateAll(
        (words) =>
          words.filter((word) => {
            const { b, a } = (word as SVGTextElement).getScreenCTM()!
            return Math.cos(Math.atan2(b, a)) < 0
          }).length,
      )
    const centres = () =>
      flip.locator('rect').evaluateAll((rects) =>
        (rects as SVGRectElement[]).map((rect) => {
          const { x, y, width, height } = rect.getBoundingClientRect()
          const { top } = rect.ownerSVGElement!.getBoundingClientRect()
          return [x + width / 2, y + height / 2 - top].map((value) => Math.round(value))
        }),
      )
    await expect(flip.getByText('0 of 12 words upside down')).toBeVisible()
    expect(await upsideDown()).toBe(0)
    const before = await centres()
    await flip.getByText('As chips fall').click()
    const fallen = await upsideDown()
    expect(fallen).toBeGreaterThan(2)
    await expect(flip.getByText(`${fallen} of 12 words upside down`)).toBeVisible()
    expect(await centres()).toEqual(before)
    await flip.getByText('The right way up').click()
    expect(await upsideDown()).toBe(0)
  })
})

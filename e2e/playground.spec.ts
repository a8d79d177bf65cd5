import { expect, type Page } from '@playwright/test'
import { test } from './alive'

const stage = '[data-slot=playground-stage]'

/** How many colours of islands the overlay shows, and how many px are grey or the red of contacts. */
const colours = (page: Page) =>
  page.locator(`${stage} canvas`).evaluate((canvas: HTMLCanvasElement) => {
    const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height)
    const islands = new Map<string, number>()
    const count = { grey: 0, red: 0 }
    for (let i = 0; i < data.length; i += 4) {
      const [r, g, b, alpha] = data.subarray(i, i + 4)
      if (alpha < 255) continue
      if (r === 0xba && g === 0xb3 && b === 0xab) count.grey++
      else if (r > 180 && g < 110 && b < 110) count.red++
      else if (Math.max(r, g, b) - Math.min(r, g, b) > 60) {
        const colour = [r, g, b].join()
        islands.set(colour, (islands.get(colour) ?? 0) + 1)
      }
    }
    // A hull has thousands, a smoothed edge a few.
    return { ...count, islands: [...islands.values()].filter((pixels) => pixels > 800).length }
  })

test('the overlay tints islands while they move, greys what sleeps, and draws contacts with their forces', async ({
  page,
}) => {
  // Nothing falls before the first press on Step.
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/playground?count=12&shape=boxes&stagger=0')
  await expect(page.getByText('Motion is off')).toBeVisible()
  await page.getByRole('button', { name: 'Overlay' }).click()
  await expect(page.getByText('dots are contact points')).toBeVisible()
  await expect(async () => {
    await page.getByRole('button', { name: 'Step' }).click()
    expect((await colours(page)).islands).toBeGreaterThan(2)
  }).toPass({ intervals: [0] })
  await page.getByRole('button', { name: 'Play' }).click()
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
  const { islands, grey, red } = await colours(page)
  expect(islands).toBe(0)
  expect(grey).toBeGreaterThan(12 * 800)
  // Two points and two lines at least under each box.
  expect(red).toBeGreaterThan(12 * 2 * 6)
})

test('the numbers say what the solver did in the last step', async ({ page }) => {
  await page.goto('/playground?count=12&shape=boxes')
  const number = (name: string) => page.locator('dt', { hasText: new RegExp(`^${name}$`) }).locator('+ dd')
  const names = ['awake chips', 'pairs', 'contacts', 'islands', 'sub-steps, all islands', 'µs a step']
  for (const name of names) await expect(number(name)).not.toHaveText('0')
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
  for (const name of names) await expect(number(name)).toHaveText('0')
})

test('after Pause, Drop drops the chips and they come to rest', async ({ page }) => {
  await page.goto('/playground?count=3')
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
  await page.getByRole('button', { name: 'Pause' }).click()
  await page.getByRole('button', { name: 'Drop' }).click()
  await expect(page.getByRole('button', { name: 'Pause' })).toBeVisible()
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'running')
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
})

test('other chips on a paused stage wait, and the stage says how to drop them', async ({ page }) => {
  await page.goto('/playground?count=3')
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
  await page.getByRole('button', { name: 'Pause' }).click()
  await page.getByLabel('Shape').selectOption('boxes')
  await expect(page.getByText('Paused. Play drops the chips.')).toBeVisible()
  await page.getByRole('button', { name: 'Play' }).click()
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
  await expect(page.getByText('Paused.')).toBeHidden()
})

test('slider and code read an address alike, and words that were taken out stay out', async ({ page }) => {
  await page.goto('/playground?count=3.7&gravity=&words=')
  await expect(page.getByLabel('Chips')).toHaveValue('4')
  await expect(page.locator(`${stage} [data-chip]`)).toHaveText(['chip', 'chip', 'chip', 'chip'])
  await expect(page.getByText('Array.from({ length: 4 }')).toBeVisible()
  await expect(page.getByLabel('gravity')).toHaveValue('2600')
  await expect(page.getByLabel('Words, with commas between')).toHaveValue('')
})

test('of an address with a whole book in it the playground takes the first 500 letters', async ({ page }) => {
  await page.goto(`/playground?words=${'a'.repeat(3000)}`)
  await expect(page.getByLabel('Words, with commas between')).toHaveValue('a'.repeat(500))
})

test('the seed is said not to be in the code, and is not', async ({ page }) => {
  await page.goto('/playground?seed=7')
  await expect(page.getByLabel('Seed (not in the code)')).toHaveValue('7')
  await expect(page.getByText('<GravityStack className="h-96">')).toBeVisible()
})

test('in forced colours each chip has an outline', async ({ page }) => {
  await page.emulateMedia({ forcedColors: 'active' })
  await page.goto('/playground?count=4&shape=mixed')
  const chips = page.locator(`${stage} [data-chip] > span`)
  await expect(chips).toHaveCount(4)
  for (const chip of await chips.all()) await expect(chip).toHaveCSS('outline-style', 'solid')
})

test('long words stay inside their discs, and discs are round', async ({ page }) => {
  // Upright, above the stage, where they can be measured.
  await page.emulateMedia({ reducedMotion: 'reduce' })
  const words = ['ok', 'Responsiveness', 'Words that go on', 'Donaudampfschifffahrtsgesellschaft']
  await page.goto(`/playground?shape=discs&count=4&words=${words.join()}`)
  const chips = page.locator(`${stage} [data-chip] > span`)
  await expect(chips).toHaveText(words)
  for (const chip of await chips.all()) {
    const { width, height, over } = await chip.evaluate((disc) => {
      const text = document.createRange()
      text.selectNodeContents(disc)
      const [inner, outer] = [text.getBoundingClientRect(), disc.getBoundingClientRect()]
      return {
        width: outer.width,
        height: outer.height,
        over: Math.max(outer.left - inner.left, inner.right - outer.right, outer.top - inner.top),
      }
    })
    expect(width).toBeCloseTo(height, 0)
    expect(over).toBeLessThanOrEqual(0)
  }
})

test('a slider of the playground acts on the chips in the air', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/playground?count=1&stagger=0')
  const chip = page.locator('[data-chip]')
  const height = () => chip.evaluate((e) => new DOMMatrix(getComputedStyle(e).transform).f)
  const step = async () => {
    await page.getByRole('button', { name: 'Step' }).click()
    return height()
  }
  const waiting = await height()
  await expect.poll(step, { intervals: [0] }).not.toBe(waiting)
  await page.getByLabel('gravity').press('Home')
  const [a, b, c] = [await step(), await step(), await step()]
  expect(c - b - (b - a)).toBeCloseTo(0, 0)
})

test('at 1/20 of the speed a second is three frames', async ({ page }) => {
  await page.clock.install({ time: 0 })
  await page.clock.pauseAt(1000)
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/playground?count=1&stagger=0')
  await page.getByRole('button', { name: 'Speed 1/20×' }).click()
  await page.getByRole('button', { name: 'Play' }).click()
  await page.clock.runFor(1000)
  await expect(page.locator('dt', { hasText: 'awake chips' }).locator('+ dd')).toHaveText('0')
  await page.getByRole('button', { name: 'Speed 1×' }).click()
  await page.clock.runFor(200)
  await expect(page.locator('dt', { hasText: 'awake chips' }).locator('+ dd')).toHaveText('1')
})

test('words, look and interactive of the playground are those of its chips', async ({ page }) => {
  await page.goto('/playground?count=2')
  const stage = page.locator('[data-slot=playground-stage]')
  const chips = stage.locator('[data-chip]')
  await page.getByLabel('Words').fill('here, there')
  await expect(chips).toHaveText(['here', 'there'])
  const colour = () =>
    chips.locator('span').evaluateAll((all) => all.map((e) => getComputedStyle(e).backgroundColor))
  const tinted = await colour()
  expect(tinted[0]).not.toBe(tinted[1])
  await page.getByLabel('Look').selectOption('ink')
  await expect.poll(colour).not.toEqual(tinted)
  await expect(stage).toHaveAttribute('data-state', 'resting')
  const press = async (button: 'left' | 'right') => {
    const { x, y, width, height } = (await chips.first().boundingBox())!
    await page.mouse.move(x + width / 2, y + height / 2)
    await page.mouse.down({ button })
    await page.mouse.move(x + width / 2, y - 60, { steps: 4 })
  }
  await press('right')
  await page.mouse.up({ button: 'right' })
  await expect(stage).toHaveAttribute('data-state', 'resting')
  await page.getByLabel('interactive').uncheck()
  await press('left')
  await page.evaluate(() => new Promise((r) => requestAnimationFrame(() => requestAnimationFrame(r))))
  await expect(stage).toHaveAttribute('data-state', 'resting')
  await page.mouse.up()
})

test('in a narrower window the chips of the playground stay inside', async ({ page }) => {
  await page.setViewportSize({ width: 1280, height: 800 })
  await page.goto('/playground')
  const stage = page.locator('[data-slot=playground-stage]')
  await expect(stage).toHaveAttribute('data-state', 'resting')
  await page.setViewportSize({ width: 500, height: 800 })
  const beyond = () =>
    stage.evaluate((e) =>
      Math.max(
        ...[...e.querySelectorAll('[data-chip]')].map((c) => {
          const b = c.getBoundingClientRect(),
            s = e.getBoundingClientRect()
          return (b.left + b.right) / 2 - s.right
        }),
      ),
    )
  await expect.poll(beyond).toBeLessThan(0)
})

test('Reset sets the speed and the overlay back as well', async ({ page }) => {
  await page.goto('/playground?count=1')
  await page.getByRole('button', { name: 'Speed 1/4×' }).click()
  await page.getByRole('button', { name: 'Overlay' }).click()
  await page.getByRole('button', { name: 'Reset' }).click()
  await expect(page.locator('main button[aria-pressed=true]')).toHaveText(['1×'])
})

test('chips whose words come to need more room make it, and stay between the walls', async ({ page }) => {
  await page.goto('/playground?count=30')
  const stage = page.locator('[data-slot=playground-stage]')
  const chips = stage.locator('[data-chip]')
  await expect(stage).toHaveAttribute('data-state', 'resting')
  /** px, how far any pill reaches through a wall. */
  const through = () =>
    stage.evaluate((element) =>
      Math.max(
        ...[...element.querySelectorAll<HTMLElement>('[data-chip]')].map((chip) => {
          const { offsetWidth: w, offsetHeight: h } = chip
          const { a, e } = new DOMMatrix(getComputedStyle(chip).transform)
          const reach = (Math.abs(a) * (w - h) + h) / 2
          return reach - Math.min(e + w / 2, element.clientWidth - e - w / 2)
        }),
      ),
    )
  const width = () => chips.first().evaluate((chip: HTMLElement) => chip.offsetWidth)
  const before = await width()
  await page.addStyleTag({ content: '[data-chip] { letter-spacing: 0.2em }' })
  await expect.poll(width).toBeGreaterThan(before + 5)
  await expect.poll(through).toBeLessThan(1)
})

import { expect } from '@playwright/test'
import { painted, playgroundStage as stage, test } from './page'

test('drops its chips, and all of them lie inside and still', async ({ page }) => {
  await page.goto('/playground')
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
  // How far each outline reaches past wall or floor, px. The box of a turned element is larger than its pill.
  const outside = await page.locator(stage).evaluate((element) =>
    [...element.querySelectorAll<HTMLElement>('[data-chip]')].map((chip) => {
      const { a, b, e, f } = new DOMMatrix(getComputedStyle(chip).transform)
      const [w, h] = [chip.offsetWidth / 2, chip.offsetHeight / 2]
      const radius = Number.parseFloat(getComputedStyle(chip.firstElementChild!).borderTopLeftRadius)
      const r = Math.min(radius, w, h)
      const reachX = Math.abs(a) * (w - r) + Math.abs(b) * (h - r) + r
      const reachY = Math.abs(b) * (w - r) + Math.abs(a) * (h - r) + r
      return Math.max(
        reachX - (e + w),
        e + w + reachX - element.clientWidth,
        f + h + reachY - element.clientHeight,
      )
    }),
  )
  expect(Math.max(...outside)).toBeLessThan(1)
})

test('the address holds the settings, and Reset clears it', async ({ page }) => {
  await page.goto('/playground')
  await page.getByLabel('Shape').selectOption('mixed')
  await page.getByLabel('gravity').focus()
  await page.keyboard.press('ArrowRight')
  await expect(page).toHaveURL(/\?shape=mixed&gravity=2700$/)
  await page.reload()
  await expect(page.getByLabel('Shape')).toHaveValue('mixed')
  await expect(page.getByText('<GravityStack gravity={2700} className="h-96">')).toBeVisible()
  await page.getByRole('button', { name: 'Reset' }).click()
  await expect(page).toHaveURL(/\/playground$/)
  await expect(page.getByLabel('Shape')).toHaveValue('pills')
})

test('a browser that refuses a new address does no harm', async ({ page }) => {
  const errors: string[] = []
  page.on('pageerror', (error) => errors.push(error.message))
  await page.clock.install({ time: 0 })
  await page.clock.pauseAt(1000)
  await page.goto('/playground')
  await page.evaluate(() => {
    Object.assign(window, { refused: 0 })
    const { replaceState } = history
    history.replaceState = (...args) => {
      if (!String(args[2]).includes('gravity=')) return replaceState.apply(history, args)
      Object.assign(window, { refused: (window as unknown as { refused: number }).refused + 1 })
      throw new DOMException('too often', 'SecurityError')
    }
  })
  // Twenty steps of a slider in one go are one address.
  await page.getByLabel('gravity').evaluate((slider: HTMLInputElement) => {
    for (let n = 0; n < 20; n++) {
      slider.stepUp()
      slider.dispatchEvent(new Event('input', { bubbles: true }))
    }
  })
  await expect(page.getByLabel('gravity')).toHaveValue('4600')
  const refused = () => page.evaluate(() => (window as unknown as { refused: number }).refused)
  await page.clock.runFor(1000)
  expect(await refused()).toBe(1)
  await page.clock.runFor(10_000)
  expect(await refused()).toBe(1)
  expect(errors).toEqual([])
})

test('an address that makes no sense does no harm', async ({ page }) => {
  await page.goto('/playground?count=1e9&gravity=NaN&shape=star&words=%2C%2C&bounce=-3')
  await expect(page.locator(`${stage} [data-chip]`)).toHaveCount(60)
  await expect(page.getByLabel('bounce')).toHaveValue('0')
  await expect(page.getByLabel('Shape')).toHaveValue('pills')
})

test('another seed makes another pile; the same seed the same', async ({ page }) => {
  const pile = async (seed: number) => {
    await page.goto(`/playground?count=8&seed=${seed}`)
    await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
    return page
      .locator(`${stage} [data-chip]`)
      .evaluateAll((chips) => chips.map((chip) => (chip as HTMLElement).style.transform))
  }
  const first = await pile(1)
  expect(await pile(2)).not.toEqual(first)
  expect(await pile(1)).toEqual(first)
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

test('Reset sets the speed and the overlay back as well', async ({ page }) => {
  await page.goto('/playground?count=1')
  await page.getByRole('button', { name: 'Speed 1/4×' }).click()
  await page.getByRole('button', { name: 'Overlay' }).click()
  await page.getByRole('button', { name: 'Reset' }).click()
  await expect(page.locator('main button[aria-pressed=true]')).toHaveText(['1×'])
})

test('Reset drops the chips again, also where nothing was changed', async ({ page }) => {
  await page.goto('/playground')
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
  await page.getByRole('button', { name: 'Reset' }).click()
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'running')
})

test('with reduced motion nothing falls before a press on Play, also after Reset', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/playground?count=3')
  const words = page.getByText('Motion is off, as your system asks')
  await expect(words).toBeVisible()
  await page.getByRole('button', { name: 'Play' }).click()
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
  await expect(words).toBeHidden()
  await page.getByRole('button', { name: 'Reset' }).click()
  await expect(words).toBeVisible()
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'paused')
  await expect(page.getByRole('button', { name: 'Play' })).toBeVisible()
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
  for (const chip of await page.locator(`${stage} [data-chip]`).all()) await expect(chip).not.toBeInViewport()
  await page.getByRole('button', { name: 'Play' }).click()
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
  await expect(page.getByText('Paused.')).toBeHidden()
})

test('words, look and interactive of the playground are those of its chips', async ({ page }) => {
  await page.goto('/playground?count=2')
  const room = page.locator(stage)
  const chips = room.locator('[data-chip]')
  await page.getByLabel('Words').fill('here, there')
  await expect(chips).toHaveText(['here', 'there'])
  // A drag marks no words, and a finger's leaves scrolling up and down and zooming to the browser.
  await expect(chips.first()).toHaveCSS('user-select', 'none')
  await expect(chips.first()).toHaveCSS('touch-action', 'pan-y pinch-zoom')
  const colour = () =>
    chips.locator('span').evaluateAll((all) => all.map((e) => getComputedStyle(e).backgroundColor))
  const tinted = await colour()
  expect(tinted[0]).not.toBe(tinted[1])
  await page.getByLabel('Look').selectOption('ink')
  await expect.poll(colour).not.toEqual(tinted)
  await expect(room).toHaveAttribute('data-state', 'resting')
  const press = async (button: 'left' | 'right') => {
    const { x, y, width, height } = (await chips.first().boundingBox())!
    await page.mouse.move(x + width / 2, y + height / 2)
    await page.mouse.down({ button })
    await page.mouse.move(x + width / 2, y - 60, { steps: 4 })
  }
  const takesNothing = async (button: 'left' | 'right') => {
    await press(button)
    await painted(page)
    expect(await room.getAttribute('data-state')).toBe('resting')
    await page.mouse.up({ button })
  }
  await takesNothing('right')
  await page.getByLabel('interactive').uncheck()
  await takesNothing('left')
})

test('chips whose words come to need more room make it, and stay between the walls', async ({ page }) => {
  await page.goto('/playground?count=30')
  const room = page.locator(stage)
  const chips = room.locator('[data-chip]')
  await expect(room).toHaveAttribute('data-state', 'resting')
  /** px, how far any pill reaches through a wall. */
  const through = () =>
    room.evaluate((element) =>
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

test('in a narrower window the chips of the playground stay inside', async ({ page }) => {
  await page.setViewportSize({ width: 1280, height: 800 })
  await page.goto('/playground')
  const room = page.locator(stage)
  await expect(room).toHaveAttribute('data-state', 'resting')
  await page.setViewportSize({ width: 500, height: 800 })
  const beyond = () =>
    room.evaluate((e) =>
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

test('the playground is printed as its code', async ({ page }) => {
  await page.goto('/playground')
  await page.emulateMedia({ media: 'print' })
  await expect(page.locator(stage)).toBeHidden()
  await expect(page.getByRole('form', { name: 'Settings' })).toBeHidden()
  await expect(page.getByText('export function Pile()')).toBeVisible()
})

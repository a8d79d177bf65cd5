import { expect, type Page } from '@playwright/test'
import { TOUCH_HOLD } from '../registry/gravity-stack/constants'
import { painted, test } from './page'

const stage = '[data-slot=playground-stage]'

/** What the row below the stage says of the last step. */
const number = (page: Page, name: string) =>
  page.locator('dt', { hasText: new RegExp(`^${name}$`) }).locator('+ dd')

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

test('drops its chips, and all of them lie inside and still', async ({ page }) => {
  await page.goto('/playground')
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
  // How far each hull reaches past wall or floor, px: a rotated element's own box has corners that a pill has not.
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

test('the overlay is drawn anew in the colours of another theme', async ({ page }) => {
  await page.emulateMedia({ colorScheme: 'light' })
  await page.goto('/playground?count=2')
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
  await page.getByRole('button', { name: 'Overlay' }).click()
  const drawn = () =>
    page.locator(`${stage} canvas`).evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL())
  const light = await drawn()
  await page.emulateMedia({ colorScheme: 'dark' })
  await expect.poll(async () => (await drawn()) === light).toBe(false)
  await page.emulateMedia({ colorScheme: 'light' })
  await expect.poll(async () => (await drawn()) === light).toBe(true)
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

/** One chip in the air, on a paused stage. What it returns presses Step and says how far down the chip is then, px. */
async function falling(page: Page) {
  // Nothing falls before the first press on Step.
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/playground?count=1&stagger=0')
  await expect(page.getByText('Motion is off')).toBeVisible()
  const chip = page.locator(`${stage} [data-chip]`)
  const height = () => chip.evaluate((element) => new DOMMatrix(getComputedStyle(element).transform).f)
  const step = async () => {
    await page.getByRole('button', { name: 'Step' }).click()
    return height()
  }
  const waiting = await height()
  // It is let go after a few frames.
  await expect.poll(step, { intervals: [0] }).not.toBe(waiting)
  return step
}

test('paused, a press on Step moves the chips by one frame', async ({ page }) => {
  const step = await falling(page)
  const [first, second, third] = [await step(), await step(), await step()]
  // Gravity makes the way of each frame longer by as much; the air takes a hundredth of a pixel of it.
  expect(third - second - (second - first)).toBeCloseTo(2600 / 60 ** 2, 1)
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'paused')
})

test('a chip is dragged, under the overlay too; a still hand drops it, a moving one tosses it', async ({
  page,
}) => {
  await page.goto('/playground?count=1')
  const room = page.locator(stage)
  await expect(room).toHaveAttribute('data-state', 'resting')
  await page.getByRole('button', { name: 'Overlay' }).click()
  await expect(room.locator('canvas')).toBeVisible()
  const chip = room.locator('[data-chip]')
  /**
   * Drags the chip up and aside, and lets it go when the hand has stood still for so many frames. What it returns says
   * how far beyond the hand the chip's centre is, px.
   */
  const carry = async (still: number) => {
    const from = (await chip.boundingBox())!
    await page.mouse.move(from.x + 20, from.y + 10)
    await page.mouse.down()
    await page.mouse.move(from.x + 40, from.y - 120, { steps: 8 })
    await expect.poll(async () => (await chip.boundingBox())!.y).toBeLessThan(from.y - 60)
    const { x, width } = (await room.boundingBox())!
    const way = from.x < x + width / 2 ? 1 : -1
    // Half a pixel a millisecond by the times of the events themselves: a hand that is late throws nothing, and a busy
    // machine's is.
    const hand = await chip.evaluate(
      async (element, { x, y, way, still }) => {
        const start = performance.now()
        const send = (type: string, ms: number, late = 0) => {
          const event = new PointerEvent(type, {
            bubbles: true,
            pointerId: 1,
            pointerType: 'mouse',
            buttons: type === 'pointermove' ? 1 : 0,
            clientX: x + way * 0.5 * ms,
            clientY: y,
          })
          Object.defineProperty(event, 'timeStamp', { value: start + ms + late })
          element.dispatchEvent(event)
        }
        for (let ms = 0; ms < 300; ms += 1000 / 60) {
          send('pointermove', ms)
          await new Promise(requestAnimationFrame)
        }
        for (let frame = 0; frame < still; frame++) await new Promise(requestAnimationFrame)
        send('pointerup', 300, (still * 1000) / 60)
        return x + way * 150
      },
      { x: from.x + 40, y: from.y - 120, way, still },
    )
    return async () => {
      const { x, width } = (await chip.boundingBox())!
      return way * (x + width / 2 - hand)
    }
  }
  const dropped = await carry(60)
  await page.mouse.up()
  await expect(room).toHaveAttribute('data-state', 'resting')
  // It falls over where it has hung.
  expect(await dropped()).toBeLessThan(90)

  const tossed = await carry(0)
  await expect.poll(tossed).toBeGreaterThan(100)
  await page.mouse.up()
  await expect(room).toHaveAttribute('data-state', 'resting')
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

test.describe('on a fine screen', () => {
  test.use({ deviceScaleFactor: 2 })

  test('the overlay has the screen’s own pixels, and what sleeps a dashed outline', async ({ page }) => {
    await page.addInitScript(() => {
      const dashes: number[][] = []
      Object.assign(window, { dashes })
      const { setLineDash } = CanvasRenderingContext2D.prototype
      CanvasRenderingContext2D.prototype.setLineDash = function (dash) {
        dashes.push([...dash])
        setLineDash.call(this, dash)
      }
    })
    await page.goto('/playground?count=2')
    await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
    await page.getByRole('button', { name: 'Overlay' }).click()
    const canvas = page.locator(`${stage} canvas`)
    await expect
      .poll(() => canvas.evaluate((canvas: HTMLCanvasElement) => canvas.width / canvas.clientWidth))
      .toBe(2)
    const dashed = await page.evaluate(
      () => (window as unknown as { dashes: number[][] }).dashes.filter((dash) => dash.length > 0).length,
    )
    expect(dashed).toBeGreaterThan(1)
  })
})

test('the overlay of a paused stage is there at once', async ({ page }) => {
  await page.goto('/playground?count=3')
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
  await page.getByRole('button', { name: 'Pause' }).click()
  await page.getByRole('button', { name: 'Overlay' }).click()
  await expect.poll(async () => (await colours(page)).grey).toBeGreaterThan(3 * 800)
})

test('the numbers say what the solver did in the last step', async ({ page }) => {
  await page.goto('/playground?count=12&shape=boxes')
  const names = ['awake chips', 'pairs', 'contacts', 'islands', 'sub-steps, all islands', 'µs a step']
  for (const name of names) await expect(number(page, name)).not.toHaveText('0')
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
  for (const name of names) await expect(number(page, name)).toHaveText('0')
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

test('a playground at rest asks for no frame', async ({ page }) => {
  await page.goto('/playground?count=3')
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
  const asked = await page.evaluate(async () => {
    const { requestAnimationFrame } = window
    let asked = 0
    window.requestAnimationFrame = (callback) => {
      asked++
      return requestAnimationFrame(callback)
    }
    for (let frame = 0; frame < 10; frame++) await new Promise((done) => requestAnimationFrame(done))
    return asked
  })
  expect(asked).toBe(0)
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
  const step = await falling(page)
  await page.getByLabel('gravity').press('Home')
  const [a, b, c] = [await step(), await step(), await step()]
  expect(c - b - (b - a)).toBeCloseTo(0, 0)
})

test('what passes while a laptop is closed is not computed', async ({ page }) => {
  await page.clock.install({ time: 0 })
  await page.clock.pauseAt(1000)
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/playground?count=2&stagger=500')
  await page.getByRole('button', { name: 'Play' }).click()
  await page.clock.runFor(200)
  await page.clock.fastForward(600_000)
  await page.clock.runFor(100)
  await expect(number(page, 'awake chips')).toHaveText('1')
})

test('at 1/20 of the speed a second is three frames', async ({ page }) => {
  await page.clock.install({ time: 0 })
  await page.clock.pauseAt(1000)
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await page.goto('/playground?count=1&stagger=0')
  await page.getByRole('button', { name: 'Speed 1/20×' }).click()
  await page.getByRole('button', { name: 'Play' }).click()
  await page.clock.runFor(1000)
  await expect(number(page, 'awake chips')).toHaveText('0')
  await page.getByRole('button', { name: 'Speed 1×' }).click()
  await page.clock.runFor(200)
  await expect(number(page, 'awake chips')).toHaveText('1')
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

test('a slider of the playground wakes a pile that lies', async ({ page }) => {
  await page.goto('/playground?count=3')
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
  await page.getByLabel('gravity').press('End')
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'running')
  await expect(page.locator(stage)).toHaveAttribute('data-state', 'resting')
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

test.describe('playground under a finger', () => {
  test.use({ hasTouch: true, viewport: { width: 390, height: 700 } })

  /** A finger on the only chip: where it goes is px to the right of where it came down, and upwards. */
  async function fingerOn(page: Page) {
    const session = await page.context().newCDPSession(page)
    const { x, y, width, height } = (await page.locator(`${stage} [data-chip]`).boundingBox())!
    const touch = (type: string, touchPoints: { x: number; y: number }[]) =>
      session.send('Input.dispatchTouchEvent', { type: type as 'touchStart', touchPoints })
    const at = (right: number, up: number) => [{ x: x + width / 2 + right, y: y + height / 2 - up }]
    return {
      down: () => touch('touchStart', at(0, 0)),
      to: (right: number, up: number) => touch('touchMove', at(right, up)),
      up: () => touch('touchEnd', []),
      cancel: () => touch('touchCancel', []),
    }
  }

  const scrolled = (page: Page) => page.evaluate(() => scrollY)

  /** From here on the moment after which a finger holds never comes: a busy machine's swipe may take longer than that. */
  const neverHold = (page: Page) =>
    page.evaluate((never) => {
      const { setTimeout } = window
      window.setTimeout = ((work: () => void, ms?: number) =>
        ms === never ? 0 : setTimeout(work, ms)) as typeof window.setTimeout
    }, TOUCH_HOLD)

  async function swipeUp(page: Page, { to }: Awaited<ReturnType<typeof fingerOn>>) {
    for (let up = 10; up <= 150; up += 10) {
      await to(0, up)
      await page.evaluate(() => new Promise(requestAnimationFrame))
    }
  }

  test('a chip is carried off when the finger rests, and the page scrolls when it does not', async ({
    page,
  }) => {
    await page.goto('/playground?count=1')
    const room = page.locator(stage)
    await expect(room).toHaveAttribute('data-state', 'resting')
    await room.evaluate((element) => element.scrollIntoView({ block: 'center' }))
    // Both at once: a page that a finger has sent off scrolls on meanwhile.
    const top = () =>
      room.evaluate((element) => {
        const chip = element.querySelector('[data-chip]')!
        return chip.getBoundingClientRect().y - element.getBoundingClientRect().y
      })
    const [lying, before] = [await top(), await scrolled(page)]

    const first = await fingerOn(page)
    await first.down()
    // What is held is awake.
    await expect(room).not.toHaveAttribute('data-state', 'resting')
    await swipeUp(page, first)
    await expect.poll(top).toBeLessThan(lying - 80)
    expect(await scrolled(page)).toBe(before)
    await first.up()
    await expect(room).toHaveAttribute('data-state', 'resting')

    await neverHold(page)
    const lies = await top()
    const second = await fingerOn(page)
    await second.down()
    await swipeUp(page, second)
    await expect.poll(() => scrolled(page)).toBeGreaterThan(before + 60)
    expect(await top()).toBeCloseTo(lies, 0)
    await second.up()
  })

  test('a tap takes nothing, and what a finger drew aside at once falls when it is lifted', async ({
    page,
  }) => {
    await page.clock.install({ time: 0 })
    await page.clock.pauseAt(1000)
    await page.goto('/playground?count=1')
    const room = page.locator(stage)
    await page.clock.runFor(6000)
    await expect(room).toHaveAttribute('data-state', 'resting')
    await room.evaluate((element) => element.scrollIntoView({ block: 'center' }))
    const finger = await fingerOn(page)
    for (const end of ['up', 'cancel'] as const) {
      await finger.down()
      await finger[end]()
      await page.clock.runFor(2 * TOUCH_HOLD)
      expect(await room.getAttribute('data-state')).toBe('resting')
    }
    await finger.down()
    for (const right of [10, 20, 30, 40]) await finger.to(right, 0)
    await page.clock.runFor(2 * TOUCH_HOLD)
    expect(await room.getAttribute('data-state')).toBe('running')
    await finger.up()
    await page.clock.runFor(6000)
    await expect(room).toHaveAttribute('data-state', 'resting')
  })

  test('when other chips come while a finger holds one, the page can be scrolled from there afterwards', async ({
    page,
  }) => {
    await page.goto('/playground?count=1')
    const room = page.locator(stage)
    await expect(room).toHaveAttribute('data-state', 'resting')
    await room.evaluate((element) => element.scrollIntoView({ block: 'center' }))
    const first = await fingerOn(page)
    await first.down()
    await expect(room).not.toHaveAttribute('data-state', 'resting')
    await page.getByLabel('Shape').selectOption('boxes')
    await first.up()
    await expect(room).toHaveAttribute('data-state', 'resting')

    await neverHold(page)
    await room.evaluate((element) => element.scrollIntoView({ block: 'center' }))
    const before = await scrolled(page)
    const second = await fingerOn(page)
    await second.down()
    await swipeUp(page, second)
    await expect.poll(() => scrolled(page)).toBeGreaterThan(before + 60)
    await second.up()
  })
})

test('the playground is printed as its code', async ({ page }) => {
  await page.goto('/playground')
  await page.emulateMedia({ media: 'print' })
  await expect(page.locator('[data-slot=playground-stage]')).toBeHidden()
  await expect(page.getByRole('form', { name: 'Settings' })).toBeHidden()
  await expect(page.getByText('export function Pile()')).toBeVisible()
})

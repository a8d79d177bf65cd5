import { expect, type Page } from '@playwright/test'
import { TOUCH_HOLD } from '../registry/gravity-stack/stage/pointers'
import { playgroundStage as stage, test } from './page'

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
   * Drags the chip up and aside, and lets it go when the hand has stood still for so many frames. What it
   * returns says how far beyond the hand the chip's centre is, px.
   */
  const carry = async (still: number) => {
    const from = (await chip.boundingBox())!
    await page.mouse.move(from.x + 20, from.y + 10)
    await page.mouse.down()
    await page.mouse.move(from.x + 40, from.y - 120, { steps: 8 })
    await expect.poll(async () => (await chip.boundingBox())!.y).toBeLessThan(from.y - 60)
    const { x, width } = (await room.boundingBox())!
    const way = from.x < x + width / 2 ? 1 : -1
    // Half a pixel a millisecond by the times of the events themselves: a hand that is late throws nothing,
    // and a busy machine's is.
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

  /**
   * From here on a resting finger never holds a chip: on a busy machine a swipe may take longer than that.
   */
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

  /** The stage in the middle of the window, with its only chip at rest. */
  async function lying(page: Page) {
    await page.goto('/playground?count=1')
    const room = page.locator(stage)
    await expect(room).toHaveAttribute('data-state', 'resting')
    await room.evaluate((element) => element.scrollIntoView({ block: 'center' }))
    return room
  }

  /** Swipes up from the chip, which scrolls the page. The finger is still down. */
  async function swipeScrolls(page: Page) {
    await neverHold(page)
    const before = await scrolled(page)
    const finger = await fingerOn(page)
    await finger.down()
    await swipeUp(page, finger)
    await expect.poll(() => scrolled(page)).toBeGreaterThan(before + 60)
    return finger
  }

  test('a chip is carried off when the finger rests, and the page scrolls when it does not', async ({
    page,
  }) => {
    const room = await lying(page)
    // Both at once: a page that a finger has sent off scrolls on meanwhile.
    const top = () =>
      room.evaluate((element) => {
        const chip = element.querySelector('[data-chip]')!
        return chip.getBoundingClientRect().y - element.getBoundingClientRect().y
      })
    const [start, before] = [await top(), await scrolled(page)]

    const first = await fingerOn(page)
    await first.down()
    // What is held is awake.
    await expect(room).not.toHaveAttribute('data-state', 'resting')
    await swipeUp(page, first)
    await expect.poll(top).toBeLessThan(start - 80)
    expect(await scrolled(page)).toBe(before)
    await first.up()
    await expect(room).toHaveAttribute('data-state', 'resting')

    const lies = await top()
    const second = await swipeScrolls(page)
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
    const room = await lying(page)
    const first = await fingerOn(page)
    await first.down()
    await expect(room).not.toHaveAttribute('data-state', 'resting')
    await page.getByLabel('Shape').selectOption('boxes')
    await first.up()
    await expect(room).toHaveAttribute('data-state', 'resting')

    await room.evaluate((element) => element.scrollIntoView({ block: 'center' }))
    const second = await swipeScrolls(page)
    await second.up()
  })
})

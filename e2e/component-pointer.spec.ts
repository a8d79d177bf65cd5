import { takeFrames } from './fixtures/frames'
import { expect, type StagePage, test } from './fixtures/stage'

/**
 * Lets a pile fall and tosses its first chip inwards and up: px that it has gone past the place where it was
 * let go, after each frame until all lies still. The frames are to be taken; events have times of their own
 * as well, since a hand that is late throws nothing.
 */

async function toss({ stage, chips, hertz }: { stage: StagePage; chips: number; hertz: number }) {
  await stage.open('pile', { chips })
  await stage.reaches('running')
  await stage.page.evaluate(() => window.drive(Array(600).fill(1000 / 60)))
  await stage.reaches('resting')
  return stage.chips.first().evaluate(async (chip, hertz) => {
    const box = chip.getBoundingClientRect()
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2]
    const way = x < 320 ? 1 : -1
    const at = () => way * new DOMMatrix(getComputedStyle(chip).transform).e
    const before = at()
    const send = (type: string, ms: number) => {
      const event = new PointerEvent(type, {
        bubbles: true,
        composed: true,
        pointerId: 7,
        pointerType: 'mouse',
        clientX: x + way * 0.5 * ms,
        clientY: y - 0.5 * ms,
      })
      Object.defineProperty(event, 'timeStamp', { value: 5000 + ms })
      chip.dispatchEvent(event)
    }
    send('pointerdown', 0)
    // 0.5 px a ms for 300 ms of frames; the pointer reports when its own rate says so.
    let told = 0
    for (let ms = 0; ms <= 300; ms += 1000 / 60) {
      await window.drive([1000 / 60])
      while (told + 1000 / hertz <= ms + 0.001) {
        told += 1000 / hertz
        send('pointermove', told)
      }
    }
    send('pointerup', 300)
    const flown: number[] = []
    while (chip.parentElement?.dataset.state !== 'resting') {
      await window.drive([1000 / 60])
      flown.push(at() - before - 150)
    }
    return flown
  }, hertz)
}

test('a pressed chip hangs from the very point where it was grabbed, in front and a little smaller', async ({
  stage,
  page,
}) => {
  await stage.settled('pile', { chips: 5, shape: 'tall' })
  const chip = stage.chips.nth(2)
  // Near one end of it, however it lies.
  const [px, py] = await chip.evaluate((element) => {
    const { x, y, width, height } = element.getBoundingClientRect()
    const m = new DOMMatrix(getComputedStyle(element).transform)
    return [x + width / 2 + 3 * m.a + 20 * m.c, y + height / 2 + 3 * m.b + 20 * m.d]
  })
  const grabbed = await stage.pointAt(chip, px, py)
  await page.mouse.move(px, py)
  await page.mouse.down()
  await expect(chip).toHaveAttribute('data-state', 'held')
  await page.mouse.move(px - 30, py - 120, { steps: 8 })
  await stage.hangs(chip)
  const held = await stage.pointAt(chip, px - 30, py - 120)
  expect(Math.hypot(held.x - grabbed.x, held.y - grabbed.y)).toBeLessThan(6)
  const { z, scale } = await chip.evaluate((element) => {
    const m = new DOMMatrix(getComputedStyle(element).transform)
    return { z: Number(getComputedStyle(element).zIndex), scale: Math.hypot(m.a, m.b) }
  })
  expect(z).toBeGreaterThan(0)
  expect(scale).toBeCloseTo(0.97, 3)
  await page.mouse.up()
  await expect(chip).not.toHaveAttribute('data-state', 'held')
  await stage.reaches('resting')
  expect(await stage.overlap()).toBeLessThan(1)
})

test('a tossed chip flies on, comes down and settles', async ({ stage, page }) => {
  await page.addInitScript(takeFrames)
  const flown = await toss({ stage, chips: 3, hertz: 60 })
  expect(Math.max(...flown)).toBeGreaterThan(40)
  expect(await stage.overlap()).toBeLessThan(1)
})

test('a chip that is carried and let go falls straight down: no flight, no hop', async ({ stage, page }) => {
  await stage.settled('pile', { chips: 3 })
  const chip = stage.chips.nth(0)
  await stage.drag(chip, 0, -100)
  await stage.hangs(chip)
  const { x, y } = await stage.centre(chip)
  const highest = await stage.highest(chip)
  await page.mouse.up()
  expect(y - (await highest())).toBeLessThan(4)
  await stage.reaches('resting')
  expect(Math.abs((await stage.centre(chip)).x - x)).toBeLessThan(60)
})

test('a throw is as fast from a 30 Hz pointer as from a 240 Hz one', async ({ stage, page }) => {
  await page.addInitScript(takeFrames)
  const throwAt = async (hertz: number) => {
    const flown = await toss({ stage, chips: 1, hertz })
    return (flown[7] - flown[1]) / 0.1
  }
  const slow = await throwAt(30)
  const fast = await throwAt(240)
  expect(slow).toBeGreaterThan(420)
  expect(Math.abs(slow - fast) / fast).toBeLessThan(0.06)
})

test('several pointers hold several chips, and each lets go of its own', async ({ stage, page }) => {
  await stage.settled('pile', { chips: 4 })
  const send = (type: string, pointerId: number, chip: number, dy = 0) =>
    page.evaluate(
      ([type, pointerId, chip, dy]) => {
        const element = document.querySelectorAll('[data-slot=gravity-stack-chip]')[chip]
        const box = element.getBoundingClientRect()
        const event = { bubbles: true, composed: true, pointerId, clientX: box.x + box.width / 2 }
        element.dispatchEvent(new PointerEvent(type, { ...event, clientY: box.y + box.height / 2 + dy }))
      },
      [type, pointerId, chip, dy] as const,
    )
  await send('pointerdown', 21, 0)
  await send('pointerdown', 22, 1)
  await send('pointermove', 21, 0, -80)
  await send('pointermove', 22, 1, -80)
  expect((await stage.states()).slice(0, 2)).toEqual(['held', 'held'])
  await send('pointerup', 21, 0)
  await expect(stage.chips.nth(0)).not.toHaveAttribute('data-state', 'held')
  await expect(stage.chips.nth(1)).toHaveAttribute('data-state', 'held')
  await send('pointercancel', 22, 1)
  await expect(stage.chips.nth(1)).not.toHaveAttribute('data-state', 'held')
  await stage.reaches('resting')
})

test('a pointer that loses its capture lets go', async ({ stage, page }) => {
  await stage.settled('pile', { chips: 4 })
  const chip = stage.chips.nth(1)
  await stage.drag(chip, 20, -80)
  await expect(chip).toHaveAttribute('data-state', 'held')
  await chip.evaluate((element) => {
    // The mouse is pointer 1 in every browser.
    element.releasePointerCapture(1)
  })
  await page.mouse.move(300, 100)
  await expect(chip).not.toHaveAttribute('data-state', 'held')
  await stage.reaches('resting')
})

test('a chip dragged out of the stage stays inside, and is still held', async ({ stage, page }) => {
  await stage.settled('pile', { chips: 3 })
  const chip = stage.chips.nth(0)
  await stage.drag(chip, 900, -60)
  await stage.hangs(chip)
  await expect(chip).toHaveAttribute('data-state', 'held')
  expect(await stage.outside()).toBeLessThan(2)
  await page.mouse.up()
  await stage.reaches('resting')
  expect(await stage.outside()).toBeLessThan(1)
})

for (const pointerType of ['mouse', 'touch']) {
  test(`a falling chip can be caught in the air, with a ${pointerType}`, async ({ stage, page }) => {
    await stage.open('pile', { chips: 1, gravity: 300 })
    const chip = stage.chips.first()
    // Watched frame by frame in the page: a hand is quicker than a test.
    const caught = await chip.evaluate(async (element, pointerType) => {
      const middle = () => {
        const box = element.getBoundingClientRect()
        return { clientX: box.x + box.width / 2, clientY: box.y + box.height / 2 }
      }
      while (middle().clientY < 80) await window.probe.pass(1)
      const at = middle()
      const event = { bubbles: true, composed: true, pointerId: 5, pointerType, ...at }
      element.dispatchEvent(new PointerEvent('pointerdown', event))
      return at.clientY
    }, pointerType)
    await expect(chip).toHaveAttribute('data-state', 'held')
    await stage.hangs(chip)
    expect(Math.abs((await stage.centre(chip)).y - caught)).toBeLessThan(20)
    await page.evaluate(() =>
      document.body.dispatchEvent(new PointerEvent('pointerup', { bubbles: true, pointerId: 5 })),
    )
    await stage.reaches('resting')
  })
}

test('with interactive off nothing can be grabbed and nothing listens', async ({ stage, page }) => {
  await stage.settled('pile', { chips: 3, interactive: false })
  const listening = await stage.probe((probe) => Object.keys(probe.listeners))
  expect(listening.filter((type) => /pointer|touch|click|drag/.test(type))).toEqual([])
  await stage.drag(stage.chips.nth(0), 60, -100)
  await page.mouse.up()
  expect(new Set(await stage.states())).toEqual(new Set(['resting']))
  expect(await stage.chips.nth(0).evaluate((chip) => getComputedStyle(chip).cursor)).not.toBe('grab')
})

test('the cursor is an open hand over a chip and a closed one while it is held, and its words can’t be selected', async ({
  stage,
  page,
}) => {
  await stage.settled('pile', { chips: 3 })
  const chip = stage.chips.nth(0)
  const style = () =>
    chip.evaluate((element) => {
      const { cursor, userSelect } = getComputedStyle(element)
      return { cursor, userSelect }
    })
  expect(await style()).toEqual({ cursor: 'grab', userSelect: 'none' })
  await stage.drag(chip, 30, -50)
  expect(await style()).toEqual({ cursor: 'grabbing', userSelect: 'none' })
  await page.mouse.up()
})

test('a press with another button than the first, or with Ctrl, holds no chip', async ({ stage, page }) => {
  await stage.settled('pile', { chips: 3 })
  const { x, y } = await stage.centre(stage.chips.nth(0))
  await page.mouse.move(x, y)
  for (const button of ['right', 'middle'] as const) {
    await page.mouse.down({ button })
    expect(await stage.states(), button).not.toContain('held')
    await page.mouse.up({ button })
  }
  await page.keyboard.down('Control')
  await page.mouse.down()
  expect(await stage.states()).not.toContain('held')
  await page.mouse.up()
  await page.keyboard.up('Control')
})

test('a chip that a mouse takes while a finger still waits on it stays with the mouse', async ({ stage }) => {
  await stage.settled('pile', { chips: 3 })
  const chip = stage.chips.first()
  const fire = (...events: [type: string, pointerId: number, pointerType: string][]) =>
    chip.evaluate((element, list) => {
      const { x, y, width, height } = element.getBoundingClientRect()
      const at = { clientX: x + width / 2, clientY: y + height / 2, bubbles: true, composed: true }
      for (const [type, pointerId, pointerType] of list)
        element.firstElementChild!.dispatchEvent(
          new PointerEvent(type, { ...at, pointerId, pointerType, button: 0, buttons: 1 }),
        )
    }, events)
  await fire(['pointerdown', 5, 'touch'], ['pointerdown', 1, 'mouse'])
  await stage.probe((probe) => probe.pass(30))
  await fire(['pointerup', 5, 'touch'])
  await stage.probe((probe) => probe.pass(2))
  await expect(chip).toHaveAttribute('data-state', 'held')
  await fire(['pointerup', 1, 'mouse'])
  await stage.reaches('resting')
})

for (const kind of ['greedy', 'draggable']) {
  test(`a chip is dragged where what is around it is ${kind}`, async ({ stage, page }) => {
    await stage.settled('surroundings', { kind })
    const chip = stage.chip('two')
    const { y } = await stage.drag(chip, 0, -100)
    await expect.poll(async () => Math.abs((await stage.centre(chip)).y - y)).toBeLessThan(20)
    await page.mouse.up()
    await stage.reaches('resting')
  })
}

test('a held chip stays with a pointer that stands still while the page scrolls', async ({ stage, page }) => {
  await stage.settled('surroundings', { kind: 'tall' })
  const chip = stage.chip('two')
  await stage.drag(chip, 0, -60)
  await stage.hangs(chip)
  const { y } = await stage.centre(chip)
  await page.mouse.wheel(0, 60)
  await expect.poll(() => page.evaluate(() => scrollY)).toBe(60)
  await expect.poll(async () => Math.abs((await stage.centre(chip)).y - y)).toBeLessThan(5)
  await page.mouse.up()
})

test('a held chip that loses its size is let go, and falls anew when it has one again', async ({
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

test('a new order of the children leaves a chip with the pointer that drags it', async ({ stage, page }) => {
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

test('a chip that is taken from a pointer at rest falls straight down', async ({ stage, page }) => {
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

test('a chip falls when the first button goes up, though another is still down', async ({ stage, page }) => {
  await stage.settled('pile', { chips: 3 })
  const chip = stage.chips.first()
  await stage.drag(chip, 0, -60)
  await page.mouse.down({ button: 'right' })
  await page.mouse.up()
  await expect(chip).not.toHaveAttribute('data-state', 'held')
  await page.mouse.up({ button: 'right' })
  await stage.reaches('resting')
})

test('a chip whose release nobody heard falls when the same pointer presses another', async ({ stage }) => {
  await stage.settled('pile', { chips: 3 })
  const press = (n: number) =>
    stage.chips.nth(n).evaluate((chip) => {
      const { x, y, width, height } = chip.getBoundingClientRect()
      const at = { clientX: x + width / 2, clientY: y + height / 2 }
      chip.dispatchEvent(new PointerEvent('pointerdown', { ...at, pointerId: 1, bubbles: true }))
    })
  await press(0)
  await press(1)
  expect(await stage.states()).toEqual(['falling', 'held', 'resting'])
})

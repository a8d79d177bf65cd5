import { expect, test } from './fixtures/stage'

test('ref, native props and style reach the stage', async ({ stage, page }) => {
  await stage.settled('extras')
  await expect(stage.root).toHaveAttribute('id', 'stage')
  await expect(stage.root).toHaveAttribute('title', 'pile')
  await expect(page.getByRole('group', { name: 'Topics' })).toHaveCount(1)
  await expect(stage.root).toHaveCSS('outline-style', 'solid')
  await page.locator('#read').click()
  await expect(page.locator('#tag')).toHaveText('stage gravity-stack')
})

test('onSettle is called once each time the pile comes to rest, and for nothing else', async ({
  stage,
  page,
}) => {
  await stage.settled('extras')
  await expect(page.locator('#settled')).toHaveText('1')
  await page.emulateMedia({ media: 'print' })
  await stage.reaches('static')
  await page.emulateMedia({ media: 'screen' })
  await stage.reaches('resting')
  await stage.drag(stage.chips.nth(0), 30, -80)
  await page.mouse.up()
  await stage.reaches('running')
  await stage.reaches('resting')
  await expect(page.locator('#settled')).toHaveText('2')
})

test('drop() lets all chips fall anew, into the same pile, and none in front that had come there', async ({
  stage,
  page,
}) => {
  await stage.settled('extras')
  const { poses } = await stage.pile()
  const order = () => stage.chips.evaluateAll((all) => all.map((chip) => getComputedStyle(chip).zIndex))
  const before = await order()
  await stage.hop(stage.chips.first())
  expect(await order()).not.toEqual(before)
  await stage.probe((probe) => probe.releases.splice(0))
  await page.locator('#drop').click()
  await stage.reaches('running')
  await stage.reaches('resting')
  const released = await stage.probe((probe) => probe.releases.map(([chip]) => chip))
  expect(released.toSorted()).toEqual([...poses.keys()])
  for (const [i, { x, y }] of (await stage.pile()).poses.entries()) {
    expect(Math.hypot(x - poses[i].x, y - poses[i].y)).toBeLessThan(0.3)
  }
  expect(await order()).toEqual(before)
})

/** Gives the focus to what a chip shows. Runs in the page. */
function goTo(chip: Element) {
  const face = chip.firstElementChild as HTMLElement
  face.tabIndex = 0
  face.focus()
}

test('drop() leaves the chip that has the focus in front', async ({ stage, page }) => {
  await stage.settled('extras')
  const front = () => stage.chips.first().evaluate((chip) => getComputedStyle(chip).zIndex)
  await stage.chips.first().evaluate(goTo)
  await page.locator('#drop').evaluate((button: HTMLElement) => button.click())
  await stage.reaches('running')
  expect(await front()).toBe('1')
})

test('a tapped chip hops, though its own handler keeps the click to itself', async ({ stage }) => {
  await stage.settled('extras')
  const chip = stage.chips.first()
  await chip.evaluate((element) => {
    element.firstElementChild!.addEventListener('click', (event) => event.stopPropagation())
  })
  expect(await stage.hop(chip)).toBeGreaterThan(5)
})

test('in a paused stage the focus moves no chip that can be seen in the air', async ({ stage, page }) => {
  await stage.open('extras')
  await expect
    .poll(async () => {
      const { poses } = await stage.pile()
      return poses[0].y
    })
    .toBeGreaterThan(40)
  await page.locator('#pause').evaluate((button: HTMLElement) => button.click())
  await stage.reaches('paused')
  const { poses } = await stage.pile()
  await stage.chips.first().evaluate(goTo)
  expect((await stage.pile()).poses[0]).toEqual(poses[0])
})

test('after drop() each chip waits out of sight for its turn', async ({ stage }) => {
  await stage.settled('extras')
  // In the page itself: on a busy machine all have been let go before an answer is back.
  const seen = await stage.root.evaluate(async (root) => {
    document.querySelector<HTMLElement>('#drop')?.click()
    do await new Promise(requestAnimationFrame)
    while (!root.querySelector('[data-state=falling]'))
    const { top } = root.getBoundingClientRect()
    const waiting = [...root.querySelectorAll('[data-state=waiting]')]
    return waiting.map((chip) => chip.getBoundingClientRect().bottom > top)
  })
  expect(seen).toContain(false)
  expect(seen).not.toContain(true)
})

test('shake() throws the pile into the air, and it settles again inside', async ({ stage }) => {
  await stage.settled('extras')
  // In the page itself: it is up there for less time than an answer may take.
  const highest = await stage.root.evaluate(async (root) => {
    const heights = () =>
      [...root.children].map((chip) => {
        const { top, bottom } = chip.getBoundingClientRect()
        return (top + bottom) / 2
      })
    const before = heights()
    document.querySelector<HTMLElement>('#shake')?.click()
    let highest = 0
    while (root.dataset.state !== 'resting') {
      highest = Math.max(highest, ...heights().map((y, i) => before[i] - y))
      await window.probe.pass(1)
    }
    return highest
  })
  expect(highest).toBeGreaterThan(40)
  expect(await stage.overlap()).toBeLessThan(1)
})

test('without gravity what shake() has sent out of the stage comes back into it', async ({ stage, page }) => {
  await stage.open('pile', { chips: 4, gravity: 0, stagger: 0, shaker: true })
  /** Whether each chip is in view, in part at least. */
  const inside = () =>
    stage.root.evaluate((root) =>
      [...root.children].map(
        (chip) => chip.getBoundingClientRect().bottom > root.getBoundingClientRect().top,
      ),
    )
  await expect.poll(inside).toEqual([true, true, true, true])
  const shake = page.getByRole('button', { name: 'Shake' })
  await shake.click()
  await expect.poll(inside).toContain(false)
  await expect.poll(inside).toEqual([true, true, true, true])
  // Before all lies still.
  await shake.click()
  await expect.poll(inside).toContain(false)
  // Only the air stops them: half a minute where nothing else is asked of the machine.
  await expect(stage.root).toHaveAttribute('data-state', 'resting', { timeout: 150_000 })
  expect(await inside()).toEqual([true, true, true, true])
})

test('pause() freezes the chips in the air, resume() lets them go on', async ({ stage, page }) => {
  await stage.open('extras')
  await expect(stage.chips.nth(3)).toHaveAttribute('data-state', 'falling')
  await page.locator('#pause').click()
  await stage.reaches('paused')
  // Nothing can be grabbed, and no cursor says so.
  await expect(stage.chips.first()).toHaveCSS('cursor', 'auto')
  const { poses } = await stage.pile()
  expect(await stage.during('frames')).toBe(0)
  expect((await stage.pile()).poses).toEqual(poses)
  const { x, y } = await stage.centre(stage.chips.nth(0))
  await page.mouse.move(x, y)
  await page.mouse.down()
  expect(await stage.states()).not.toContain('held')
  await page.mouse.up()
  await page.locator('#resume').click()
  await stage.reaches('resting')
})

test('a tap on a chip of a paused pile is no tap, and moves nothing when the pile goes on', async ({
  stage,
  page,
}) => {
  await stage.settled('extras')
  await page.locator('#pause').click()
  await stage.reaches('paused')
  const { x, y } = await stage.centre(stage.chips.nth(0))
  await page.mouse.click(x, y)
  const before = await stage.probe((probe) => probe.states.length)
  await page.locator('#resume').click()
  await stage.reaches('resting')
  expect(await stage.probe((probe) => probe.states)).toHaveLength(before + 1)
})

test('paused while it has no height, a stage drops its chips when it has one and goes on', async ({
  stage,
  page,
}) => {
  await page.addInitScript(() => {
    addEventListener('DOMContentLoaded', () => {
      const flat = document.createElement('style')
      flat.textContent = '[data-slot=gravity-stack] { height: 0 !important }'
      document.head.append(flat)
      Object.assign(window, { unfold: () => flat.remove() })
    })
  })
  await stage.open('extras')
  await stage.reaches('waiting')
  await page.locator('#pause').click()
  // Its chips may change their size all the same.
  await stage.chips.first().evaluate((chip) => {
    ;(chip.firstElementChild as HTMLElement).style.fontSize = '30px'
    return window.probe.pass(3)
  })
  await page.evaluate('unfold()')
  await stage.reaches('paused')
  expect(new Set(await stage.states())).toEqual(new Set(['waiting']))
  await page.locator('#resume').click()
  await stage.reaches('resting')
  expect(new Set(await stage.states())).toEqual(new Set(['resting']))
})

test('a new gravity takes hold of the pile as it lies', async ({ stage, page }) => {
  await stage.settled('extras')
  const { poses } = await stage.pile()
  await page.locator('#heavy').click()
  await stage.reaches('running')
  await stage.reaches('resting')
  for (const [i, { x, y }] of (await stage.pile()).poses.entries()) {
    expect(Math.hypot(x - poses[i].x, y - poses[i].y)).toBeLessThan(20)
  }
})

test('interactive takes effect at once, both ways, and lets go of what is held', async ({ stage, page }) => {
  await stage.settled('extras')
  const chip = stage.chips.nth(0)
  await stage.drag(chip, 10, -60)
  await expect(chip).toHaveAttribute('data-state', 'held')
  await page.locator('#still').evaluate((button: HTMLElement) => button.click())
  await expect(chip).not.toHaveAttribute('data-state', 'held')
  await page.mouse.up()
  await stage.reaches('resting')
  await stage.drag(chip, 10, -60)
  expect(await stage.states()).not.toContain('held')
  await page.mouse.up()
  await page.locator('#still').click()
  await stage.drag(chip, 10, -60)
  await expect(chip).toHaveAttribute('data-state', 'held')
  await page.mouse.up()
})

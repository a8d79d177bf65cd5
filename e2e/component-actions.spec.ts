import { expect, goTo, test } from './fixtures/stage'
import { keepWaits } from './fixtures/time'

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

test('drop() leaves the chip that has the focus in front', async ({ stage, page }) => {
  await stage.settled('extras')
  const front = () => stage.chips.first().evaluate((chip) => getComputedStyle(chip).zIndex)
  await stage.chips.first().evaluate(goTo)
  await page.locator('#drop').evaluate((button: HTMLElement) => button.click())
  await stage.reaches('running')
  expect(await front()).toBe('1')
})

test('after drop() each chip waits unseen for its turn', async ({ stage }) => {
  await stage.settled('extras')
  // In the page itself: on a busy machine all have been let go before an answer is back.
  const seen = await stage.root.evaluate(async (root) => {
    document.querySelector<HTMLElement>('#drop')?.click()
    do await new Promise(requestAnimationFrame)
    while (!root.querySelector('[data-state=falling]'))
    const waiting = [...root.querySelectorAll('[data-state=waiting]')]
    return waiting.map((chip) => {
      const { x, y, width, height } = chip.getBoundingClientRect()
      const there = document.elementsFromPoint(x + width / 2, y + height / 2)
      return there.some((element) => chip.contains(element))
    })
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

test('drop() takes a held chip away from the pointer', async ({ stage, page }) => {
  await stage.settled('extras')
  const chip = stage.chips.first()
  await stage.drag(chip, 0, -60)
  await page.locator('#drop').evaluate((button: HTMLElement) => button.click())
  await stage.reaches('resting')
  expect(await stage.scale(chip)).toBeCloseTo(1, 3)
  await page.mouse.up()
})

test('drop() and another stagger at once let the first chip fall at once', async ({ stage, page }) => {
  await keepWaits(page, 1000)
  await stage.settled('extras', { stagger: 500 })
  await page.evaluate(() => {
    for (const id of ['drop', 'pace']) document.getElementById(id)!.click()
  })
  await expect(stage.chips.first()).toHaveAttribute('data-state', 'falling')
  expect(await page.evaluate(() => window.waits)).toEqual([])
})

test('a pile can still be moved after an error in onSettle', async ({ stage, page }) => {
  const errors: string[] = []
  page.on('pageerror', (error) => errors.push(error.message))
  await stage.settled('surroundings', { kind: 'throws' })
  await expect.poll(() => errors).toEqual(['of onSettle'])
  const chip = stage.chip('one')
  const { y } = await stage.drag(chip, 0, -100)
  await expect.poll(async () => Math.abs((await stage.centre(chip)).y - y)).toBeLessThan(20)
  await page.mouse.up()
  await expect.poll(() => errors).toEqual(['of onSettle', 'of onSettle'])
  await stage.probe((probe) => probe.errors.splice(0))
})

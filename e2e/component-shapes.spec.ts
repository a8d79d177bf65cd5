import { expect, StagePage, test } from './fixtures/stage'

test('words too long for a stage of fractional width lie still in it, not wedged between its walls', async ({
  stage,
}) => {
  await stage.settled('pile', { chips: 8 })
  await stage.root.evaluate((root) => {
    root.style.width = '343.4px'
    root.querySelector('[data-slot=gravity-stack-chip]')!.firstElementChild!.textContent = 'words '.repeat(30)
  })
  const width = () => stage.chips.first().evaluate((chip) => Number.parseFloat(getComputedStyle(chip).width))
  await expect.poll(width).toBeGreaterThan(340)
  expect(await width()).toBeLessThan(343)
  // Its stage hears of it with the next frame.
  await stage.probe((probe) => probe.pass(3))
  await stage.reaches('resting')
  expect(await stage.outside()).toBeLessThan(0.05)
  // Two chips that lean are each drawn to a tenth of a pixel: how exactly they lie apart is asked of the
  // world.
  expect(await stage.overlap()).toBeLessThan(0.25)
})

test('a chip of many words is no wider than the stage', async ({ stage }) => {
  await stage.settled('pile', { chips: 2 })
  await stage.chips.first().evaluate((chip) => {
    chip.firstElementChild!.textContent = 'word '.repeat(60)
  })
  await expect.poll(async () => (await stage.pile()).shapes[0].height).toBeGreaterThan(60)
  expect((await stage.pile()).shapes[0].width).toBeLessThanOrEqual(640)
})

test('corners that a rule of the page squares by and by are square once they are drawn so', async ({
  stage,
  page,
}) => {
  await stage.settled('children')
  await page.addStyleTag({
    content: '.sharp [data-slot=gravity-stack-chip] > * { border-radius: 0; transition: border-radius 0.1s }',
  })
  await page.evaluate(() => document.body.classList.add('sharp'))
  await expect(stage.chip('three')).toHaveCSS('border-radius', '0px')
  await expect.poll(() => stage.overlap()).toBeLessThan(1)
  await stage.reaches('resting')
})

test('words alone that a rule of the page makes round stay round as they grow', async ({ stage, page }) => {
  await stage.settled('children')
  const chip = stage.chip('text')
  await page.addStyleTag({ content: '[data-slot=gravity-stack-chip] { border-radius: 50% }' })
  /** How far their corners are from half of their height, px. */
  const off = () =>
    chip.evaluate((element: HTMLElement) =>
      Math.abs(element.offsetHeight / 2 - Number.parseFloat(element.style.borderRadius)),
    )
  for (const size of [30, 50]) {
    await chip.evaluate((element, size) => {
      element.style.fontSize = `${size}px`
    }, size)
    await expect.poll(off).toBeLessThan(0.6)
  }
  await stage.reaches('resting')
})

test('beside a chip that has become round, in the corner of its box, nothing is pressed any more', async ({
  stage,
}) => {
  await stage.settled('pile', { chips: 1, shape: 'box' })
  /** What is pressed 2 px inside the lower right corner of its box. */
  const pressed = () =>
    stage.chips.first().evaluate((chip: HTMLElement) => {
      const { x, y, width, height } = chip.getBoundingClientRect()
      const turn = new DOMMatrix(getComputedStyle(chip).transform)
      turn.e = x + width / 2
      turn.f = y + height / 2
      const at = turn.transformPoint({ x: chip.offsetWidth / 2 - 2, y: chip.offsetHeight / 2 - 2 })
      return document.elementFromPoint(at.x, at.y)?.closest('[data-slot]')?.getAttribute('data-slot')
    })
  expect(await pressed()).toBe('gravity-stack-chip')
  await stage.chips.first().evaluate((chip) => {
    const face = chip.firstElementChild as HTMLElement
    face.style.borderRadius = '99px'
  })
  await expect.poll(pressed).toBe('gravity-stack')
})

test('a pill that begins with words and styles nobody sees falls as the pill it is', async ({
  stage,
  page,
}) => {
  await stage.settled('surroundings', { kind: 'unseen' })
  const other = new StagePage(page, page.locator('[data-slot=gravity-stack]').nth(1))
  await other.reaches('resting')
  const [{ poses: plain }, { poses: wordy }] = await Promise.all([stage.pile(), other.pile()])
  // What moves by less than a tenth of a pixel is not drawn again, so which frames fell into the last steps
  // shows that much.
  const off = plain.map(({ x, y }, i) => Math.hypot(x - wordy[i].x, y - wordy[i].y))
  expect(Math.max(...off)).toBeLessThan(0.25)
})

test('a picture that loads lazily loads, and falls', async ({ stage, page }) => {
  await page.route('**/late.svg', (route) =>
    route.fulfill({
      contentType: 'image/svg+xml',
      body: '<svg xmlns="http://www.w3.org/2000/svg" width="80" height="40"><rect width="80" height="40"/></svg>',
    }),
  )
  await stage.open('surroundings', { kind: 'lazy' })
  await expect(stage.chips.first()).not.toHaveAttribute('data-state', 'waiting')
  await stage.reaches('resting')
  expect(await stage.overlap()).toBeLessThan(1)
})

test('with the text spacing of WCAG 1.4.12 each chip takes its new size and nothing overlaps', async ({
  stage,
  page,
}) => {
  await stage.settled('pile', { chips: 12 })
  await page.addStyleTag({
    content:
      '* { letter-spacing: 0.12em !important; word-spacing: 0.16em !important; line-height: 1.5 !important }',
  })
  await stage.reaches('running')
  await stage.reaches('resting')
  expect(await stage.overlap()).toBeLessThan(1)
})

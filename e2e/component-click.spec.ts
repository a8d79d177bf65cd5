import { expect, test } from './fixtures/stage'

const done = 'output'

test('links and buttons in chips click, middle-click and open their menu as always', async ({
  stage,
  page,
}) => {
  await stage.settled('controls')
  await page.getByText('Read the docs').click()
  await expect(page).toHaveURL(/#link$/)
  await page.getByText('a button').click()
  await page.getByText('inner').click()
  await page.getByText('Read the docs').click({ button: 'middle' })
  await page.getByText('plain', { exact: true }).click({ button: 'right' })
  await expect(page.locator(done)).toHaveText(
    'click link, click button, click inner, auxclick link, contextmenu plain, auxclick plain',
  )
})

test('a click on a control leaves its chip where it is', async ({ stage, page }) => {
  await stage.settled('controls')
  const chip = stage.chip('a button')
  const before = await stage.centre(chip)
  await page.getByText('a button').click()
  await stage.reaches('resting')
  const after = await stage.centre(chip)
  expect(Math.hypot(after.x - before.x, after.y - before.y)).toBeLessThan(1)
})

test('a press on a control gives it the focus, and one beside it takes the focus away', async ({
  stage,
  page,
}) => {
  await stage.settled('controls')
  const control = (name: string) => page.getByRole('button', { name, exact: true })
  await control('a button').click()
  await expect(control('a button')).toBeFocused()
  await control('inner').click()
  await expect(control('inner')).toBeFocused()
  await page.locator('[data-name=plain]').click()
  await expect(control('inner')).not.toBeFocused()
})

test('a long link is followed from its very edge', async ({ stage, page }) => {
  await stage.settled('surroundings', { kind: 'long' })
  const box = (await page.getByText('long').boundingBox())!
  await page.mouse.click(box.x + 2, box.y + box.height / 2)
  await expect(page).toHaveURL(/#long$/)
})

test('a link is followed though what is around its stage shrinks at the press', async ({ stage, page }) => {
  await stage.settled('surroundings', { kind: 'shrinking' })
  const { x, y } = await stage.centre(stage.chip('to the end'))
  await page.mouse.move(x, y)
  await page.mouse.down()
  await stage.hangs(stage.chip('to the end'))
  await page.mouse.move(x + 1, y)
  await page.mouse.up()
  await expect(page).toHaveURL(/#long$/)
})

test('a chip is tapped at its very edge, and hears of it', async ({ stage, page }) => {
  await stage.settled('surroundings', { kind: 'rim' })
  const box = (await stage.chips.first().boundingBox())!
  await page.mouse.click(box.x + 2, box.y + box.height / 2)
  await expect(page.getByText('clicked')).toBeVisible()
  await stage.reaches('running')
})

test('beside a disc, in the corner of its box, nothing is pressed', async ({ stage, page }) => {
  await stage.settled('pile', { chips: 1, shape: 'disc' })
  const { poses, stage: size } = await stage.pile()
  const box = (await stage.root.boundingBox())!
  const hit = (dx: number, dy: number) =>
    page.evaluate(
      ([x, y]) => document.elementFromPoint(x, y)?.closest('[data-slot]')?.getAttribute('data-slot'),
      [box.x + poses[0].x + dx, box.y + poses[0].y + dy],
    )
  expect(size.height).toBe(340)
  // A disc of 48 px, however it is turned: at most 24 px from its centre.
  for (const angle of [0, 1, 2, 3, 4, 5, 6]) {
    expect(await hit(22 * Math.cos(angle), 22 * Math.sin(angle))).toBe('gravity-stack-chip')
    expect(await hit(26 * Math.cos(angle), -26 * Math.abs(Math.sin(angle)))).toBe('gravity-stack')
  }
})

test('a link that the page scrolled away with, from under the button that is down on it, is dragged and not followed', async ({
  stage,
  page,
}) => {
  await stage.settled('controls')
  await page.evaluate(() => {
    document.body.style.minHeight = '200vh'
    scrollTo(0, 60)
  })
  const { x, y } = await stage.centre(stage.chip('Read the docs'))
  await page.mouse.move(x, y)
  await page.mouse.down()
  // The chip is lifted: pressed into the floor it would not stay under the pointer.
  await page.mouse.wheel(0, -40)
  await expect.poll(() => page.evaluate(() => scrollY)).toBe(20)
  await stage.hangs(stage.chip('Read the docs'))
  await page.mouse.up()
  await stage.reaches('resting')
  await expect(page).not.toHaveURL(/#link$/)
  await page.getByText('Read the docs').click()
  await expect(page).toHaveURL(/#link$/)
})

test('a drag of a link is a click to nobody around the stage', async ({ stage, page }) => {
  await stage.settled('surroundings', { kind: 'capturing' })
  await stage.drag(stage.chip('there'), 60, -60)
  await page.mouse.up()
  await stage.reaches('resting')
  await expect(page.locator('output')).toHaveCount(0)
  await page.getByText('there').click()
  await expect(page.locator('output')).toHaveText('clicked')
})

test('a mouse that moves by 3 px still clicks a link, one that moves by 10 px drags it', async ({
  stage,
  page,
}) => {
  await stage.settled('controls')
  const link = stage.chip('Read the docs')
  await stage.drag(link, 10, 0)
  await page.mouse.up()
  await stage.reaches('resting')
  expect(page.url()).not.toMatch(/#link$/)
  await stage.drag(link, 3, 0, 3)
  await page.mouse.up()
  await expect(page).toHaveURL(/#link$/)
})

test('a drag that starts on a link moves the chip, and neither follows nor drags the link', async ({
  stage,
  page,
}) => {
  await stage.settled('controls')
  const chip = stage.chip('Read the docs')
  const { x, y } = await stage.drag(chip, 40, -120)
  await expect(chip).toHaveAttribute('data-state', 'held')
  await stage.hangs(chip)
  const centre = await stage.centre(chip)
  expect(Math.hypot(centre.x - x, centre.y - y)).toBeLessThan(40)
  await page.mouse.up()
  await stage.reaches('resting')
  await expect(page.locator(done)).not.toContainText('click link')
  await expect(page).not.toHaveURL(/#link$/)
  // The next click counts again.
  await page.getByText('Read the docs').click()
  await expect(page.locator(done)).toContainText('click link')
})

test('what can be dragged around the stage does not hear that a drag begins', async ({ stage, page }) => {
  await stage.settled('pile')
  await page.evaluate(() => {
    const card = document.querySelector('main')!
    card.draggable = true
    card.addEventListener('dragstart', () => card.setAttribute('data-heard', ''))
  })
  await stage.drag(stage.chips.first(), 40, -60)
  await expect(stage.chips.first()).toHaveAttribute('data-state', 'held')
  await page.mouse.up()
  await expect(page.locator('main')).not.toHaveAttribute('data-heard')
})

test('after a drag that no click follows, the keyboard still follows the link at once', async ({
  stage,
  page,
}) => {
  await stage.settled('controls')
  // A finger that has moved ends without a click.
  await stage.chip('Read the docs').evaluate((chip) => {
    const box = chip.getBoundingClientRect()
    const send = (type: string, dy: number) => {
      const at = { clientX: box.x + box.width / 2, clientY: box.y + box.height / 2 + dy }
      chip.dispatchEvent(new PointerEvent(type, { bubbles: true, composed: true, pointerId: 9, ...at }))
    }
    send('pointerdown', 0)
    send('pointermove', -60)
    send('pointerup', -60)
  })
  await page.getByText('Read the docs').focus()
  await page.keyboard.press('Enter')
  await expect(page).toHaveURL(/#link$/)
})

test('a tap on a chip without a control gives it a hop', async ({ stage, page }) => {
  await stage.settled('controls')
  const chip = stage.chip('plain')
  expect(await stage.hop(chip)).toBeGreaterThan(20)
  await stage.reaches('resting')
  expect(await stage.overlap()).toBeLessThan(1)
  await expect(page.locator(done)).toContainText('click plain')
})

test('text in a field inside a chip is selected with the mouse; the chip stays', async ({ stage, page }) => {
  await stage.settled('controls')
  const field = page.getByLabel('name', { exact: true }).last()
  const { x, y } = await stage.centre(field)
  await page.mouse.move(x, y)
  await page.mouse.down()
  await page.mouse.move(x + 12, y - 12, { steps: 4 })
  expect(await stage.states()).not.toContain('held')
  await page.mouse.up()
  await field.dblclick()
  expect(await field.evaluate((input: HTMLInputElement) => input.selectionEnd! - input.selectionStart!)).toBe(
    3,
  )
})

test('a tapped chip hops, though its own handler keeps the click to itself', async ({ stage }) => {
  await stage.settled('extras')
  const chip = stage.chips.first()
  await chip.evaluate((element) => {
    element.firstElementChild!.addEventListener('click', (event) => event.stopPropagation())
  })
  expect(await stage.hop(chip)).toBeGreaterThan(5)
})

test('a tap makes a chip hop, also where all around it can have the focus', async ({ stage }) => {
  await stage.settled('surroundings', { kind: 'focusable' })
  expect(await stage.hop(stage.chip('three'))).toBeGreaterThan(20)
})

test('of a stage inside a chip of another one press takes the inner chip alone', async ({ stage, page }) => {
  await stage.settled('surroundings', { kind: 'nested' })
  const inner = page.getByText('inner', { exact: true })
  const box = (await inner.boundingBox())!
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2)
  await page.mouse.down()
  const held = page.locator('[data-state=held]')
  await expect(held).toHaveCount(1)
  await expect(held).toHaveText('inner')
  await page.mouse.up()
})

test('a press on a slider, or on what its owner has marked, is theirs; one on words that can’t be edited takes the chip', async ({
  stage,
  page,
}) => {
  await stage.settled('surroundings', { kind: 'owned' })
  for (const [what, state] of [
    ['[role=slider]', 'resting'],
    ['[data-slot=slider-track]', 'resting'],
    ['[data-no-grab]', 'resting'],
    ['[contenteditable=false]', 'held'],
  ]) {
    const box = await stage.root.locator(what).boundingBox()
    await page.mouse.move(box!.x + box!.width / 2, box!.y + box!.height / 2)
    await page.mouse.down()
    await page.mouse.move(box!.x + box!.width / 2 + 40, box!.y + box!.height / 2 - 20, { steps: 6 })
    await expect(stage.chips.filter({ has: page.locator(what) })).toHaveAttribute('data-state', state)
    await page.mouse.up()
    await stage.reaches('resting')
  }
})

test('a press on a popover of a chip moves no chip; its words can be selected', async ({ stage, page }) => {
  await stage.settled('surroundings', { kind: 'popover' })
  await expect(page.getByText('read me')).toHaveCSS('cursor', 'auto')
  const box = (await page.getByText('read me').boundingBox())!
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2)
  await page.mouse.down()
  await page.mouse.move(box.x + 40, box.y - 60, { steps: 4 })
  expect(await stage.states()).not.toContain('held')
  await page.mouse.up()
  await stage.reaches('resting')
  await page.getByText('read me').click({ clickCount: 3 })
  expect(await page.evaluate(() => `${getSelection()}`.trim())).toBe('read me')
})

test('a tap on a button in a shadow tree is the button’s: its chip does not hop', async ({ stage, page }) => {
  await stage.settled('surroundings', { kind: 'shadow' })
  await page.evaluate(() =>
    addEventListener('click', ({ target }) => {
      if (target instanceof HTMLElement && target.shadowRoot) document.title = 'pressed'
    }),
  )
  expect(await stage.hop(stage.chips.first())).toBeLessThan(10)
  await expect(page).toHaveTitle('pressed')
})

test('clicks that miss a chip, as when it has hopped away, select no words of the page', async ({
  stage,
  page,
}) => {
  await stage.settled('pile', { chips: 3 })
  await stage.root.evaluate((root) =>
    root.after(Object.assign(document.createElement('p'), { textContent: 'words after the stage' })),
  )
  const { x, y } = (await stage.root.boundingBox())!
  await page.mouse.click(x + 300, y + 40, { clickCount: 3 })
  expect(await page.evaluate(() => `${getSelection()}`)).toBe('')
  await page.getByText('words after').click({ clickCount: 3 })
  expect(await page.evaluate(() => `${getSelection()}`)).toContain('words after')
})

test('a control that is pressed and let go where it lies has its own size again', async ({ stage, page }) => {
  await stage.settled('controls')
  const chip = stage.chip('a button')
  const { x, y } = await stage.centre(chip)
  await page.mouse.move(x, y)
  await page.mouse.down()
  await expect(chip).toHaveAttribute('data-state', 'held')
  expect(await stage.scale(chip)).toBeCloseTo(0.97, 3)
  await page.mouse.up()
  await stage.reaches('resting')
  expect(await stage.scale(chip)).toBeCloseTo(1, 3)
})

test('in a shadow tree that nobody sees into a drag is a click to nobody either', async ({ page }) => {
  await page.goto('/surroundings?kind=closed')
  const state = () =>
    page.evaluate(
      () =>
        (window as unknown as { inside?: ShadowRoot }).inside?.querySelector<HTMLElement>(
          '[data-slot=gravity-stack]',
        )?.dataset.state,
    )
  await expect.poll(state).toBe('resting')
  const { x, y } = await page.evaluate(() => {
    const link = (window as unknown as { inside: ShadowRoot }).inside.querySelector('a')!
    const box = link.getBoundingClientRect()
    return { x: box.x + box.width / 2, y: box.y + box.height / 2 }
  })
  const clicks = await page.evaluateHandle(() => {
    const heard: string[] = []
    const { inside } = window as unknown as { inside: ShadowRoot }
    inside.addEventListener('click', ({ type }) => heard.push(type))
    return heard
  })
  await page.mouse.move(x, y)
  await page.mouse.down()
  await page.mouse.move(x + 40, y - 60, { steps: 8 })
  await page.mouse.up()
  await expect.poll(state).toBe('resting')
  expect(await clicks.jsonValue()).toEqual([])
  await expect(page).not.toHaveURL(/#there$/)
  // Nor to the stage: a word let go where it hangs falls, it doesn't hop.
  const word = await page.evaluateHandle(
    () => (window as unknown as { inside: ShadowRoot }).inside.querySelector('span')!,
  )
  const top = () => word.evaluate((element) => element.getBoundingClientRect().y)
  const box = (await word.boundingBox())!
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2)
  await page.mouse.down()
  await page.mouse.move(box.x + box.width / 2, box.y - 60, { steps: 8 })
  let hung = Number.NaN
  await expect
    .poll(async () => {
      const before = hung
      hung = await top()
      return Math.abs(hung - before)
    })
    .toBeLessThan(0.5)
  const highest = word.evaluate(async (element) => {
    let top = Number.POSITIVE_INFINITY
    const stage = element.closest<HTMLElement>('[data-slot=gravity-stack]')!
    while (stage.dataset.state === 'running') {
      top = Math.min(top, element.getBoundingClientRect().y)
      await new Promise(requestAnimationFrame)
    }
    return top
  })
  await page.mouse.up()
  expect(await highest).toBeGreaterThan(hung - 10)
})

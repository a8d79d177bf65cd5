import { worstOverlap } from '../scenes/exact-distance'
import { takeFrames } from './fixtures/frames'
import { expect, test } from './fixtures/stage'

for (const chips of [12, 40, 60]) {
  test(`${chips} chips pour into the stage, lie still within 6 s, and no word covers another`, async ({
    stage,
  }) => {
    await stage.settled('pile', { chips })
    expect(new Set(await stage.states())).toEqual(new Set(['resting']))
    expect(await stage.probe((probe) => probe.settling)).toBeLessThan(6)
    expect(await stage.overlap()).toBeLessThan(1)
    expect(await stage.hovering()).toBeLessThan(0.5)
    expect(await stage.during('frames')).toBe(0)
    expect(await stage.during('styleWrites')).toBe(0)
  })
}

test('pills, boxes and discs in one pile lie still within 6 s, and apart', async ({ stage }) => {
  await stage.settled('pile', { chips: 60, shape: 'all' })
  expect(await stage.probe((probe) => probe.settling)).toBeLessThan(6)
  expect(await stage.overlap()).toBeLessThan(1)
  expect(await stage.hovering()).toBeLessThan(0.5)
})

test('the drop waits until a quarter of the stage is in view', async ({ stage, page }) => {
  await page.setViewportSize({ width: 800, height: 600 })
  await stage.open('pile', { above: 1300, below: 900 })
  await stage.reaches('static')
  // Within a screen of the view it gets ready.
  await page.mouse.wheel(0, 400)
  await stage.reaches('waiting')
  await page.mouse.wheel(0, 300 + 340 * 0.2)
  await expect.poll(() => page.evaluate(() => scrollY)).toBe(768)
  await stage.probe((probe) => probe.pass(3))
  await expect(stage.root).toHaveAttribute('data-state', 'waiting')
  expect(new Set(await stage.states())).toEqual(new Set(['waiting']))
  await page.mouse.wheel(0, 340 * 0.1)
  await stage.reaches('running')
  await stage.reaches('resting')
})

test('a chip that waits for its release stands in the stage, and can’t be seen or pressed', async ({
  stage,
}) => {
  await stage.open('pile', { stagger: 60000, chips: 4 })
  await expect(stage.chips.first()).toHaveAttribute('data-state', 'resting')
  const waiting = stage.root.locator('[data-state=waiting]')
  await expect(waiting).toHaveCount(3)
  const places = await waiting.evaluateAll((all) =>
    all.map((chip) => {
      const { x, y, width, height, bottom } = chip.getBoundingClientRect()
      const stage = chip.parentElement!.getBoundingClientRect()
      const there = document.elementsFromPoint(x + width / 2, y + height / 2)
      return {
        inStage: y >= stage.top && bottom <= stage.bottom,
        pressed: there.some((element) => chip.contains(element)),
      }
    }),
  )
  expect(places).toEqual(Array(3).fill({ inStage: true, pressed: false }))
  const before = await stage.root.screenshot()
  await waiting.evaluateAll((all) => {
    for (const chip of all) chip.remove()
  })
  expect(before.equals(await stage.root.screenshot())).toBe(true)
})

test('the same chips are drawn in the very same places at every visit', async ({ stage }) => {
  const drawn = async () => {
    await stage.settled('pile', { shape: 'all', chips: 40, stagger: 40 })
    return stage.chips.evaluateAll((all) => all.map((chip) => (chip as HTMLElement).style.transform))
  }
  const first = await drawn()
  for (let visit = 2; visit <= 3; visit++) expect(await drawn()).toEqual(first)
})

test('chips that are released at once begin apart', async ({ stage, page }) => {
  await page.addInitScript(takeFrames)
  await stage.open('pile', { chips: 40, stagger: 0, shape: 'all' })
  await stage.reaches('running')
  const worst: number[] = []
  let states: (string | undefined)[]
  do {
    await page.evaluate(() => window.drive([1000 / 60]))
    states = await stage.states()
    const { shapes, poses, stage: box } = await stage.pile()
    const released = (_: unknown, i: number) => states[i] !== 'waiting'
    worst.push(worstOverlap(shapes.filter(released), poses.filter(released), box))
  } while (states.includes('waiting'))
  expect(Math.max(...worst)).toBeLessThan(0.1)
})

test('chips fall one by one, first come first', async ({ stage }) => {
  await stage.open('pile', { stagger: 400, chips: 3 })
  await stage.reaches('resting')
  expect(await stage.probe((probe) => probe.releases)).toEqual([
    [0, 2],
    [1, 1],
    [2, 0],
  ])
})

test('a chip that changes its style before it is first drawn falls as any other', async ({ stage, page }) => {
  await page.addInitScript(() => {
    const { setTimeout } = window
    let changed = false
    // The first chip is released by a timer, and drawn with the next frame.
    window.setTimeout = ((work: () => void, ms?: number) =>
      setTimeout(() => {
        work()
        const face = document.querySelector('[data-state=running] > * > *')
        if (changed || !(face instanceof HTMLElement)) return
        changed = true
        face.style.borderRadius = '0'
      }, ms)) as typeof setTimeout
  })
  await stage.settled('pile', { chips: 12 })
  await expect(stage.chips.first()).toHaveCSS('border-radius', '0px')
  expect(await stage.overlap()).toBeLessThan(1)
})

for (const [what, corners, radius] of [
  ['of which one corner is round and three are square', '24px 0 0 0', 0],
  ['whose corners are a share of its size', '20%', 9.6],
] as const) {
  test(`a chip ${what} lies as it is drawn`, async ({ stage, page }) => {
    await page.route('**/fixtures.css', async (route) => {
      const response = await route.fetch()
      const face = '[data-slot=gravity-stack-chip] > *'
      const body = `${await response.text()}\n${face} { border-radius: ${corners} !important }`
      await route.fulfill({ response, body })
    })
    await stage.settled('pile', { chips: 12, shape: 'disc' })
    const { shapes, poses, stage: room } = await stage.pile()
    const drawn = shapes.map((shape) => ({ ...shape, radius }))
    expect(worstOverlap(drawn, poses, room)).toBeLessThan(1)
  })
}

test('a chip whose face stands in a box without a box of its own is as round as that', async ({ stage }) => {
  await stage.settled('inputs', { children: 'contents' })
  const { shapes } = await stage.pile()
  const radii = await stage.chips.evaluateAll((all) => all.map((chip) => getComputedStyle(chip).borderRadius))
  expect(radii).toEqual(shapes.map(({ height }) => `${height / 2}px`))
})

test('chips collide as what they look like: pills, boxes, rounded boxes, discs', async ({ stage }) => {
  for (const shape of ['pill', 'box', 'rounded', 'disc', 'tall']) {
    await stage.settled('pile', { shape, chips: 20 })
    expect(await stage.overlap(), shape).toBeLessThan(1)
    expect(await stage.hovering(), shape).toBeLessThan(0.5)
  }
})

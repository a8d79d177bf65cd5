import type { Page } from '@playwright/test'
import { takeFrames } from './fixtures/frames'
import { expect, type StagePage, test } from './fixtures/stage'
import { keepWaits } from './fixtures/time'
import { withhold } from './page'

/**
 * How many words are drawn upside down, and the most that a disc is off, degrees. A chip on its side is
 * neither.
 */
async function fallen(stage: StagePage) {
  const { shapes, poses } = await stage.pile()
  const disc = shapes.map(({ width, height, radius }) => width === height && radius! >= width / 2)
  return {
    words: poses.filter(({ angle }, i) => !disc[i] && Math.cos(angle) < -0.02).length,
    askew: Math.max(0, ...poses.map(({ angle }, i) => (disc[i] ? Math.abs(angle * 180) / Math.PI : 0))),
  }
}

for (const [chips, shape] of [
  [15, 'pill'],
  [60, 'pill'],
  [40, 'all'],
] as const)
  test(`${chips} chips (${shape}) are dropped, and no word lies upside down, no disc askew`, async ({
    stage,
  }) => {
    await stage.settled('pile', { chips, shape })
    const { words, askew } = await fallen(stage)
    expect(words).toBeLessThanOrEqual(0.02 * chips)
    expect(askew).toBeLessThan(5)
  })

test('with `upright={false}` words lie as they fell, and no slice of a look-ahead runs', async ({
  stage,
  page,
}) => {
  const slices = await countSlices(page)
  await stage.settled('pile', { chips: 15, upright: false })
  expect((await fallen(stage)).words).toBeGreaterThan(2)
  expect(await slices()).toBe(0)
})

/** Counts the timers without a wait that the component sets: the slices of its look-ahead. */
async function countSlices(page: Page) {
  await page.addInitScript(() => {
    const set = window.setTimeout
    Object.assign(window, { slices: 0 })
    window.setTimeout = ((work: () => void, ms?: number, ...all: unknown[]) => {
      if (!ms && /client-/.test(new Error().stack ?? '')) (window as unknown as { slices: number }).slices++
      return set(work, ms, ...all)
    }) as typeof setTimeout
  })
  return () => page.evaluate(() => (window as unknown as { slices: number }).slices)
}

/**
 * Lets the frames of a drop pass, 60 a second, with `meddle` called before each. Counts how often a chip that
 * shows in one of two frames is turned by more than a body turns between them, and how often one out of sight
 * is. Runs in the page.
 */
async function countFlips(meddle: string) {
  const root = document.querySelector<HTMLElement>('[data-slot=gravity-stack]')!
  const chips = [...root.querySelectorAll<HTMLElement>('[data-slot=gravity-stack-chip]')]
  const act = new Function('frame', 'chips', 'root', meddle)
  const before = new Map<HTMLElement, { angle: number; shows: boolean }>()
  const flips = { inSight: 0, out: 0 }
  for (let frame = 0; root.dataset.state !== 'resting'; frame++) {
    act(frame, chips, root)
    await window.drive([1000 / 60])
    for (const chip of chips) {
      const [, y, angle] = (
        /,(.+?)px\)rotate\((.+?)rad/.exec(chip.style.transform.replaceAll(' ', '')) ?? []
      ).map(Number)
      if (y === undefined) {
        before.delete(chip)
        continue
      }
      const [w, h, r] = [chip.offsetWidth, chip.offsetHeight, Number.parseFloat(chip.style.borderRadius)]
      const reach = (w / 2 - r) * Math.abs(Math.sin(angle)) + (h / 2 - r) * Math.abs(Math.cos(angle)) + r
      const now = { angle, shows: y + h / 2 + reach > 0 }
      const then = before.get(chip)
      if (then && Math.abs(angle - then.angle) > 1) flips[now.shows || then.shows ? 'inSight' : 'out']++
      before.set(chip, now)
    }
  }
  return flips
}

const meddling = {
  'nobody does anything': '',
  'a chip is dragged about': `
    const at = chips[0].getBoundingClientRect()
    const send = (type, x, y) => chips[0].dispatchEvent(new PointerEvent(type, { bubbles: true, pointerId: 7, isPrimary: true, buttons: 1, clientX: x, clientY: y }))
    if (frame === 60) send('pointerdown', at.x + at.width / 2, at.y + at.height / 2)
    if (frame > 60 && frame < 120) send('pointermove', 100 + 5 * (frame - 60), 150 - (frame % 20))
    if (frame === 120) send('pointerup', 300, 150)`,
  'the stage becomes narrower and wider': `
    if (frame % 40 === 20) root.style.width = frame % 80 === 20 ? '560px' : '640px'`,
  'words change and a chip is hidden for a while': `
    if (frame % 30 === 10) chips[(frame / 30 | 0) % chips.length].firstElementChild.textContent = 'word '.repeat(1 + frame % 3)
    if (frame === 50) chips[9].style.display = 'none'
    if (frame === 90) chips[9].style.display = ''`,
  'all is shaken while some still wait': `
    if (frame === 80) document.querySelector('button').click()`,
}
for (const [what, meddle] of Object.entries(meddling))
  test(`no chip is seen to flip while ${what}`, async ({ stage, page }) => {
    await page.addInitScript(takeFrames)
    await stage.open('pile', { chips: 20, shape: 'all', stagger: 90, shaker: true })
    await stage.reaches('running')
    const flips = (await page.evaluate(`(${countFlips})(${JSON.stringify(meddle)})`)) as Awaited<
      ReturnType<typeof countFlips>
    >
    expect(flips.inSight).toBe(0)
    await stage.reaches('resting')
    expect(await stage.overlap()).toBeLessThan(1)
  })

test('the pile is the one that falls without a look-ahead, but for whole turns that leave each outline', async ({
  stage,
}) => {
  await stage.page.addInitScript(takeFrames)
  const pile = async (upright: boolean) => {
    await stage.open('pile', { chips: 24, shape: 'all', stagger: 60, upright })
    await stage.reaches('running')
    await stage.page.evaluate((times) => window.drive(times), Array<number>(3000).fill(1000 / 60))
    await stage.reaches('resting')
    return stage.pile()
  }
  const [planned, plain] = [await pile(true), await pile(false)]
  let turned = 0
  for (const [i, { x, y, angle }] of planned.poses.entries()) {
    const { width, height, radius } = planned.shapes[i]
    expect(Math.hypot(x - plain.poses[i].x, y - plain.poses[i].y), `chip ${i}`).toBeLessThan(0.02)
    const turn = angle - plain.poses[i].angle
    if (Math.cos(turn) < 0) turned++
    if (width === height && radius! >= width / 2) continue
    // The sine of what is a multiple of half a turn, or of a quarter for a square, is nothing.
    expect(Math.abs(Math.sin((width === height ? 2 : 1) * turn)), `chip ${i}`).toBeLessThan(0.001)
  }
  expect(turned).toBeGreaterThan(3)
})

test('after a frame that was long itself no slice follows, but after the next one', async ({
  stage,
  page,
}) => {
  await page.addInitScript(takeFrames)
  // Each chip that is drawn seems to take 5 ms.
  await page.addInitScript(() => {
    const now = performance.now.bind(performance)
    let more = 0
    performance.now = () => now() + more
    Object.defineProperty(CSSStyleDeclaration.prototype, 'transform', {
      get: (): unknown => undefined,
      set(this: CSSStyleDeclaration, value: string) {
        more += 5
        this.setProperty('transform', value)
      },
    })
  })
  const slices = await countSlices(page)
  await stage.open('pile', { chips: 12, shape: 'pill', stagger: 100 })
  await stage.reaches('running')
  // From here on each frame draws a chip.
  await page.evaluate(() => window.drive([1000 / 60]))
  const followed: boolean[] = []
  for (let frame = 0; frame < 60; frame++) {
    const before = await slices()
    await page.evaluate(() => window.drive([1000 / 60]))
    followed.push((await slices()) > before)
  }
  const pairs = followed.slice(1).map((yes, n) => Number(yes) + Number(followed[n]))
  expect(pairs.filter((count) => count === 2)).toHaveLength(0)
  expect(pairs.filter((count) => count === 1).length).toBeGreaterThan(50)
})

test('once nothing is left to turn no second world is kept, and no slice runs while the pile is at work', async ({
  stage,
  page,
}) => {
  const slices = await countSlices(page)
  await stage.settled('pile', { chips: 12, shaker: true })
  const before = await slices()
  expect(before).toBeGreaterThan(0)
  await page.getByRole('button', { name: 'Shake' }).click()
  await stage.reaches('running')
  await stage.reaches('resting')
  expect(await slices()).toBe(before)
  const session = await page.context().newCDPSession(page)
  let snapshot = ''
  session.on('HeapProfiler.addHeapSnapshotChunk', ({ chunk }) => {
    snapshot += chunk
  })
  await session.send('HeapProfiler.enable')
  await session.send('HeapProfiler.collectGarbage')
  await session.send('HeapProfiler.takeHeapSnapshot', {})
  const { nodes, strings, snapshot: head } = JSON.parse(snapshot)
  const { node_fields: fields, node_types: types } = head.meta
  let bodies = 0
  for (let n = 0; n < nodes.length; n += fields.length)
    if (types[0][nodes[n]] === 'object' && strings[nodes[n + fields.indexOf('name')]] === 'Bodies') bodies++
  // The shown world, and the empty one that every page keeps.
  expect(bodies).toBe(2)
})

test('a stage within a screen of the view plans its drop, so that the first chip comes at once when it is seen', async ({
  stage,
  page,
}) => {
  const slices = await countSlices(page)
  await keepWaits(page, 0)
  await page.setViewportSize({ width: 800, height: 600 })
  await stage.open('pile', { above: 900, below: 900, upright: true })
  await stage.reaches('waiting')
  let before = -1
  await expect
    .poll(async () => {
      const now = await slices()
      const same = now === before && now > 0
      before = now
      return same
    })
    .toBe(true)
  const asked = await page.evaluate(() => window.waits.length)
  await page.mouse.wheel(0, 700)
  await stage.reaches('running')
  // It comes up to 120 ms late by its own scatter.
  expect(await page.evaluate((asked) => window.waits[asked], asked)).toBeLessThan(130)
})

test('a square that stands on another side than it fell on, and then grows wide, lies as it is drawn', async ({
  stage,
}) => {
  await stage.settled('pile', { chips: 12, shape: 'disc' })
  await stage.chips.evaluateAll((all) => {
    for (const chip of all) Object.assign((chip.firstElementChild as HTMLElement).style, { width: '90px' })
  })
  await stage.reaches('running')
  await stage.reaches('resting')
  expect(await stage.overlap()).toBeLessThan(1)
  expect(await stage.hovering()).toBeLessThan(0.5)
})

test('of 15 words that are shaken again and again at most one in five comes down on its head', async ({
  stage,
  page,
}) => {
  await page.addInitScript(takeFrames)
  await stage.open('pile', { chips: 15, stagger: 60, shaker: true })
  await stage.reaches('running')
  const settle = () => page.evaluate((times) => window.drive(times), Array<number>(3000).fill(1000 / 60))
  await settle()
  let down = 0
  for (let shake = 0; shake < 8; shake++) {
    await page.getByRole('button', { name: 'Shake' }).click()
    await stage.reaches('running')
    await settle()
    down += (await fallen(stage)).words
  }
  expect(down / (8 * 15)).toBeLessThanOrEqual(0.2)
})

test('with `initial={false}` the row stands until the pile lies there: the pile of a drop, words the right way up', async ({
  stage,
  page,
}) => {
  await stage.settled('pile', { chips: 20, shape: 'all' })
  const dropped = await stage.pile()
  const letCome = await withhold(page, '**/client-*.js')
  await page.goto('/pile?chips=20&shape=all&initial=false', { waitUntil: 'commit' })
  await expect(stage.chips.nth(19)).toBeVisible()
  const row = await stage.chips.evaluateAll((all) => all.map((chip) => chip.getBoundingClientRect().y))
  const { y, height } = (await stage.root.boundingBox())!
  for (const top of row) expect(top).toBeGreaterThan(y)
  expect(Math.max(...row)).toBeLessThan(y + height)
  letCome()
  await stage.reaches('resting')
  const { poses } = await stage.pile()
  for (const [i, { x, y }] of poses.entries())
    expect(Math.hypot(x - dropped.poses[i].x, y - dropped.poses[i].y), `chip ${i}`).toBeLessThan(0.3)
  expect((await fallen(stage)).words).toBe(0)
  expect(await stage.overlap()).toBeLessThan(1)
  const { states, frames } = await stage.probe(({ states, frames }) => ({ states, frames }))
  expect(states).toEqual(['waiting', 'resting'])
  expect(frames).toBe(0)
})

test('a pile that lay there from the start can be grabbed, shaken and rests again', async ({
  stage,
  page,
}) => {
  await stage.settled('pile', { chips: 8, initial: false, shaker: true })
  await stage.drag(stage.chips.first(), 0, -100)
  await expect(stage.chips.first()).toHaveAttribute('data-state', 'held')
  await page.mouse.up()
  await stage.reaches('resting')
  await page.getByRole('button', { name: 'Shake' }).click()
  await stage.reaches('running')
  await stage.reaches('resting')
  expect(await stage.overlap()).toBeLessThan(1)
})

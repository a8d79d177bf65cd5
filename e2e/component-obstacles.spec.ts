import type { Page } from '@playwright/test'
import { chipDistance, type Pose, type Shape } from '../scenes/exact-distance'
import { seeded } from '../scenes/seeded'
import { expect, type StagePage, test } from './fixtures/stage'

/** Size, radius and pose of what chips land on, px of the stage, as it is drawn. */
async function obstaclesOf(page: Page): Promise<(Shape & Pose)[]> {
  return page.evaluate(() => {
    const stage = document.querySelector('[data-slot=gravity-stack]')!.getBoundingClientRect()
    return [...document.querySelectorAll<HTMLElement>('[data-static], h1')].map((element) => {
      const box = element.getBoundingClientRect()
      const style = getComputedStyle(element)
      const [width, height] = [Number.parseFloat(style.width), Number.parseFloat(style.height)]
      return {
        width,
        height,
        radius: Math.min(
          Number.parseFloat(style.borderRadius.replace('infinity * ', '9e9')),
          width / 2,
          height / 2,
        ),
        x: box.x + box.width / 2 - stage.x,
        y: box.y + box.height / 2 - stage.y,
        angle: ((Number.parseFloat(style.rotate) || 0) * Math.PI) / 180,
      }
    })
  })
}

/** px, the deepest that a chip is drawn in an obstacle, and how many chips touch one. */
async function against(stage: StagePage) {
  const [{ shapes, poses }, obstacles] = [await stage.pile(), await obstaclesOf(stage.page)]
  const gaps = shapes.flatMap((shape, i) =>
    obstacles.map((body) => chipDistance(shape, poses[i], body, body)),
  )
  return {
    deepest: Math.max(0, ...gaps.map((gap) => -gap)),
    touching: gaps.filter((gap) => gap < 0.1).length,
  }
}

async function expectRest(stage: StagePage) {
  await stage.reaches('resting')
  expect((await against(stage)).deepest).toBeLessThan(0.05)
  expect(await stage.overlap()).toBeLessThan(0.05)
  expect(await stage.outside()).toBeLessThan(0.05)
}

test('chips land and rest on a heading under the stage, on a turned plank, a pill and a disc, and nothing runs any more', async ({
  stage,
}) => {
  await stage.settled('obstacles', { shelves: 1, n: 24 })
  await expectRest(stage)
  expect((await against(stage)).touching).toBeGreaterThan(4)
  await expect(stage.chips).toHaveCount(24)
  expect(await stage.during('frames')).toBe(0)
  // What stays is no chip: the stage never wrote to it.
  const plank = stage.page.locator('#turned')
  expect(await plank.getAttribute('style')).toBeNull()
  expect(await plank.evaluate((element) => element.parentElement!.dataset.slot)).toBe('gravity-stack')
})

test('chips land on a heading whose middle lies exactly at the left edge of the stage', async ({ stage }) => {
  await stage.settled('obstacles', { left: '-150px' })
  await expectRest(stage)
  expect((await against(stage)).touching).toBeGreaterThan(0)
})

for (const act of ['moves', 'grows', 'goes'])
  test(`a heading that ${act} wakes the chips that lie on it, and they come to rest again`, async ({
    stage,
  }) => {
    await stage.settled('obstacles')
    const before = await stage.pile()
    expect((await against(stage)).touching).toBeGreaterThan(0)
    await stage.page.locator(`#${act}`).click()
    await expect(stage.root).not.toHaveAttribute('data-state', 'resting')
    await expectRest(stage)
    const after = await stage.pile()
    expect(after.poses.some(({ y }, i) => Math.abs(y - before.poses[i].y) > 5)).toBe(true)
  })

test('a heading that is moved by the page around it, without a word from React, is followed', async ({
  stage,
}) => {
  await stage.settled('obstacles')
  await stage.page.evaluate(() => {
    document.querySelector('h1')!.animate([{}, { translate: '0 60px' }], { duration: 300, fill: 'forwards' })
  })
  await expect(stage.root).not.toHaveAttribute('data-state', 'resting')
  await expectRest(stage)
})

test('a page that scrolls wakes no pile that lies on a heading', async ({ stage }) => {
  await stage.settled('obstacles')
  await stage.page.evaluate(() => {
    document.body.style.height = '3000px'
    document.body.style.paddingTop = '0.4px'
  })
  await stage.page.evaluate(async () => {
    for (let n = 0; n < 10; n++) {
      window.scrollBy(0, 13)
      await window.probe.pass(2)
    }
  })
  await expect(stage.root).toHaveAttribute('data-state', 'resting')
  expect(await stage.probe((probe) => probe.states.filter((state) => state === 'resting').length)).toBe(1)
})

test('a pile that lies there from the start lies on the heading', async ({ stage }) => {
  await stage.settled('obstacles', { initial: 'false' })
  await expectRest(stage)
  expect((await against(stage)).touching).toBeGreaterThan(0)
})

test('with reduced motion, in print and without script planks stay where they are', async ({
  stage,
  page,
  browser,
  baseURL,
}) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await stage.open('obstacles', { shelves: 1 })
  await stage.reaches('static')
  const moved = await obstaclesOf(page)
  await page.emulateMedia({ reducedMotion: 'no-preference', media: 'print' })
  expect(await obstaclesOf(page)).toEqual(moved)
  const still = await browser.newContext({ baseURL, javaScriptEnabled: false })
  const plain = await still.newPage()
  await plain.goto('/obstacles?shelves=1')
  const box = (await plain.locator('#turned').boundingBox())!
  const root = (await plain.locator('[data-slot=gravity-stack]').boundingBox())!
  expect(box.x + box.width / 2 - root.x).toBeCloseTo(moved.find(({ angle }) => angle !== 0)!.x, 0)
  await still.close()
})

test('after gravity turns to the right the pile rests on the right wall, and after it turns up under the top, all inside', async ({
  stage,
}) => {
  await stage.settled('obstacles', { heading: '', ceiling: 1 })
  const middle = async (axis: 'x' | 'y') => {
    const { poses } = await stage.pile()
    return poses.reduce((sum, pose) => sum + pose[axis], 0) / poses.length
  }
  for (const [to, axis, from, until] of [
    ['right', 'x', 480, 640],
    ['up', 'y', 0, 120],
    ['down', 'y', 300, 384],
  ] as const) {
    await stage.page.locator(`#${to}`).click()
    await expect(stage.root).not.toHaveAttribute('data-state', 'resting')
    await expectRest(stage)
    expect(await middle(axis), to).toBeGreaterThan(from)
    expect(await middle(axis), to).toBeLessThan(until)
    const { shapes, poses } = await stage.pile()
    for (const [i, { y }] of poses.entries()) expect(y).toBeGreaterThan(shapes[i].height / 2 - 1)
  }
  // A tapped chip leaves what it lies on.
  await stage.page.locator('#up').click()
  await expectRest(stage)
  await stage.chips.first().click()
  await expect(stage.chips.first()).not.toHaveAttribute('data-state', 'resting')
  await expectRest(stage)
})

test('chips come in from above and rest under the top when gravity points up from the start, closed top or not', async ({
  stage,
}) => {
  await stage.open('obstacles', { heading: '', odd: 'up' })
  await expectRest(stage)
  const { poses } = await stage.pile()
  for (const { y } of poses) expect(y).toBeGreaterThan(16)
  expect(await stage.probe((probe) => probe.warnings)).toEqual([
    expect.stringContaining('gravity points up and ceiling is not set, so the top is closed.'),
  ])
})

/** What a stage is given that nobody should, and what a developer is told. */
const wrong: Record<string, RegExp> = {
  nan: /gravity is \{ x: NaN, y: 2600 \}, .+, so \{ x: 0, y: 2600 \} stands in for it\. Pass both/,
  missing: /gravity is \{ x: undefined, y: 1000 \}, .+, so \{ x: 0, y: 1000 \} stands in for it\. Pass both/,
  flat: /an obstacle has no size, so .+\. They land on it once it has one/,
  whole: /an obstacle is as large as its stage .+, so .+\. Make it smaller/,
  ancestor: /an obstacle is the stage itself or around it, so .+\. Pass elements beside/,
  null: /a ref among obstacles leads to no element yet, so .+\. Give an element this ref, then render/,
  lid: /an obstacle reaches out of the top of its stage .+, so .+\. Move it down/,
}
for (const [odd, message] of Object.entries(wrong))
  test(`whatever is wrong with an obstacle or with gravity, no chip is lost and a developer is told why: ${odd}`, async ({
    stage,
  }) => {
    await stage.settled('obstacles', { odd, heading: '' })
    expect(new Set(await stage.states())).toEqual(new Set(['resting']))
    await expect(stage.chips).toHaveCount(12)
    const warnings = await stage.probe((probe) => probe.warnings)
    expect(warnings).toHaveLength(1)
    expect(warnings[0]).toMatch(message)
    const { poses } = await stage.pile()
    // A lid keeps them out, yet none of them falls for ever.
    for (const { y } of poses) expect(y > (odd === 'lid' ? -2000 : 10) && y < 384).toBe(true)
  })

test('an obstacle that has a slot of its own is no chip', async ({ stage }) => {
  await stage.settled('obstacles', { odd: 'slot', heading: '' })
  await expect(stage.chips).toHaveCount(12)
  await expectRest(stage)
})

test('a mouse over the stage shoves chips aside as it moves, and a pile that it rests on sleeps', async ({
  stage,
  page,
}) => {
  await stage.settled('obstacles', { heading: '', push: 40 })
  const before = await stage.pile()
  const { x, y } = (await stage.root.boundingBox())!
  await page.mouse.move(x + 20, y + 350)
  await page.mouse.move(x + 600, y + 350, { steps: 20 })
  await expect(stage.root).not.toHaveAttribute('data-state', 'resting')
  await expectRest(stage)
  const after = await stage.pile()
  const moved = after.poses.filter((pose, i) => Math.abs(pose.x - before.poses[i].x) > 5)
  expect(moved.length).toBeGreaterThan(3)
  expect(await stage.during('frames')).toBe(0)
})

for (const [who, params] of Object.entries<Record<string, string | number>>({
  'a stage that is not interactive': { push: 40, interactive: 'no' },
  'a stage without push': {},
}))
  test(`a mouse shoves nothing in ${who}`, async ({ stage, page }) => {
    await stage.settled('obstacles', { heading: '', ...params })
    const { x, y } = (await stage.root.boundingBox())!
    await page.mouse.move(x + 20, y + 350)
    await page.mouse.move(x + 600, y + 350, { steps: 20 })
    await stage.probe((probe) => probe.pass(3))
    await expect(stage.root).toHaveAttribute('data-state', 'resting')
    expect(await stage.probe((probe) => probe.listeners.pointermove ?? 0)).toBe(0)
  })

test('a mouse shoves nothing in a row of reduced motion', async ({ stage, page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await stage.open('obstacles', { heading: '', push: 40 })
  await stage.reaches('static')
  const before = await stage.pile()
  const { x, y } = (await stage.root.boundingBox())!
  await page.mouse.move(x + 20, y + 350)
  await page.mouse.move(x + 600, y + 350, { steps: 20 })
  await stage.probe((probe) => probe.pass(3))
  await expect(stage.root).toHaveAttribute('data-state', 'static')
  expect(await stage.pile()).toEqual(before)
})

test('fingers shove nothing', async ({ stage, page }) => {
  await stage.settled('obstacles', { heading: '', push: 40 })
  await page.evaluate(async () => {
    const stage = document.querySelector('[data-slot=gravity-stack]')!
    const { x, y } = stage.getBoundingClientRect()
    for (let n = 0; n < 30; n++) {
      const at = { clientX: x + 20 * n, clientY: y + 350, pointerType: 'touch', bubbles: true }
      stage.dispatchEvent(new PointerEvent('pointermove', at))
      await window.probe.pass(1)
    }
  })
  await expect(stage.root).toHaveAttribute('data-state', 'resting')
})

test('ten thousand wild moves of a mouse lose no chip', async ({ stage, page }) => {
  const random = seeded(5)
  const ways = Array.from({ length: 10_000 }, () => [700 * random() - 30, 440 * random() - 30])
  await stage.settled('obstacles', { shelves: 1, push: 60 })
  await page.evaluate(async (ways) => {
    const stage = document.querySelector('[data-slot=gravity-stack]')!
    const { left, top } = stage.getBoundingClientRect()
    for (const [n, [x, y]] of ways.entries()) {
      const at = { clientX: left + x, clientY: top + y, pointerType: 'mouse', bubbles: true }
      stage.dispatchEvent(new PointerEvent('pointermove', at))
      if (n % 50 === 0) await window.probe.pass(1)
    }
  }, ways)
  await expectRest(stage)
  expect(new Set(await stage.states())).toEqual(new Set(['resting']))
})

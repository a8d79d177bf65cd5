import { expect, StagePage, test } from './fixtures/stage'

test('after a hundred mounts nothing is left of any but the last', async ({ stage, page }) => {
  await stage.settled('mounts')
  const read = () =>
    stage.probe(({ observed, listeners, timers }) => ({
      observed: { ...observed },
      listeners: { ...listeners },
      timers,
    }))
  const before = await read()
  await page.evaluate(async () => {
    const button = document.getElementById('toggle')!
    for (let i = 0; i < 200; i++) {
      button.click()
      await window.probe.pass(i % 7 === 1 ? 6 : 1)
    }
  })
  await stage.reaches('resting')
  expect(await read()).toEqual(before)
  await page.locator('#toggle').click()
  await expect(stage.root).toHaveCount(0)
  await stage.isGone()
})

test('a stage unmounted in mid-fall leaves no frame and no timer behind', async ({ stage, page }) => {
  await stage.open('mounts')
  await expect(stage.chips.nth(1)).toHaveAttribute('data-state', 'falling')
  await page.locator('#toggle').click()
  await expect(stage.root).toHaveCount(0)
  expect(await stage.during('frames')).toBe(0)
  expect(await stage.probe((probe) => probe.timers)).toBe(0)
})

test('the browser keeps no node and no listener of a stage that has gone', async ({ stage, page }) => {
  await stage.settled('mounts')
  const session = await page.context().newCDPSession(page)
  await session.send('Performance.enable')
  const kept = async () => {
    await session.send('HeapProfiler.collectGarbage')
    const { metrics } = await session.send('Performance.getMetrics')
    const of = (name: string) => metrics.find((metric) => metric.name === name)!.value
    return { nodes: of('Nodes'), listeners: of('JSEventListeners') }
  }
  const cycle = (times: number) =>
    page.evaluate(async (times) => {
      for (let i = 0; i < 2 * times; i++) {
        document.getElementById('toggle')!.click()
        await window.probe.pass(i % 2 ? 4 : 1)
      }
    }, times)
  // React itself keeps the last tree it has dropped.
  await cycle(3)
  await stage.reaches('resting')
  const before = await kept()
  await cycle(40)
  await stage.reaches('resting')
  const after = await kept()
  expect(after.nodes - before.nodes).toBeLessThan(30)
  expect(after.listeners - before.listeners).toBeLessThan(5)
})

test('actions of a stage that has gone do nothing', async ({ stage, page }) => {
  await stage.settled('extras')
  await page.evaluate(() => window.unmount())
  expect(await page.evaluate(() => window.kept.map((act) => act()))).toEqual(Array(4).fill(undefined))
  expect(await stage.during('frames')).toBe(0)
  await expect(page.locator('#settled')).toHaveText('1')
})

test('a child that has gone is watched no more', async ({ stage, page }) => {
  await stage.settled('children')
  const watched = () => stage.probe((probe) => probe.observed.resize)
  expect(await watched()).toBe(12)
  await page.evaluate(() => window.remove('three'))
  await expect(stage.chips).toHaveCount(10)
  await expect.poll(watched).toBe(11)
})

test('what others put into the stage stays as they made it', async ({ stage }) => {
  await stage.settled('pile', { chips: 3 })
  const seen = await stage.root.evaluate(async (root) => {
    const other = root.appendChild(document.createElement('div'))
    other.style.cssText = 'position: absolute; width: 50px; height: 20px'
    const before = other.outerHTML
    await window.probe.pass(10)
    return other.outerHTML === before
  })
  expect(seen).toBe(true)
  await stage.reaches('resting')
})

test('a stage that goes just as a finger comes down on it leaves no timer behind', async ({ stage }) => {
  await stage.settled('mounts')
  await stage.chips.first().evaluate((chip) => {
    const { x, y, width, height } = chip.getBoundingClientRect()
    const at = { clientX: x + width / 2, clientY: y + height / 2 }
    chip.dispatchEvent(new PointerEvent('pointerdown', { ...at, pointerType: 'touch', bubbles: true }))
    document.querySelector<HTMLElement>('#toggle')!.click()
  })
  await stage.isGone()
  expect(await stage.probe((probe) => probe.timers)).toBe(0)
})

test('a stage that was scaled to nothing and goes leaves no timer behind', async ({ stage, page }) => {
  await stage.settled('mounts')
  const toggle = () => page.locator('#toggle').evaluate((button: HTMLElement) => button.click())
  await toggle()
  await page.locator('main').evaluate((main) => {
    main.style.transform = 'scale(0)'
  })
  await toggle()
  await stage.reaches('waiting')
  await expect.poll(() => stage.probe((probe) => probe.timers)).toBe(1)
  await toggle()
  await expect(stage.root).toHaveCount(0)
  await stage.probe((probe) => probe.pass(30))
  await stage.isGone()
})

test('a pile goes on, and another begins, after an error of somebody else has ended Motion’s loop for the page', async ({
  stage,
  page,
}) => {
  await stage.open('surroundings', { kind: 'foreign error' })
  await expect(stage.chip('two')).toHaveAttribute('data-state', 'falling')
  await page.locator('#throw').evaluate((button: HTMLElement) => button.click())
  await expect
    .poll(() => stage.probe((probe) => probe.errors.splice(0).join()))
    .toContain('of another component')
  await stage.reaches('resting')
  expect(await stage.overlap()).toBeLessThan(1)
  expect(await stage.during('frames')).toBe(0)

  await page.locator('#next').click()
  const second = new StagePage(page, page.locator('[data-slot=gravity-stack]').nth(1))
  await second.reaches('resting')

  await stage.drag(stage.chip('two'), 40, -90)
  await stage.hangs(stage.chip('two'))
  await page.mouse.up()
  await stage.reaches('resting')
})

import { hideTab } from './fixtures/hide-tab'
import { expect, test } from './fixtures/stage'

test('out of view the stage pauses, and goes on where it was', async ({ stage, page }) => {
  await page.setViewportSize({ width: 800, height: 500 })
  await stage.open('pile', { chips: 40, below: 2000 })
  await expect(stage.chips.nth(5)).toHaveAttribute('data-state', 'falling')
  await page.mouse.wheel(0, 1500)
  await stage.reaches('paused')
  expect(await stage.during('frames')).toBe(0)
  expect(await stage.probe((probe) => probe.timers)).toBe(0)
  const { poses } = await stage.pile()
  expect(new Set(await layers(stage.chips))).toEqual(new Set(['auto']))
  expect((await stage.pile()).poses).toEqual(poses)
  await page.mouse.wheel(0, -1500)
  await stage.reaches('resting')
  expect(await stage.overlap()).toBeLessThan(1)
  // A drop that began anew would have let go of the first ones twice.
  const released = await stage.probe((probe) => probe.releases.map(([chip]) => chip))
  expect(released).toEqual([...Array(40).keys()])
})

test('a stage that folds up in mid-fall pauses, and goes on where it was once it opens', async ({
  stage,
}) => {
  await stage.open('pile', { chips: 12 })
  await expect(stage.chips.nth(3)).toHaveAttribute('data-state', 'falling')
  // Without a height it still counts as in view.
  await stage.root.evaluate((root) => {
    root.style.height = '0'
  })
  await stage.reaches('paused')
  expect(await stage.during('frames')).toBe(0)
  expect(await stage.probe((probe) => probe.timers)).toBe(0)
  await stage.root.evaluate((root) => {
    root.style.height = ''
  })
  await stage.reaches('resting')
  expect(await stage.overlap()).toBeLessThan(1)
  const released = await stage.probe((probe) => probe.releases.map(([chip]) => chip))
  expect(released).toEqual([...Array(12).keys()])
})

const layers = (chips: import('@playwright/test').Locator) =>
  chips.evaluateAll((all) => all.map((chip) => getComputedStyle(chip).willChange))

test('in a hidden tab the stage pauses, and a held chip is let go', async ({ stage, page }) => {
  await stage.open('pile', { chips: 2, stagger: 60000 })
  const chip = stage.chips.nth(0)
  await expect(chip).toHaveAttribute('data-state', 'resting')
  await stage.drag(chip, 0, -40)
  await expect(chip).toHaveAttribute('data-state', 'held')
  await page.evaluate(hideTab, true)
  await stage.reaches('paused')
  await expect(chip).not.toHaveAttribute('data-state', 'held')
  expect(await stage.during('frames')).toBe(0)
  expect(await stage.probe((probe) => probe.timers)).toBe(0)
  await page.evaluate(hideTab, false)
  await stage.reaches('running')
  await expect(chip).toHaveAttribute('data-state', 'resting')
  await page.mouse.up()
})

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

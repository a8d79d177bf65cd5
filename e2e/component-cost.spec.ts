import type { CDPSession, Page } from '@playwright/test'
import { median } from '../bench/accuracy/trajectory'
import { categories, Trace } from '../bench/browser/trace'
import { hideTab } from './fixtures/hide-tab'
import { expect, StagePage, test } from './fixtures/stage'

test('before the stage is near the view nothing runs: no frame, no layout read, one shared observer', async ({
  stage,
  page,
}) => {
  await page.setViewportSize({ width: 800, height: 500 })
  await stage.open('pile', { above: 1500, below: 500 })
  await page.waitForLoadState('networkidle')
  await page.evaluate(() => window.probe.pass(20))
  const cost = await stage.probe(({ frames, layoutReads, styleWrites, timers, observed, listeners }) => ({
    frames,
    layoutReads,
    styleWrites,
    timers,
    observed: { ...observed },
    listeners: { ...listeners },
  }))
  expect(cost).toEqual({
    frames: 0,
    layoutReads: 0,
    styleWrites: 0,
    timers: 0,
    observed: { intersection: 1, resize: 0, mutation: 0 },
    listeners: {},
  })
})

test('waiting for the next release while all others sleep, a timer runs and no frames', async ({ stage }) => {
  await stage.open('pile', { chips: 2, stagger: 60000 })
  await expect(stage.chips.first()).toHaveAttribute('data-state', 'resting')
  expect(await stage.during('frames')).toBe(0)
  expect(await stage.probe((probe) => probe.timers)).toBe(1)
  await stage.reaches('running')
})

test('after that wait the next chip falls as ever', async ({ stage }) => {
  await stage.settled('pile', { chips: 3, stagger: 2500 })
  expect(await stage.overlap()).toBeLessThan(1)
})

test('what pointers do elsewhere on the page is heard only while one is down on a chip', async ({
  stage,
  page,
}) => {
  await stage.settled('pile')
  const heard = () => stage.probe((probe) => Object.keys(probe.listeners).sort())
  const ofThePage = ['dragstart', 'lostpointercapture', 'pointercancel', 'pointermove', 'pointerup', 'scroll']
  const idle = await heard()
  expect(idle.filter((type) => ofThePage.includes(type))).toEqual([])
  await stage.drag(stage.chips.first(), 30, -60)
  expect(await heard()).toEqual([...idle, ...ofThePage].sort())
  await page.mouse.up()
  expect(await heard()).toEqual(idle)
})

test('a chip is drawn again only when one of its corners has gone a tenth of a pixel', async ({ stage }) => {
  await stage.settled('pile', { chips: 40, shape: 'all' })
  const { writes, smallest, shift } = await stage.probe((probe) => ({
    writes: probe.styleWrites,
    smallest: probe.smallestMove,
    shift: probe.smallestShift,
  }))
  expect(writes).toBeGreaterThan(500)
  expect(smallest).toBeGreaterThanOrEqual(0.1)
  // And no later than that: what creeps would be seen to jerk.
  expect(smallest).toBeLessThan(0.15)
  // Also where it only turns.
  expect(shift).toBeLessThan(0.05)
})

test('a frame writes each moved chip once, its transform alone, reads no layout and wakes no observer', async ({
  stage,
  page,
}) => {
  await stage.open('pile', { chips: 30, stagger: 0 })
  await stage.reaches('running')
  const worst = await page.evaluate(async () => {
    // A chip is looked at when it is released: from then on it isn't.
    while (document.querySelector('[data-slot=gravity-stack-chip][data-state=waiting]'))
      await window.probe.pass(1)
    const chips = [...document.querySelectorAll<HTMLElement>('[data-slot=gravity-stack-chip]')]
    const rest = () => chips.map((chip) => chip.style.cssText.replace(/transform: [^;]+;/, '')).join()
    const reads = window.probe.layoutReads
    const mutations = window.probe.mutations
    const others = rest()
    let most = 0
    for (let i = 0; i < 30; i++) {
      const before = window.probe.styleWrites
      await window.probe.pass(1)
      most = Math.max(most, window.probe.styleWrites - before)
    }
    return {
      most,
      reads: window.probe.layoutReads - reads,
      mutations: window.probe.mutations - mutations,
      others: rest() === others,
    }
  })
  expect(worst.most).toBeGreaterThan(10)
  expect(worst.most).toBeLessThanOrEqual(30)
  expect(worst.reads).toBe(0)
  expect(worst.mutations).toBe(0)
  expect(worst.others).toBe(true)
})

test('only chips that move have a layer of their own', async ({ stage, page }) => {
  await stage.open('pile', { chips: 12, stagger: 300 })
  await expect(stage.chips.nth(6)).toHaveAttribute('data-state', 'falling')
  const layers = await stage.chips.evaluateAll((all) =>
    all.map((chip) => [(chip as HTMLElement).dataset.state, getComputedStyle(chip).willChange]),
  )
  for (const [state, layer] of layers) expect(layer).toBe(state === 'falling' ? 'transform' : 'auto')
  await stage.reaches('resting')
  expect(
    await page.locator('[data-slot=gravity-stack]').evaluate((root) => getComputedStyle(root).contain),
  ).toBe('content')
})

test('chips that wait have nothing to paint, so that no layer is looked through for them', async ({
  stage,
}) => {
  await stage.open('pile', { chips: 12, stagger: 300 })
  await expect(stage.chips.nth(6)).toHaveAttribute('data-state', 'falling')
  const clips = await stage.chips.evaluateAll((all) =>
    all.map((chip) => [(chip as HTMLElement).dataset.state, getComputedStyle(chip).clipPath]),
  )
  expect(clips.map(([state]) => state)).toEqual(expect.arrayContaining(['waiting', 'falling']))
  for (const [state, clip] of clips) expect(clip).toBe(state === 'waiting' ? 'inset(50%)' : 'none')
})

test('while one chip is lifted, those that do not touch it sleep on and are not drawn', async ({
  stage,
  page,
}) => {
  await stage.settled('pile', { chips: 3 })
  const chip = stage.chips.nth(0)
  const styles = () =>
    stage.chips.evaluateAll((all) => all.slice(1).map((other) => other.getAttribute('style')))
  const before = await styles()
  await stage.drag(chip, 0, -120)
  await expect(chip).toHaveAttribute('data-state', 'held')
  await stage.hangs(chip)
  expect(await stage.states()).toEqual(['held', 'resting', 'resting'])
  expect(await styles()).toEqual(before)
  await page.mouse.up()
})

test('a drop of 60 chips reads the size of the stage, and the style of a chip when it is released', async ({
  stage,
}) => {
  const reads = () => stage.probe((probe) => probe.layoutReads)
  await stage.open('pile', { chips: 60, stagger: 60000 })
  await stage.reaches('running')
  await expect(stage.chips.first()).toHaveAttribute('data-state', 'resting')
  // The two inner lengths of the stage, three computed styles (of the first chip as its release is planned
  // and as it comes, of the second as its is planned), and in development a look for Tailwind's styles. React
  // StrictMode mounts twice, and only the second mount comes to see.
  expect(await reads()).toBeLessThanOrEqual(6)
})

/**
 * Counts how often the page is laid out from now on. The session has to last: the browser counts for it
 * alone.
 */
async function layoutsFromNow(page: Page) {
  const session = await page.context().newCDPSession(page)
  await session.send('Performance.enable')
  const read = async () => {
    const { metrics } = await session.send('Performance.getMetrics')
    return metrics.find(({ name }) => name === 'LayoutCount')!.value
  }
  const before = await read()
  return async () => (await read()) - before
}

test('bringing 60 chips to life lays the page out once, the first release included', async ({
  stage,
  page,
}) => {
  let layouts = async () => Number.NaN
  await page.route('**/client-*.js', async (route) => {
    await page.evaluate(() => window.probe.pass(3))
    layouts = await layoutsFromNow(page)
    await route.continue()
  })
  await stage.open('pile', { chips: 60, stagger: 60000 })
  await stage.reaches('running')
  await expect(stage.chips.first()).toHaveAttribute('data-state', 'resting')
  expect(await layouts()).toBeLessThanOrEqual(1)
})

test('no chip that is released, falls, lands or falls asleep lays the page out', async ({ stage, page }) => {
  await stage.open('pile', { chips: 20, stagger: 200, shape: 'all' })
  await expect(stage.chips.first()).toHaveAttribute('data-state', 'falling')
  const layouts = await layoutsFromNow(page)
  expect(await stage.states()).toContain('waiting')
  await stage.reaches('resting')
  expect(await layouts()).toBe(0)
})

test('in a trace of a drop no frame makes the browser lay out or style in the middle of the script', async ({
  page,
  browser,
}) => {
  // Without the probe, which measures chips itself.
  const stage = new StagePage(page)
  await stage.open('pile', { chips: 30, stagger: 60, shape: 'all' })
  await browser.startTracing(page, { categories })
  await stage.reaches('resting')
  const trace = new Trace(await browser.stopTracing())
  expect(trace.frames(0, Number.POSITIVE_INFINITY).frames).toBeGreaterThan(10)
  expect(trace.forced(0, Number.POSITIVE_INFINITY, new Set(['FireAnimationFrame']))).toBe(0)
})

for (const [where, path, params] of [
  ['', 'pile', { chips: 30, stagger: 60, shape: 'all' }],
  [', though the page gives every element a transition', 'surroundings', { kind: 'transitions' }],
] as const)
  test(`a chip that only moves is not held against the rules of the page again${where}`, async ({
    stage,
    browser,
  }) => {
    await stage.open(path, params)
    await browser.startTracing(stage.page, { categories: [...categories, 'blink_style'] })
    await stage.reaches('resting')
    const trace = new Trace(await browser.stopTracing())
    const counted = trace.main
      .filter(({ name }) => name === 'Document::updateStyle')
      .map(({ args }) => args.counters as { elementsStyled: number; rulesMatched: number })
      .filter(({ elementsStyled }) => elementsStyled)
    expect(counted.length).toBeGreaterThan(10)
    // Frames in which a chip is released or falls asleep ask the rules.
    expect(median(counted.map(({ rulesMatched }) => rulesMatched))).toBe(0)
  })

test('a shaken chip, which told its angle while it lay, is not held against the rules of the page in each frame', async ({
  stage,
  browser,
}) => {
  await stage.settled('pile', { chips: 20, stagger: 0, shaker: true })
  await browser.startTracing(stage.page, { categories: [...categories, 'blink_style'] })
  await stage.page.getByRole('button', { name: 'Shake' }).click()
  await stage.reaches('running')
  await stage.reaches('resting')
  const trace = new Trace(await browser.stopTracing())
  const counted = trace.main
    .filter(({ name }) => name === 'Document::updateStyle')
    .map(({ args }) => args.counters as { elementsStyled: number; rulesMatched: number })
    .filter(({ elementsStyled }) => elementsStyled)
  expect(counted.length).toBeGreaterThan(10)
  expect(median(counted.map(({ rulesMatched }) => rulesMatched))).toBe(0)
})

test('as the stage comes into view and begins, no chip that waits is styled anew', async ({
  stage,
  browser,
}) => {
  await stage.page.setViewportSize({ width: 800, height: 500 })
  await stage.open('pile', { chips: 30, stagger: 60000, above: 1500, below: 500 })
  await browser.startTracing(stage.page, { categories: [...categories, 'blink_style'] })
  await stage.page.evaluate(() => scrollTo(0, 1400))
  await expect(stage.chips.first()).toHaveAttribute('data-state', 'resting')
  expect(await stage.probe((probe) => probe.states)).toEqual(['waiting', 'running'])
  const trace = new Trace(await browser.stopTracing())
  const styled = trace.main
    .filter(({ name }) => name === 'Document::updateStyle')
    .map(({ args }) => (args.counters as { elementsStyled: number }).elementsStyled)
  expect(styled.length).toBeGreaterThan(2)
  expect(Math.max(...styled)).toBeLessThan(30)
})

/** Nodes of the stage that have a layer of their own, by the browser's ids. The map follows every change. */
async function layersOf(page: Page) {
  const session = await page.context().newCDPSession(page)
  await session.send('DOM.enable')
  const { root } = await session.send('DOM.getDocument')
  const { nodeId } = await session.send('DOM.querySelector', {
    nodeId: root.nodeId,
    selector: '[data-slot=gravity-stack]',
  })
  const { node: stage } = await session.send('DOM.describeNode', { nodeId, depth: -1 })
  type Node = typeof stage
  const inside = new Map<number, Node>()
  const enter = (node: Node, chip: Node) => {
    inside.set(node.backendNodeId, chip)
    for (const child of node.children ?? []) enter(child, chip)
  }
  for (const chip of stage.children ?? []) enter(chip, chip)
  const seen = { now: [] as number[], most: 0, doubled: false }
  session.on('LayerTree.layerTreeDidChange', ({ layers = [] }) => {
    seen.now = layers.flatMap(({ backendNodeId = 0 }) => inside.get(backendNodeId)?.backendNodeId ?? [])
    seen.most = Math.max(seen.most, seen.now.length)
    seen.doubled ||= new Set(seen.now).size < seen.now.length
  })
  await session.send('LayerTree.enable')
  return seen
}

test('a chip in motion has one layer, a chip at rest none', async ({ stage, page }) => {
  await stage.settled('pile', { chips: 6, shaker: true })
  const layers = await layersOf(page)
  await page.getByRole('button', { name: 'Shake' }).click()
  await stage.reaches('resting')
  await expect.poll(() => layers.now).toEqual([])
  expect(layers.most).toBeGreaterThan(0)
  expect(layers.most).toBeLessThanOrEqual(6)
  // One that hangs from the pointer is the only one that moves.
  await stage.drag(stage.chips.nth(0), 0, -120)
  await stage.hangs(stage.chips.nth(0))
  await expect.poll(() => layers.now.length).toBe(1)
  await page.mouse.up()
  await stage.reaches('resting')
  await expect.poll(() => layers.now).toEqual([])
  expect(layers.doubled).toBe(false)
})

const idle: Record<string, () => void> = {
  'at rest': () => {},
  'off screen': () => scrollTo(0, 2000),
  'in a hidden tab': hideTab,
  paused: () => document.querySelector<HTMLElement>('#pause')!.click(),
}
for (const [when, bring] of Object.entries(idle)) {
  test(`${when}, no frame is asked for, no timer set, no layer kept, no style written`, async ({
    stage,
    page,
  }) => {
    await page.setViewportSize({ width: 800, height: 500 })
    await stage.settled('extras')
    const layers = await layersOf(page)
    const fall = async (then: () => void) => {
      document.body.style.paddingBottom = '3000px'
      document.querySelector<HTMLElement>('#drop')!.click()
      const chips = document.querySelectorAll<HTMLElement>('[data-slot=gravity-stack-chip]')
      while (chips[2].dataset.state !== 'falling') await window.probe.pass(1)
      then()
    }
    // In the page itself: on a busy machine all rest before a test can say a word.
    await page.evaluate(`(${fall})(${bring})`)
    await stage.reaches(when === 'at rest' ? 'resting' : 'paused')
    await expect.poll(() => layers.most).toBeGreaterThan(0)
    expect(await stage.during('frames')).toBe(0)
    expect(await stage.during('styleWrites')).toBe(0)
    expect(await stage.probe((probe) => probe.timers)).toBe(0)
    await expect.poll(() => layers.now).toEqual([])
    const changes = await stage.chips.evaluateAll((all) =>
      all.map((chip) => getComputedStyle(chip).willChange),
    )
    expect(new Set(changes)).toEqual(new Set(['auto']))
  })
}

test('with interactive off a press, a drag and a tap run no line of the pointers', async ({
  stage,
  page,
}) => {
  const hand = ['pointerMap', 'down', 'hold', 'move', 'click', 'createJoint', 'movePointer']
  /** Those of them that have run while a chip was pressed, dragged and tapped. */
  const runs = async (props: { interactive?: boolean }) => {
    await stage.settled('pile', { chips: 3, ...props })
    const session = await page.context().newCDPSession(page)
    await session.send('Profiler.enable')
    await session.send('Profiler.startPreciseCoverage', { callCount: true, detailed: false })
    const { x, y } = await stage.drag(stage.chips.nth(0), 60, -100)
    await page.mouse.up()
    await page.mouse.click(x, y)
    const { result } = await session.send('Profiler.takePreciseCoverage')
    return result
      .filter(({ url }) => /client-/.test(url))
      .flatMap(({ functions }) => functions)
      .filter(({ functionName, ranges }) => hand.includes(functionName) && ranges[0].count > 0)
      .map(({ functionName }) => functionName)
  }
  expect(await runs({})).toEqual(expect.arrayContaining(hand))
  expect(await runs({ interactive: false })).toEqual([])
})

/** Bytes that the page's own script has taken from the heap, whether given back since or not. */
async function allocated(session: CDPSession, work: () => Promise<unknown>) {
  await session.send('HeapProfiler.startSampling', {
    samplingInterval: 512,
    includeObjectsCollectedByMajorGC: true,
    includeObjectsCollectedByMinorGC: true,
  })
  await work()
  const { profile } = await session.send('HeapProfiler.stopSampling')
  type Node = (typeof profile)['head']
  const bytes = (node: Node): number =>
    (/client-/.test(node.callFrame.url) ? node.selfSize : 0) +
    node.children.reduce((sum, child) => sum + bytes(child), 0)
  return bytes(profile.head)
}

test('half a minute of a pile at work keeps nothing on the heap and makes little', async ({ page }) => {
  // Without the probe: the stack traces that it reads take and give back half a megabyte at any time.
  const stage = new StagePage(page)
  await stage.settled('pile', { chips: 60, stagger: 10, shaker: true })
  const session = await page.context().newCDPSession(page)
  await session.send('HeapProfiler.enable')
  const kept = async () => {
    await session.send('HeapProfiler.collectGarbage')
    return (await session.send('Runtime.getHeapUsage')).usedSize
  }
  /** Frames from a shake until the pile lies still again: what is at work holds now more, now less. */
  const work = () =>
    stage.root.evaluate(async (root) => {
      const frame = () => new Promise(requestAnimationFrame)
      document.querySelector('button')!.click()
      while (root.dataset.state === 'resting') await frame()
      let passed = 0
      for (; root.dataset.state !== 'resting'; passed++) await frame()
      return passed
    })
  // The first shakes size the arrays and compile the code.
  for (let i = 0; i < 4; i++) await work()
  let bytes = 0
  let frames = 0
  const growth: number[] = []
  // Two seconds each, on the stage's own clock.
  for (let i = 0; i < 15; i++) {
    const before = await kept()
    bytes += await allocated(session, async () => {
      frames += await work()
    })
    growth.push((await kept()) - before)
  }
  // What leaks grows with every shake; code that the engine compiles late, or throws away, tells of one only.
  const usual = growth.sort((a, b) => a - b)[growth.length >> 1]
  expect(usual * growth.length).toBeLessThan(100_000)
  expect(bytes / frames).toBeLessThan(20_000)
})

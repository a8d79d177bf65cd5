// What is measured of a stage, one function each, every one on a page of its own.
import type { Browser, CDPSession } from '@playwright/test'
import type {} from './observe'
import type {} from './replay'
import type { Drop, StageName } from './results'
import { categories, Trace } from './trace'
import { dropped, launch, marked, server, visit, wait, watched } from './visit'

/** s of the heap's samples, and of an empty frame loop. */
const heapSeconds = 30
const idleSeconds = 5

export async function timeDrop(
  browser: Browser,
  stage: StageName,
  [chips, stagger, throttle]: readonly number[],
) {
  const conditions = { stage, chips, stagger, throttle }
  return visit(browser, conditions, {}, async (page, _, start): Promise<Drop> => {
    await browser.startTracing(page, { categories })
    await start()
    await dropped(page, conditions)
    const trace = new Trace(await browser.stopTracing())
    const from = trace.mark('drawn') ?? Number.NaN
    const to = trace.mark('rest') ?? from + chips * stagger * 1000 + watched * 1e6
    return { chips, stagger, throttle, ...trace.frames(from, to) }
  })
}

/** Frames a second of a drop's writes without what worked them out, once all lies still. */
export async function timeReplay(
  browser: Browser,
  stage: StageName,
  [chips, stagger, throttle]: readonly number[],
) {
  const conditions = { stage, chips, stagger, throttle }
  return visit(browser, conditions, { recording: true }, async (page, _, start) => {
    await start()
    await dropped(page, conditions)
    await browser.startTracing(page, { categories })
    await page.evaluate(() => window.replay())
    await marked(page, 'replayed')
    const trace = new Trace(await browser.stopTracing())
    return trace.frames(trace.mark('replay') ?? Number.NaN, trace.mark('replayed') ?? Number.NaN).rate
  })
}

/** From the view of a stage, hydrated long since, to its first drawn frame. */
export async function timeFirstDrop(browser: Browser, stage: StageName, throttle: number) {
  const conditions = { stage, chips: 60, stagger: 150, throttle, above: 3000 }
  return visit(browser, conditions, {}, async (page, _, start) => {
    await start()
    await page.waitForLoadState('networkidle')
    await wait(0.5)
    await browser.startTracing(page, { categories })
    await page.evaluate(() => scrollTo(0, 3000))
    await marked(page, 'drawn')
    const trace = new Trace(await browser.stopTracing())
    return trace.work(trace.mark('seen') ?? Number.NaN, trace.mark('drawn') ?? Number.NaN)
  })
}

/** Script of a drop of 60 chips from view to rest, with the plan of how they will lie or without it. */
export async function timePlan(browser: Browser, stage: StageName, throttle: number, upright: boolean) {
  const conditions = { stage, chips: 60, stagger: 150, throttle, above: 3000 }
  return visit(browser, conditions, { upright }, async (page, _, start) => {
    await start()
    await page.waitForLoadState('networkidle')
    await wait(0.5)
    await browser.startTracing(page, { categories })
    await page.evaluate(() => scrollTo(0, 3000))
    await dropped(page, conditions)
    const trace = new Trace(await browser.stopTracing())
    return trace.script(trace.mark('seen') ?? Number.NaN, trace.mark('rest') ?? Number.NaN)
  })
}

/** Script a frame of a page with an empty frame loop. */
export async function timeIdle(browser: Browser, throttle: number) {
  const page = await browser.newPage()
  try {
    await page.goto(`${server.url}/idle`)
    const session = await page.context().newCDPSession(page)
    await session.send('Emulation.setCPUThrottlingRate', { rate: throttle })
    await browser.startTracing(page, { categories })
    await wait(idleSeconds)
    return new Trace(await browser.stopTracing()).frames(0, Number.POSITIVE_INFINITY).script
  } finally {
    await browser.stopTracing().catch(() => {})
    await page.close()
  }
}

async function counter(session: CDPSession, name: string) {
  const { metrics } = await session.send('Performance.getMetrics')
  return metrics.find((metric) => metric.name === name)?.value ?? Number.NaN
}

/** Layouts, shifts, layers, writes: from the server's markup until a second after the drop. */
export async function count(browser: Browser, stage: StageName) {
  const conditions = { stage, chips: 60, stagger: 20 }
  return visit(browser, conditions, { counting: true }, async (page, session, start) => {
    await session.send('Performance.enable')
    await session.send('DOM.enable')
    const { root: document } = await session.send('DOM.getDocument')
    const chips = await session.send('DOM.querySelectorAll', {
      nodeId: document.nodeId,
      selector: '[data-slot=gravity-stack-chip]',
    })
    const nodes = new Set<number | undefined>()
    for (const nodeId of chips.nodeIds) {
      const { node } = await session.send('DOM.describeNode', { nodeId })
      nodes.add(node.backendNodeId)
    }
    let layers = 0
    let most = 0
    session.on('LayerTree.layerTreeDidChange', (event) => {
      layers = (event.layers ?? []).filter(({ backendNodeId }) => nodes.has(backendNodeId)).length
      most = Math.max(most, layers)
    })
    await session.send('LayerTree.enable')
    const before = await counter(session, 'LayoutCount')
    await start()
    await marked(page, 'drawn')
    const mountLayouts = (await counter(session, 'LayoutCount')) - before
    await dropped(page, conditions)
    const now = () => page.evaluate(() => ({ ...window.observed }))
    const end = await now()
    await wait(0.3)
    const still = await now()
    await wait(1)
    const after = await now()
    return {
      mountLayouts,
      shift: after.shift,
      layers: { most, after: layers },
      writes: {
        perFrame: end.writes / Math.max(1, end.frames),
        after: after.writes - still.writes,
        framesAfter: after.frames - still.frames,
      },
    }
  })
}

/** ms, the slowest of twelve clicks and keys while the pile settles. */
export async function interact(browser: Browser, stage: StageName, throttle: number) {
  const conditions = { stage, chips: 60, stagger: 20, throttle }
  return visit(browser, conditions, {}, async (page, _, start) => {
    await start()
    await marked(page, 'drawn')
    for (let i = 0; i < 12; i++) {
      await wait(0.15)
      if (i % 3 === 2) await page.keyboard.press('a')
      else await page.mouse.click(40 + ((i * 0.618) % 1) * 560, 200 + (i % 4) * 35)
    }
    await wait(0.5)
    const { interactions } = await page.evaluate(() => window.observed)
    return Math.max(16, ...Object.values(interactions))
  })
}

export async function weighHeap(stage: StageName) {
  const browser = await launch()
  const conditions = { stage, chips: 60, stagger: 20 }
  try {
    return await visit(browser, conditions, { restless: true }, async (page, session, start) => {
      await start()
      await marked(page, 'drawn')
      // All are released. For half a minute compiled code grows; the heap keeps it, but it is not the
      // stage's.
      await wait(heapSeconds)
      await session.send('HeapProfiler.enable')
      const frames = () => page.evaluate(() => window.observed.frames)
      const used = async () => (await session.send('Runtime.getHeapUsage')).usedSize
      await page.evaluate(() => window.observed.countFrames())
      const before = await frames()
      await session.send('HeapProfiler.collectGarbage')
      const least = await used()
      await session.send('HeapProfiler.startSampling', {
        samplingInterval: 1024,
        includeObjectsCollectedByMajorGC: true,
        includeObjectsCollectedByMinorGC: true,
      })
      const samples: number[] = []
      for (let second = 0; second < heapSeconds; second++) {
        await wait(1)
        samples.push(await used())
      }
      const { profile } = await session.send('HeapProfiler.stopSampling')
      const passed = (await frames()) - before
      await session.send('HeapProfiler.collectGarbage')
      type Node = (typeof profile)['head']
      const bytes = (node: Node): number =>
        node.selfSize + node.children.reduce((sum, child) => sum + bytes(child), 0)
      return { perFrame: bytes(profile.head) / passed, growth: (await used()) - least, samples }
    })
  } finally {
    await browser.close()
  }
}

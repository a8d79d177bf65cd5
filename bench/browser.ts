// What the stage costs in a real browser, beside two others of the same chips: one of the method of the component's first
// design, one with matter-js. Chromium's trace and counters, with the processor as it is and slowed down four times.
//   npm run bench:browser                            writes bench/results/browser.json; about ten minutes
//   npm run bench:browser -- --stage gravity-stack   one stage, written nowhere
//   npm run bench:browser -- --out folder            writes there
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { parseArgs } from 'node:util'
import { type Browser, type BrowserContext, type CDPSession, chromium, type Page } from '@playwright/test'
import { pourStage } from '../scenes/piles'
import { bringBrowser } from '../scripts/browser.mjs'
import type {} from './browser/observe'
import type {} from './browser/replay'
import type { BrowserResults, Drop, StageName, StageResult } from './browser/results'
import { serve, stageNames } from './browser/serve'
import { categories, Trace } from './browser/trace'
import { median } from './film'
import { commit, machine } from './machine'
import { root } from './run-job'

const { values: options } = parseArgs({ options: { stage: { type: 'string' }, out: { type: 'string' } } })

/** Each drop that is timed: chips, ms between releases, times slowed down. */
const drops = [
  [60, 150, 4],
  [60, 150, 1],
  [250, 10, 1],
  [1000, 5, 1],
] as const
const crowd = drops[3]
/** Times that each of them, and the interactions, are played: of one the worst frame is the machine's as often as the stage's. */
const plays = 3
/** s that a stage which never rests is watched after its last release. */
const watched = 2
/** s of the heap's samples, and of an empty frame loop. */
const heapSeconds = 30
const idleSeconds = 5
/** Pages whose first drop is timed: the code is cold, so that a single one says little. */
const firstDrops = 5
const slow = 4
/** The one stage that comes to rest. */
const restful: StageName = 'gravity-stack'

await bringBrowser()
const server = await serve()
const launch = () => chromium.launch({ executablePath: process.env.CHROME_PATH })

type Visit = { stage: StageName; chips: number; stagger: number; throttle?: number; above?: number }

const log = (text: string) => console.log(`${(performance.now() / 1000).toFixed(0).padStart(4)} s  ${text}`)
const wait = (seconds: number) => new Promise((resolve) => setTimeout(resolve, 1000 * seconds))

/** A fresh page as the server sends it, its script not yet loaded. */
async function visit<T>(
  browser: Browser,
  { stage, chips, stagger, throttle = 1, above = 0 }: Visit,
  extra: { counting?: boolean; recording?: boolean; restless?: boolean },
  work: (page: Page, session: CDPSession, start: () => Promise<unknown>) => Promise<T>,
): Promise<T> {
  let context: BrowserContext | undefined
  try {
    context = await browser.newContext({ viewport: { width: 2700, height: 1500 } })
    const page = await context.newPage()
    const marks = new Set<string>()
    told.set(page, marks)
    page.on('console', (message) => marks.add(message.text()))
    const failed = new Promise<never>((_, reject) => page.on('pageerror', reject))
    failed.catch(() => {})
    const { width, height } = pourStage(chips)
    const { counting = false, recording = false, restless = false } = extra
    const query = { chips, stagger, width, height, above, counting, recording, restless }
    await page.goto(`${server.url}/${stage}?${new URLSearchParams(query as never)}`)
    const session = await context.newCDPSession(page)
    await session.send('Emulation.setCPUThrottlingRate', { rate: throttle })
    const start = () => page.addScriptTag({ type: 'module', url: `${server.url}/${stage}/client.js` })
    return await Promise.race([work(page, session, start), failed])
  } finally {
    // One that failed may have left it running, and no other could begin.
    await browser.stopTracing().catch(() => {})
    await context?.close()
  }
}

/** The marks that each page has told of. */
const told = new WeakMap<Page, Set<string>>()

/** Until the page has set this mark. It is asked nothing: an answer would cost the very frames that are measured. */
async function marked(page: Page, name: string, seconds = 60) {
  const end = performance.now() + 1000 * seconds
  while (!told.get(page)?.has(name)) {
    if (performance.now() > end) throw new Error(`${page.url()} has not told of ${name} for ${seconds} s`)
    await wait(0.05)
  }
}

/** Until the stage rests; one that never does is left when it would long have. */
async function dropped(page: Page, { stage, chips, stagger }: Visit) {
  await marked(page, 'drawn')
  if (stage === restful) await marked(page, 'rest')
  else await wait((chips * stagger) / 1000 + watched)
}

async function timeDrop(browser: Browser, stage: StageName, [chips, stagger, throttle]: readonly number[]) {
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
async function timeReplay(browser: Browser, stage: StageName, [chips, stagger, throttle]: readonly number[]) {
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
async function timeFirstDrop(browser: Browser, stage: StageName, throttle: number) {
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

/** Script a frame of a page with an empty frame loop. */
async function timeIdle(browser: Browser, throttle: number) {
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
async function count(browser: Browser, stage: StageName) {
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
async function interact(browser: Browser, stage: StageName, throttle: number) {
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

async function weighHeap(stage: StageName) {
  const browser = await launch()
  const conditions = { stage, chips: 60, stagger: 20 }
  try {
    return await visit(browser, conditions, { restless: true }, async (page, session, start) => {
      await start()
      await marked(page, 'drawn')
      // All released; and for half a minute what is compiled grows, which is kept but is nothing of the stage's.
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

/** Up to three times if it fails: a browser may stumble, and nobody may be here to see. */
async function attempt<T>(name: string, work: () => Promise<T>, left = 2): Promise<T> {
  log(name)
  try {
    return await work()
  } catch (error) {
    if (left === 0) throw error
    log(`${name}: once more, after ${error}`)
    return attempt(name, work, left - 1)
  }
}

/** The median of every number in results of one form. */
function middle<T>(all: T[]): T {
  const [first] = all
  if (typeof first === 'number') return median(all as number[]) as T
  return Object.fromEntries(
    Object.keys(first as object).map((key) => [key, middle(all.map((one) => one[key as keyof T]))]),
  ) as T
}

/** Each kind of measurement goes round the stages, so that none has the machine's better minute. */
async function measure(stages: StageName[]) {
  const results = Object.fromEntries(
    stages.map((stage) => [
      stage,
      {
        bytes: server.bytes(stage),
        drops: [] as Drop[],
        firstDrop: {},
        interaction: {},
      } as unknown as StageResult,
    ]),
  )
  const idle: BrowserResults['idle'] = {}
  const browser = await launch()
  const each = async (name: string, work: (stage: StageName) => Promise<unknown>) => {
    for (const stage of stages) await attempt(`${stage}: ${name}`, () => work(stage))
  }
  for (const drop of drops) {
    const [chips, , throttle] = drop
    const played = Object.fromEntries(stages.map((stage) => [stage, [] as Drop[]]))
    for (let n = 1; n <= plays; n++)
      await each(`${chips} chips, ${throttle}×, drop ${n}`, async (stage) => {
        played[stage].push(await timeDrop(browser, stage, drop))
      })
    // What script has forced once it has forced.
    for (const stage of stages) {
      const forced = Math.max(...played[stage].map((one) => one.forced))
      results[stage].drops.push({ ...middle(played[stage]), forced })
    }
  }
  // Only a stage that rests leaves the page to what is played again.
  if (stages.includes(restful)) {
    const rates: number[] = []
    for (let n = 1; n <= plays; n++)
      rates.push(
        await attempt(`${restful}: ${crowd[0]} chips without physics, ${n}`, () =>
          timeReplay(browser, restful, crowd),
        ),
      )
    results[restful].replay = median(rates)
  }
  for (const throttle of [1, slow]) {
    idle[throttle] = await attempt(`an empty frame loop, ${throttle}×`, () => timeIdle(browser, throttle))
    const first = Object.fromEntries(stages.map((stage) => [stage, [] as number[]]))
    for (let n = 1; n <= firstDrops; n++)
      await each(`first drop ${n}, ${throttle}×`, async (stage) => {
        first[stage].push(await timeFirstDrop(browser, stage, throttle))
      })
    for (const stage of stages) results[stage].firstDrop[throttle] = median(first[stage])
    const slowest = Object.fromEntries(stages.map((stage) => [stage, [] as number[]]))
    for (let n = 1; n <= plays; n++)
      await each(`interactions ${n}, ${throttle}×`, async (stage) => {
        slowest[stage].push(await interact(browser, stage, throttle))
      })
    for (const stage of stages) results[stage].interaction[throttle] = median(slowest[stage])
  }
  await each('counts', async (stage) => Object.assign(results[stage], await count(browser, stage)))
  const version = browser.version()
  await browser.close()
  // Bytes are bytes however busy the machine is: side by side.
  await Promise.all(
    stages.map(async (stage) => {
      results[stage].heap = await attempt(`${stage}: heap`, () => weighHeap(stage))
    }),
  )
  return { results, idle, version }
}

const stages = options.stage ? stageNames.filter((stage) => stage === options.stage) : stageNames
const { results, idle, version } = await measure(stages)
server.close()

const ms = (value: number) => value.toFixed(2).padStart(8)
for (const [throttle, { median: half, p99, worst }] of Object.entries(idle))
  console.log(`empty frame loop, ${throttle}×: script${ms(half)}${ms(p99)}${ms(worst)}`)
for (const stage of stages) {
  const { drops: all, heap, ...rest } = results[stage]
  console.log(`\n${stage}`)
  for (const { chips, throttle, rate, script, style, paint, raster, compositor, forced } of all) {
    console.log(
      `${String(chips).padStart(5)} chips ${throttle}×${rate.toFixed(0).padStart(4)} frames/s  script${ms(script.median)}${ms(script.p99)}${ms(script.worst)}  style${ms(style.median)}  paint${ms(paint.median)}  raster${ms(raster)}  compositor${ms(compositor)}  forced ${forced}`,
    )
  }
  console.log(JSON.stringify({ ...rest, heap: { ...heap, samples: heap.samples.length } }))
}

if (!options.stage) {
  const written: BrowserResults = {
    date: new Date().toISOString(),
    commit: commit(),
    machine: {
      ...machine,
      browser: `Chromium ${version}`,
    },
    versions: {
      'matter-js': JSON.parse(readFileSync(join(root, 'node_modules/matter-js/package.json'), 'utf8'))
        .version,
    },
    idle,
    stages: results as BrowserResults['stages'],
  }
  const folder = options.out ?? join(root, 'bench/results')
  mkdirSync(folder, { recursive: true })
  const file = join(folder, 'browser.json')
  writeFileSync(file, `${JSON.stringify(written, null, 1)}\n`)
  console.log(`\nwritten: ${file}`)
}
process.exit(0)

// What the stage costs in a real browser, beside two others of the same chips: one of the method of the
// component's first design, one with matter-js. Chromium's trace and counters, with the processor as it is
// and slowed down four times.
//   npm run bench:browser                            writes bench/results/browser.json; about ten minutes
//   npm run bench:browser -- --stage gravity-stack   one stage, written nowhere
//   npm run bench:browser -- --plan                  the cost of the plan alone, into the results; 3 min
//   npm run bench:browser -- --out folder            writes there
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { parseArgs } from 'node:util'
import type { Browser } from '@playwright/test'
import { median } from './accuracy/trajectory'
import {
  count,
  interact,
  timeDrop,
  timeFirstDrop,
  timeIdle,
  timePlan,
  timeReplay,
  weighHeap,
} from './browser/measures'
import type { BrowserResults, Drop, PlanCost, StageName, StageResult } from './browser/results'
import { stageNames } from './browser/serve'
import { launch, restful, server } from './browser/visit'
import { root } from './build/root'
import { commit, machine } from './publish/machine'

const { values: options } = parseArgs({
  options: { stage: { type: 'string' }, plan: { type: 'boolean' }, out: { type: 'string' } },
})

/** Each drop that is timed: chips, ms between releases, times slowed down. */
const drops = [
  [60, 150, 4],
  [60, 150, 1],
  [250, 10, 1],
  [1000, 5, 1],
] as const
const crowd = drops[3]
/**
 * How often each drop and each interaction is played. A single worst frame is often the machine's, not the
 * stage's.
 */
const plays = 3
/** Pages whose first drop is timed: the code is cold, so that a single one says little. */
const firstDrops = 5
const slow = 4

const log = (text: string) => console.log(`${(performance.now() / 1000).toFixed(0).padStart(4)} s  ${text}`)

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

/** With the plan and without it turn about, so that neither has the machine's better minute. */
async function measurePlan(browser: Browser): Promise<PlanCost> {
  const costs: PlanCost['costs'] = {}
  for (const throttle of [1, slow]) {
    const rounds: PlanCost['costs'][string][] = []
    for (let n = 1; n <= plays; n++) {
      const [planned, plain] = [
        await attempt(`a planned drop ${n}, ${throttle}×`, () => timePlan(browser, restful, throttle, true)),
        await attempt(`a plain drop ${n}, ${throttle}×`, () => timePlan(browser, restful, throttle, false)),
      ]
      rounds.push({ planned: planned.all, plain: plain.all, slice: planned.timer })
    }
    costs[throttle] = middle(rounds)
  }
  return { commit: commit(), costs }
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
    results[restful].plan = await measurePlan(browser)
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

const folder = options.out ?? join(root, 'bench/results')
const file = join(folder, 'browser.json')
const write = (all: BrowserResults) => {
  mkdirSync(folder, { recursive: true })
  writeFileSync(file, `${JSON.stringify(all, null, 1)}\n`)
  console.log(`\nwritten: ${file}`)
}

if (options.plan) {
  const browser = await launch()
  const plan = await measurePlan(browser)
  console.log(JSON.stringify(plan, null, 1))
  const all: BrowserResults = JSON.parse(readFileSync(file, 'utf8'))
  all.stages[restful].plan = plan
  write(all)
  process.exit(0)
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
  write(written)
}
process.exit(0)

import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import type { BrowserResults, Drop, FrameCost, StageName, StageResult } from '@/bench/browser/results'
import { figure } from '../figure'
import { looks } from './engines'

const file = join(process.cwd(), 'bench/results/browser.json')

/** What `npm run bench:browser` has measured last. */
export const browserResults: BrowserResults = JSON.parse(readFileSync(file, 'utf8'))

const ms = (value: number) => (value < 0.01 ? '0' : value < 10 ? value.toFixed(2) : value.toFixed(1))
/** Median, 99th percentile and worst, ms. */
export const three = ({ median, p99, worst }: FrameCost) => `${ms(median)} / ${ms(p99)} / ${ms(worst)}`
const kB = (bytes: number) => `${figure(bytes / 1000)} kB`

type Row = {
  name: string
  goal?: string
  met?: (result: StageResult) => boolean
  value: (result: StageResult) => string | number
}

export const dropOf = ({ drops }: StageResult, chips: number, throttle: number): Drop | undefined =>
  drops.find((drop) => drop.chips === chips && drop.throttle === throttle)

function scriptRow(chips: number, throttle: number, goal?: string, met?: (drop: Drop) => boolean): Row {
  const named = throttle > 1 ? `, processor slowed ${throttle} times` : ''
  return {
    name: `Script a frame, ${chips.toLocaleString('en')} chips${named}: median / 99th percentile / worst, ms`,
    goal,
    met: met && ((result) => met(dropOf(result, chips, throttle)!)),
    value: (result) => three(dropOf(result, chips, throttle)!.script),
  }
}

const most = 1000
const thousands = most.toLocaleString('en')

const rows: Row[] = [
  scriptRow(
    60,
    4,
    '0.6 / 2 / 8',
    ({ script }) => script.median <= 0.6 && script.p99 <= 2 && script.worst <= 8,
  ),
  scriptRow(60, 1),
  scriptRow(250, 1, '0.8 median', ({ script }) => script.median <= 0.8),
  scriptRow(most, 1),
  {
    name: `Frames a second, ${thousands} chips`,
    goal: '60',
    met: (result) => dropOf(result, most, 1)!.rate > 58,
    value: (result) => dropOf(result, most, 1)!.rate.toFixed(0),
  },
  {
    name: 'Frames a second of the same drop, recorded and played again without physics',
    value: ({ replay }) => replay?.toFixed(0) ?? '–',
  },
  {
    name: `The browser’s own part of a frame, ${thousands} chips: style and layout / paint / compositing, ms`,
    value: (result) => {
      const { style, paint, raster, compositor } = dropOf(result, most, 1)!
      return `${ms(style.median)} / ${ms(paint.median)} / ${ms(raster + compositor)}`
    },
  },
  {
    name: 'Script, style and layout from in view to the first frame, with the slices of the plan, 60 chips, ms; slowed 4 times',
    goal: '5',
    met: ({ firstDrop }) => firstDrop[1] <= 5,
    value: ({ firstDrop }) => `${ms(firstDrop[1])}; ${ms(firstDrop[4])}`,
  },
  {
    name: 'Processor time of the script of a whole drop of 60 chips, with / without the plan of how they will lie, ms; slowed 4 times',
    goal: '1.3 times',
    met: ({ plan }) => !plan || plan.costs[1].planned <= 1.3 * plan.costs[1].plain,
    value: ({ plan }) =>
      plan
        ? [1, 4].map((slow) => `${ms(plan.costs[slow].planned)} / ${ms(plan.costs[slow].plain)}`).join('; ')
        : '–',
  },
  {
    name: 'Longest slice of that plan, ms; slowed 4 times',
    value: ({ plan }) => (plan ? [1, 4].map((slow) => ms(plan.costs[slow].slice)).join('; ') : '–'),
  },
  {
    name: 'Layouts to bring 60 chips to life',
    goal: '1',
    met: ({ mountLayouts }) => mountLayouts <= 1,
    value: ({ mountLayouts }) => mountLayouts,
  },
  {
    name: 'Layouts and styles forced by script during all drops',
    goal: '0',
    met: ({ drops }) => drops.every(({ forced }) => forced === 0),
    value: ({ drops }) => drops.reduce((sum, { forced }) => sum + forced, 0),
  },
  {
    name: 'Style writes a frame, 60 chips falling',
    value: ({ writes }) => figure(writes.perFrame),
  },
  {
    name: 'Frames and style writes in the second after the drop',
    goal: '0; 0',
    met: ({ writes }) => writes.framesAfter + writes.after === 0,
    value: ({ writes }) => `${writes.framesAfter}; ${writes.after.toLocaleString('en')}`,
  },
  {
    name: 'Layers of 60 chips: most while they fall; afterwards',
    goal: '60; 0',
    met: ({ layers }) => layers.most <= 60 && layers.after === 0,
    value: ({ layers }) => `${layers.most}; ${layers.after}`,
  },
  {
    name: 'Slowest interaction while 60 chips settle, ms; slowed 4 times',
    goal: 'under 50',
    met: ({ interaction }) => interaction[1] < 50,
    value: ({ interaction }) =>
      [interaction[1], interaction[4]].map((value) => (value <= 16 ? 'at most 16' : value)).join('; '),
  },
  {
    name: 'Cumulative layout shift from the server’s markup to rest',
    goal: '0',
    met: ({ shift }) => shift === 0,
    value: ({ shift }) => figure(shift),
  },
  {
    name: 'Script of the stage and of the pills on the measured page, all but React and cn, minified and compressed, kB',
    goal: '12',
    met: ({ bytes }) => bytes <= 12_000,
    value: ({ bytes }) => (bytes / 1000).toFixed(1),
  },
  {
    name: 'Heap made and dropped a frame, 60 chips at work',
    value: ({ heap }) => kB(heap.perFrame),
  },
  {
    name: 'Growth of the heap in the second half of a minute of that',
    value: ({ heap }) => kB(Math.max(0, heap.growth)),
  },
]

const own: StageName = 'gravity-stack'
const names = Object.keys(browserResults.stages) as StageName[]

export const browserHead = [
  'Measure',
  'Goal',
  ...names.map((name) => [looks[name].title, browserResults.versions[name]].filter(Boolean).join(' ')),
]

/** The rows below that head; of our own figures, whether the goal is missed. */
export const browserRows = rows.map(({ name, goal = '', met, value }) => ({
  name,
  goal,
  figures: names.map((stage) => {
    const result = browserResults.stages[stage]
    return { stage, text: String(value(result)), missed: stage === own && met !== undefined && !met(result) }
  }),
}))

/** Two digits are enough for a sentence. */
const rough = (value: number) => Number(value.toPrecision(2))

export const chipCountsHead = ['Chips', 'What to expect']

/** How many chips a page may have, told by what the browser measured. */
export function chipCounts() {
  const stage = browserResults.stages[own]
  const script = (chips: number, throttle: number) => {
    const { median, worst } = dropOf(stage, chips, throttle)!.script
    return { usual: rough(median), worst: rough(worst) }
  }
  const [few, slowed, many] = [script(60, 1), script(60, 4), script(250, 1)]
  return [
    [
      'up to 60',
      `what the component is made for: ${few.usual} ms of script in a usual frame on the benchmark’s machine, ${few.worst} ms in the worst; with its processor slowed four times ${slowed.usual} and ${slowed.worst} ms`,
    ],
    [
      'up to 250',
      `${many.usual} ms of script in a usual frame there, ${many.worst} in the worst; try it on your slowest phone`,
    ],
    [
      thousands,
      `a stress test: ${dropOf(stage, most, 1)!.rate.toFixed(0)} frames a second there; ${stage.replay?.toFixed(0)} if the browser only draws the chips and nothing is simulated`,
    ],
    ['more', 'use a canvas'],
  ] as const
}

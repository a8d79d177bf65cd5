// How many words land the right way up, and what that costs: the bounds of D-004 beside what is measured.
//   npm run bench:upright                writes nothing; about thirteen minutes
//   npm run bench:upright -- --part demos,slow
import { parseArgs } from 'node:util'
import type { Page } from '@playwright/test'
import { median } from './accuracy/trajectory'
import type { Look } from './browser/chips'
import { categories, Trace } from './browser/trace'
import { dropped, launch, visit, wait } from './browser/visit'

const { values } = parseArgs({
  options: { part: { type: 'string', default: 'demos,looks,crowd,slow,script,frame' } },
})
const wanted = (part: string) => values.part.split(',').includes(part)
const widths = [375, 768, 1216]
const browser = await launch()

/** Words turned by more than 91°, all words, and the largest angle of a disc. Runs in the page. */
function read() {
  const result = { words: 0, over: 0, askew: 0 }
  for (const chip of document.querySelectorAll<HTMLElement>('[data-slot=gravity-stack-chip]')) {
    const { width, height, transform, borderTopLeftRadius: radius } = getComputedStyle(chip)
    const m = new DOMMatrix(transform)
    const angle = Math.atan2(m.b, m.a)
    if (width === height && Number.parseFloat(radius) >= Number.parseFloat(width) / 2)
      result.askew = Math.max(result.askew, (Math.abs(angle) * 180) / Math.PI)
    else {
      result.words++
      if (Math.cos(angle) < -0.02) result.over++
    }
  }
  return result
}

type Conditions = Parameters<typeof visit>[1] & { upright?: boolean }
const conditions = ({ upright, ...more }: Partial<Conditions>): Conditions => ({
  stage: 'gravity-stack',
  chips: 60,
  stagger: 150,
  ...more,
})

/** One drop on a fresh page, then what `look` makes of that. */
function drop<T>(
  more: Partial<Conditions>,
  look: (page: Page) => Promise<T>,
  before?: (page: Page) => Promise<unknown>,
) {
  const all = conditions(more)
  return visit(browser, all, { upright: more.upright ?? true }, async (page, _, start) => {
    await before?.(page)
    await start()
    await dropped(page, all)
    return look(page)
  })
}

async function count(name: string, bound: number, drops: Partial<Conditions>[]) {
  const sum = { words: 0, over: 0, askew: 0 }
  for (const one of drops) {
    const { words, over, askew } = await drop(one, (page) => page.evaluate(read))
    sum.words += words
    sum.over += over
    sum.askew = Math.max(sum.askew, askew)
  }
  const share = (100 * sum.over) / sum.words
  console.log(
    `${name.padEnd(44)} ${sum.over} of ${sum.words} upside down: ${share.toFixed(1)} % (≤ ${bound}); discs off by ${sum.askew.toFixed(2)}° (≤ 5)`,
  )
}

const each = <A, B>(as: readonly A[], make: (a: A) => B[]) => as.flatMap(make)

if (wanted('demos'))
  await count(
    'nine demos, three widths',
    2,
    each(widths, (width) =>
      Array.from({ length: 9 }, (_, chips) => ({ stage: 'demos' as const, chips, width })),
    ),
  )
if (wanted('looks'))
  for (const look of ['pills', 'badges', 'mixed'] as Look[])
    await count(
      `12, 30 and 60 ${look}, three widths`,
      2,
      each(widths, (width) => [12, 30, 60].map((chips) => ({ chips, look, width }))),
    )
if (wanted('crowd')) await count('250 pills', 4, [{ chips: 250, stagger: 20 }])
if (wanted('slow'))
  await count(
    'slowed four times, cold, 12 and 30 chips',
    2,
    each([640, 375, 768], (width) => [12, 30].map((chips) => ({ chips, throttle: 4, width }))),
  )

/** ms of script of a whole drop, from the first script on, and of its worst frame in the processor's time. */
async function cost(more: Partial<Conditions>) {
  return drop(
    more,
    async (page) => {
      await wait(0.2)
      void page
      const trace = new Trace(await browser.stopTracing())
      const scripts = new Set([
        'FireAnimationFrame',
        'FunctionCall',
        'TimerFire',
        'EventDispatch',
        'RunMicrotasks',
      ])
      const from = trace.mark('seen') ?? trace.mark('drawn') ?? 0
      const sum = trace.spans(scripts, from).reduce((all, span) => all + span.to - span.from, 0) / 1000
      const first = trace.mark('drawn') ?? 0
      // By the clock, another program that runs for a moment makes a frame the worst one.
      const { worst } = trace.frames(
        first,
        trace.mark('rest') ?? first + 1.2e7,
        (span) => span.processor,
      ).script
      return { sum, worst }
    },
    (page) => browser.startTracing(page, { categories }),
  )
}

async function compare(name: string, cases: Record<string, Partial<Conditions>>, plays: number) {
  const all = Object.fromEntries(
    Object.keys(cases).map((key) => [key, [] as { sum: number; worst: number }[]]),
  )
  // In turns, so that none has the machine's better minute.
  for (let n = 0; n < plays; n++)
    for (const [key, one] of Object.entries(cases)) all[key].push(await cost(one))
  const of = (key: string, what: 'sum' | 'worst') => median(all[key].map((one) => one[what]))
  for (const key of Object.keys(cases))
    console.log(
      `${name.padEnd(24)} ${key.padEnd(16)} script ${of(key, 'sum').toFixed(0)} ms, worst frame ${of(key, 'worst').toFixed(1)} ms`,
    )
  return of
}

if (wanted('script')) {
  const of = await compare('60 chips', { planned: {}, 'not planned': { upright: false } }, 3)
  const ratio = of('planned', 'sum') / of('not planned', 'sum')
  console.log(`script of the drop, planned to not planned: ${ratio.toFixed(2)} (≤ 1.3)`)
}
if (wanted('frame')) {
  const cases = {
    planned: { throttle: 4 },
    'not planned': { throttle: 4, upright: false },
    'first design': { stage: 'circle-chains' as const, throttle: 4 },
  }
  // One frame of hundreds: fewer drops give another figure each time.
  const of = await compare('60 chips, slowed 4 times', cases, 7)
  for (const other of ['not planned', 'first design'])
    console.log(
      `slowest frame, planned to ${other}: ${(of('planned', 'worst') / of(other, 'worst')).toFixed(2)} (≤ 1)`,
    )
}
await browser.close()
process.exit(0)

import { expect, it } from 'vitest'
import { Trace } from './trace'

type Event = {
  name: string
  ts: number
  dur?: number
  tdur?: number
  ph?: string
  cat?: string
  pid?: number
  tid?: number
}

/** As Chromium writes one down: the page is thread 1 of process 1. */
const traced = (events: Event[]) =>
  new Trace(
    Buffer.from(
      JSON.stringify({
        traceEvents: events.map((event) => ({ ph: 'X', cat: '', pid: 1, tid: 1, ...event })),
      }),
    ),
  )
const begin = (ts: number): Event => ({ name: 'AnimationFrame::Render', ph: 'b', ts })
const script = (ts: number, dur: number): Event => ({ name: 'FireAnimationFrame', ts, dur })

it('a frame costs the script that begins before the next one does', () => {
  const trace = traced([
    // Not in the order of their times, as threads write them down.
    begin(16_000),
    begin(0),
    script(100, 1000),
    { name: 'AnimationFrame::Render', ph: 'e', ts: 9000 },
    { name: 'TimerFire', ts: 14_000, dur: 2000 },
    script(16_000, 500),
    begin(32_000),
    script(32_100, 700),
  ])
  const { frames, seconds, rate, script: cost } = trace.frames(0, 48_000)
  expect({ frames, seconds, rate }).toEqual({ frames: 3, seconds: 0.048, rate: 62.5 })
  expect(cost).toEqual({ median: 0.7, p99: 3, worst: 3 })
})

it('what runs within something else is not counted twice', () => {
  const trace = traced([
    begin(0),
    { name: 'FunctionCall', ts: 200, dur: 300 },
    script(100, 1000),
    // Rounding lets one end a little after what it is in.
    { name: 'RunMicrotasks', ts: 1000, dur: 150 },
  ])
  expect(trace.frames(0, 16_000).script.worst).toBe(1.05)
  expect(trace.work(0, 16_000)).toBe(1.05)
})

it('script, style, paint and garbage are told apart', () => {
  const trace = traced([
    begin(0),
    script(0, 1000),
    { name: 'MinorGC', ts: 300, dur: 100 },
    { name: 'MajorGC', ts: 600, dur: 200 },
    { name: 'MinorGC', ph: 'E', ts: 900 },
    { name: 'UpdateLayoutTree', ts: 1000, dur: 40 },
    { name: 'Layout', ts: 1040, dur: 20 },
    { name: 'Paint', ts: 1060, dur: 500 },
    { name: 'Commit', ts: 1560, dur: 250 },
  ])
  const { script: cost, style, paint, forced, garbage } = trace.frames(0, 16_000)
  expect([cost.worst, style.worst, paint.worst, forced]).toEqual([1, 0.06, 0.75, 0])
  expect(garbage).toEqual({ longest: 0.2, count: 2 })
  expect(trace.work(0, 16_000)).toBe(1.06)
})

it('a style or layout within script is one that it has forced', () => {
  const trace = traced([
    begin(0),
    { name: 'Layout', ts: 5, dur: 5 },
    script(50, 1000),
    { name: 'UpdateLayoutTree', ts: 100, dur: 50 },
    { name: 'Layout', ts: 150, dur: 50 },
    { name: 'Layout', ts: 1200, dur: 50 },
  ])
  expect(trace.frames(0, 16_000).forced).toBe(2)
  expect(trace.forced(0, 16_000, new Set(['EventDispatch']))).toBe(0)
})

it("another page's script is nobody's here; raster and compositor are of all threads", () => {
  const trace = traced([
    begin(0),
    script(0, 1000),
    { name: 'FireAnimationFrame', ts: 0, dur: 9000, pid: 2 },
    { name: 'EventDispatch', ts: 2000, dur: 9000, tid: 2 },
    { name: 'RasterTask', ts: 10, dur: 3000, tid: 7 },
    { name: 'RasterTask', ts: 10, dur: 1000, tid: 8 },
    { name: 'Display::DrawAndSwap', ts: 10, dur: 2000, pid: 3 },
    begin(16_000),
  ])
  const { script: cost, raster, compositor } = trace.frames(0, 32_000)
  expect(cost.worst).toBe(1)
  expect([raster, compositor]).toEqual([2, 1])
})

it('what comes before or after counts for nothing', () => {
  const all = [
    begin(0),
    script(0, 1000),
    { name: 'RasterTask', ts: 10, dur: 3000 },
    begin(16_000),
    script(16_000, 2000),
    begin(32_000),
    script(32_000, 4000),
    { name: 'RasterTask', ts: 32_010, dur: 3000 },
  ]
  const { frames, script: cost, raster } = traced(all).frames(15_000, 31_000)
  expect({ frames, cost: cost.worst, raster }).toEqual({ frames: 1, cost: 2, raster: 0 })
  expect(traced(all).work(15_000, 31_000)).toBe(2)
})

it('a mark is what the page has set under that name', () => {
  const trace = traced([
    begin(0),
    script(0, 1),
    { name: 'rest', ts: 5, cat: 'devtools.timeline' },
    { name: 'rest', ts: 7, cat: 'blink.user_timing' },
  ])
  expect(trace.mark('rest')).toBe(7)
  expect(trace.mark('drawn')).toBeUndefined()
})

it('the slowest of a hundred and fifty frames is the worst, and no figure of the others', () => {
  const trace = traced(
    Array.from({ length: 150 }, (_, i) => [
      begin(16_000 * i),
      script(16_000 * i, i === 50 ? 9000 : 1000 + i),
    ]).flat(),
  )
  expect(trace.frames(0, 16_000 * 150).script).toEqual({ median: 1.0755, p99: 1.149, worst: 9 })
})

it('a page that drew nothing cost nothing', () => {
  const { frames, script: cost, raster, garbage } = traced([]).frames(0, 1e6)
  expect({ frames, cost, raster, garbage }).toEqual({
    frames: 0,
    cost: { median: 0, p99: 0, worst: 0 },
    raster: 0,
    garbage: { longest: 0, count: 0 },
  })
})

it.each([
  ['script', 'FireAnimationFrame FunctionCall EvaluateScript TimerFire EventDispatch RunMicrotasks'],
  ['style', 'UpdateLayoutTree Layout'],
  ['paint', 'PrePaint Paint Layerize Commit'],
] as const)('what counts as %s is %s', (kind, names) => {
  const all = names.split(' ')
  const trace = traced([
    begin(0),
    { name: 'FireAnimationFrame', ts: 0, dur: 0 },
    ...all.map((name, i) => ({ name, ts: 1000 * i, dur: 500 })),
  ])
  expect(trace.frames(0, 16_000)[kind].worst).toBe(0.5 * all.length)
})

it('of the processor’s time for script the longest timer is told apart, and what others took meanwhile is left out', () => {
  const trace = traced([
    begin(0),
    script(0, 1000),
    { name: 'TimerFire', ts: 2000, dur: 3000 },
    { name: 'FunctionCall', ts: 2100, dur: 2000 },
    { name: 'TimerFire', ts: 6000, dur: 5000, tdur: 4000 },
    { name: 'Paint', ts: 11_000, dur: 500 },
    { name: 'TimerFire', ts: 12_000, dur: 9000 },
  ])
  expect(trace.script(0, 11_500)).toEqual({ all: 8, timer: 4 })
})

it('a frame costs what the processor spent on it, where that is asked for', () => {
  const trace = traced([begin(0), { ...script(100, 1000), tdur: 400 }])
  expect(trace.frames(0, 16_000, (span) => span.processor).script.worst).toBe(0.4)
})

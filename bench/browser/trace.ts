// Reads a trace of Chromium: what the main thread of the page did, frame by frame.
import { median } from '../accuracy/trajectory'
import type { FrameCost } from './results'

type TraceEvent = {
  name: string
  cat: string
  ph: string
  pid: number
  tid: number
  /** µs */
  ts: number
  dur?: number
  /** µs of the processor: without what other programs took meanwhile. */
  tdur?: number
  args: Record<string, unknown>
}

/** What to ask a trace for. */
export const categories = [
  'devtools.timeline',
  'disabled-by-default-devtools.timeline',
  'blink.user_timing',
  'viz',
]

const scripts = new Set([
  'FireAnimationFrame',
  'FunctionCall',
  'EvaluateScript',
  'TimerFire',
  'EventDispatch',
  'RunMicrotasks',
])
const styles = new Set(['UpdateLayoutTree', 'Layout'])
const paints = new Set(['PrePaint', 'Paint', 'Layerize', 'Commit'])
const collections = new Set(['MinorGC', 'MajorGC'])

type Span = { from: number; to: number; processor: number }

/** Spans that lie within no other, in order. */
function outermost(events: TraceEvent[]): Span[] {
  const spans: Span[] = []
  for (const { ts, dur = 0, tdur = dur } of events.toSorted((a, b) => a.ts - b.ts)) {
    const last = spans.at(-1)
    if (last && ts < last.to) last.to = Math.max(last.to, ts + dur)
    else spans.push({ from: ts, to: ts + dur, processor: tdur })
  }
  return spans
}

const length = (spans: Span[]) => spans.reduce((sum, { from, to }) => sum + to - from, 0)

function costOf(values: number[]): FrameCost {
  const sorted = values.toSorted((a, b) => a - b)
  if (sorted.length === 0) return { median: 0, p99: 0, worst: 0 }
  const at = (share: number) => sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))]
  return { median: median(sorted), p99: at(0.99), worst: sorted[sorted.length - 1] }
}

export class Trace {
  readonly main: TraceEvent[]
  private readonly all: TraceEvent[]

  constructor(buffer: Buffer) {
    const { traceEvents } = JSON.parse(buffer.toString()) as { traceEvents: TraceEvent[] }
    this.all = traceEvents
    const one = traceEvents.find(({ name }) => name === 'FireAnimationFrame')
    this.main = traceEvents.filter(({ pid, tid, ph }) => one?.pid === pid && one.tid === tid && ph !== 'E')
  }

  /** Time of a mark that the page has set, µs. */
  mark(name: string) {
    return this.main.find((event) => event.name === name && event.cat.includes('user_timing'))?.ts
  }

  spans(names: Set<string>, from = 0, to = Number.POSITIVE_INFINITY) {
    return outermost(this.main.filter(({ name, ts }) => names.has(name) && ts >= from && ts <= to))
  }

  /** ms of script, style and layout between two times. */
  work(from: number, to: number) {
    return length(this.spans(new Set([...scripts, ...styles]), from, to)) / 1000
  }

  /** ms that the processor was at script between two times, and at the longest timer of it. */
  script(from: number, to: number) {
    const times = (names: Set<string>) => this.spans(names, from, to).map(({ processor }) => processor / 1000)
    return {
      all: times(scripts).reduce((sum, time) => sum + time, 0),
      timer: Math.max(0, ...times(new Set(['TimerFire']))),
    }
  }

  /** Layouts and recalculated styles that script has forced. */
  forced(from: number, to: number, names = scripts) {
    const running = this.spans(names, from, to)
    return this.main.filter(
      ({ name, ts }) => styles.has(name) && running.some((span) => ts > span.from && ts < span.to),
    ).length
  }

  /**
   * The cost of each frame of the main thread between two times. A frame lasts until the browser begins the
   * next. `time` says how many µs a span counts: those of the clock, or those of the processor.
   */
  frames(from: number, to: number, time = (span: Span) => span.to - span.from) {
    const within = ({ ts }: TraceEvent) => ts >= from && ts <= to
    const begins = this.main
      .filter((event) => event.name === 'AnimationFrame::Render' && event.ph === 'b' && within(event))
      .map(({ ts }) => ts)
      .toSorted((a, b) => a - b)
    const per = (names: Set<string>) => {
      const sums = begins.map(() => 0)
      let frame = 0
      for (const span of this.spans(names, from, to)) {
        while (frame + 1 < begins.length && begins[frame + 1] <= span.from) frame++
        sums[frame] += time(span) / 1000
      }
      return costOf(sums)
    }
    /** ms a frame of what all threads of all processes did under this name. */
    const everywhere = (name: string) =>
      this.all
        .filter((event) => event.name === name && within(event))
        .reduce((sum, { dur = 0 }) => sum + dur / 1000, 0) / Math.max(1, begins.length)
    const garbage = this.spans(collections, from, to)
    return {
      seconds: (to - from) / 1e6,
      frames: begins.length,
      rate: begins.length / ((to - from) / 1e6),
      script: per(scripts),
      style: per(styles),
      paint: per(paints),
      raster: everywhere('RasterTask'),
      compositor: everywhere('Display::DrawAndSwap'),
      forced: this.forced(from, to),
      garbage: {
        longest: Math.max(0, ...garbage.map((span) => (span.to - span.from) / 1000)),
        count: garbage.length,
      },
    }
  }
}

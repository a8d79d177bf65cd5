'use client'

import { type ReactNode, useEffect, useId, useLayoutEffect, useRef, useState } from 'react'
import { flushSync } from 'react-dom'
import { classes } from '@/lib/classes'
import { stillMotion } from '@/lib/still-motion'
import { type Palette, paletteOf } from './draw'

/**
 * A picture with time to scrub: `draw` paints frame `at` into a canvas of `width` × `height` px, as wide as
 * the column. It plays once when seen, unless the reader prefers reduced motion, and again from its start
 * when it gets another `run`.
 */
export function Figure({
  label,
  run,
  width,
  height,
  frames,
  draw,
  readout,
  readoutHeight = 'min-h-17 sm:min-h-11 md:min-h-5',
  children,
  speed = 1,
}: {
  label: string
  run?: string
  width: number
  height: number
  frames: number
  draw: (context: CanvasRenderingContext2D, at: number, palette: Palette) => void
  readout: (at: number) => ReactNode
  /** Class: as many lines as the readout ever takes, so that nothing moves when it comes or grows. */
  readoutHeight?: string
  children?: ReactNode
  speed?: number
}) {
  const id = useId()
  const canvas = useRef<HTMLCanvasElement>(null)
  const [at, setAt] = useState(0)
  const [playing, setPlaying] = useState(false)
  const [near, setNear] = useState(false)
  const last = frames - 1
  const shown = Math.min(at, last)
  const [runBefore, setRunBefore] = useState(run)
  const paint = useRef(() => {})

  if (run !== runBefore) {
    setRunBefore(run)
    setAt(0)
    setPlaying(!stillMotion())
  }

  useLayoutEffect(() => {
    paint.current = () => {
      const element = canvas.current!
      const scale = Math.min(element.clientWidth / width, element.clientHeight / height) * devicePixelRatio
      if (!near || scale === 0) return
      element.width = Math.round(width * scale)
      element.height = Math.round(height * scale)
      const context = element.getContext('2d')!
      context.scale(scale, scale)
      draw(context, shown, paletteOf(element))
    }
    paint.current()
  })

  useEffect(() => {
    const repaint = () => paint.current()
    const resize = new ResizeObserver(repaint)
    resize.observe(canvas.current!)
    const theme = new MutationObserver(repaint)
    theme.observe(document.documentElement, { attributeFilter: ['class'] })
    return () => {
      resize.disconnect()
      theme.disconnect()
    }
  }, [])

  // The solver runs for a figure when the reader comes near it, not while the page loads.
  useEffect(() => {
    const nearing = new IntersectionObserver(
      ([entry]) => {
        if (!entry.isIntersecting) return
        setNear(true)
        nearing.disconnect()
      },
      { rootMargin: '300px' },
    )
    nearing.observe(canvas.current!)
    return () => nearing.disconnect()
  }, [])

  // Paper can't be scrubbed: a figure nobody has played yet is printed as it stands towards its end.
  useEffect(() => {
    const print = () =>
      flushSync(() => {
        setNear(true)
        setAt((current) => current || Math.round(0.7 * last))
      })
    window.addEventListener('beforeprint', print)
    return () => window.removeEventListener('beforeprint', print)
  }, [last])

  useEffect(() => {
    const seen = new IntersectionObserver(
      ([entry]) => {
        if (!entry.isIntersecting) return
        if (!stillMotion()) setPlaying(true)
        seen.disconnect()
      },
      { threshold: 0.6 },
    )
    seen.observe(canvas.current!)
    return () => seen.disconnect()
  }, [])

  useEffect(() => {
    if (!playing) return
    let request = 0
    let before = performance.now()
    let due = 0
    const tick = (now: number) => {
      due += Math.min(0.1, (now - before) / 1000) * 60 * speed
      before = now
      const steps = Math.floor(due)
      due -= steps
      if (steps > 0) setAt((current) => Math.min(last, current + steps))
      request = requestAnimationFrame(tick)
    }
    request = requestAnimationFrame(tick)
    return () => cancelAnimationFrame(request)
  }, [playing, last, speed])

  useEffect(() => {
    if (at >= last) setPlaying(false)
  }, [at, last])

  return (
    // Its controls say the same on every figure; the group says of which they are.
    // biome-ignore lint/a11y/useSemanticElements: a fieldset would need a legend that is seen
    <div
      role="group"
      aria-labelledby={`${id}-picture`}
      data-slot="figure"
      className="overflow-hidden rounded-2xl border bg-panel"
    >
      <canvas
        ref={canvas}
        id={`${id}-picture`}
        role="img"
        aria-label={label}
        style={{ aspectRatio: `${width} / ${height}` }}
        // A scene higher than wide is drawn smaller, on the floor: its controls stay where they are.
        className="block max-h-[34rem] w-full border-b bg-stage object-contain object-bottom"
      />
      <div className="space-y-4 p-4 text-sm">
        <div data-print="hide" className="flex flex-wrap items-center gap-3">
          <button
            type="button"
            onClick={() => {
              if (shown === last) setAt(0)
              setPlaying(!playing)
            }}
            className="w-16 shrink-0 rounded-md bg-foreground px-3 py-1.5 font-medium text-background"
          >
            {playing ? 'Pause' : 'Play'}
          </button>
          <label htmlFor={`${id}-time`} className="sr-only">
            Time
          </label>
          <input
            id={`${id}-time`}
            type="range"
            min={0}
            max={last}
            value={shown}
            aria-valuetext={`${(shown / 60).toFixed(2)} seconds`}
            onChange={(event) => {
              setPlaying(false)
              setAt(Number(event.target.value))
            }}
            className="min-w-0 flex-1 accent-foreground"
          />
          <span className="w-14 shrink-0 text-right text-muted-foreground tabular-nums">
            {(shown / 60).toFixed(2)} s
          </span>
        </div>
        {children && <div className="flex flex-wrap items-end gap-x-6 gap-y-3">{children}</div>}
        <noscript>
          <p>This figure is computed in your browser and needs JavaScript, which is off.</p>
        </noscript>
        <div
          className={classes(
            'flex flex-wrap content-start gap-x-6 gap-y-1 text-muted-foreground tabular-nums',
            readoutHeight,
          )}
        >
          {near ? readout(shown) : <span>…</span>}
        </div>
      </div>
    </div>
  )
}

/** One figure of a readout: what it is, then how much. */
export function Value({ of, children }: { of: string; children: ReactNode }) {
  return (
    <span>
      {of} <strong className="font-medium text-foreground">{children}</strong>
    </span>
  )
}

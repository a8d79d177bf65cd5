'use client'

import {
  type PointerEvent,
  type ReactNode,
  useEffect,
  useId,
  useLayoutEffect,
  useMemo,
  useRef,
  useState,
} from 'react'
import { classes } from '@/lib/classes'
import {
  chipsOf,
  codeOf,
  defaults,
  fromQuery,
  looks,
  ranges,
  type Settings,
  shapes,
  toQuery,
} from '@/lib/playground'
import { stillMotion } from '@/lib/still-motion'
import { TOUCH_DRAG_START, TOUCH_HOLD } from '@/registry/gravity-stack/constants'
import { cornerRadius } from '@/scenes/exact-distance'
import { CopyButton } from './copy-button'
import { chipColours, drawChip, drawDot, drawLine, paletteOf } from './lab/draw'
import { inspect, meanMass } from './lab/inspect'
import { createPile, type Pile } from './lab/pile'
import { LiveCode } from './live-code'

const speeds = [
  { value: 1, label: '1×' },
  { value: 0.25, label: '1/4×' },
  { value: 0.05, label: '1/20×' },
]

/** px, how long the overlay draws the weight of a mean chip, and the longest force. */
const weightLength = 12
const longestForce = 80
const asleepColour = '#bab3ab'

/** ms without a change before the address is written: Safari refuses the hundredth time in half a minute. */
const addressDelay = 300

/** A pointer that is down on a chip: where it is, in px and s of the stage. It holds the chip once there is a grab. */
type Press = {
  down: { x: number; y: number }
  at: [x: number, y: number, seconds: number]
  hold: () => void
  timer?: ReturnType<typeof setTimeout>
  grab?: ReturnType<Pile['world']['grab']>
}

/** What the solver did in the last step, and how long it took. */
type Work = {
  released: number
  awake: number
  pairs: number
  contacts: number
  islands: number
  substeps: number
  micros: number
  resting: boolean
}
const idle: Work = {
  released: 0,
  awake: 0,
  pairs: 0,
  contacts: 0,
  islands: 0,
  substeps: 0,
  micros: 0,
  resting: false,
}

export function Playground() {
  const [settings, setSettings] = useState<Settings>()
  const [drop, setDrop] = useState(0)
  const [playing, setPlaying] = useState(true)
  const [speed, setSpeed] = useState(1)
  const [overlay, setOverlay] = useState(false)
  const [work, setWork] = useState(idle)
  const stage = useRef<HTMLDivElement>(null)
  const canvas = useRef<HTMLCanvasElement>(null)
  const pile = useRef<Pile>(null)
  const mean = useRef(0)
  const kick = useRef(() => {})
  const address = useRef<ReturnType<typeof setTimeout>>(undefined)
  const presses = useRef(new Map<number, Press>())

  // The address is known in the browser only; until then the stage is empty.
  useEffect(() => {
    // Unless someone was quicker: a change counts from the moment the page can hear it.
    setSettings((known) => known ?? fromQuery(location.search))
    if (stillMotion()) setPlaying(false)
    return () => clearTimeout(address.current)
  }, [])

  const change = (next: Partial<Settings>) => {
    const changed = { ...(settings ?? fromQuery(location.search)), ...next }
    setSettings(changed)
    clearTimeout(address.current)
    address.current = setTimeout(() => {
      const query = toQuery(changed)
      try {
        history.replaceState(history.state, '', query ? `?${query}` : location.pathname)
      } catch {
        // Too often for this browser: the next change brings the address up to date.
      }
    }, addressDelay)
  }

  const ready = settings !== undefined
  const now = settings ?? defaults
  const { words, count, shape, look, gravity, bounce, friction, stagger, seed } = now
  const chips = useMemo(
    () => (ready ? chipsOf({ words, count, shape, look }) : []),
    [ready, words, count, shape, look],
  )
  const code = codeOf(now)

  function paint() {
    const { world, ids, shapes: sizes } = pile.current!
    const elements = stage.current!.querySelectorAll<HTMLElement>('[data-chip]')
    const states = ids.map((id) => world.read(id))
    states.forEach(({ x, y, angle }, chip) => {
      const { width, height } = sizes[chip]
      elements[chip].style.transform =
        `translate(${x - width / 2}px, ${y - height / 2}px) rotate(${angle}rad)`
    })
    const element = canvas.current
    if (!element) return
    const scale = devicePixelRatio
    element.width = element.clientWidth * scale
    element.height = element.clientHeight * scale
    const context = element.getContext('2d')!
    context.scale(scale, scale)
    const palette = paletteOf(element)
    const { touches, islands } = inspect(world)
    states.forEach((state, chip) => {
      const island = islands.get(ids[chip]) ?? 0
      drawChip(context, sizes[chip], state, {
        fill: state.asleep ? asleepColour : chipColours[island % chipColours.length],
        stroke: palette.foreground,
        dash: state.asleep ? [3, 3] : [],
        label: elements[chip].textContent ?? '',
      })
    })
    const pixels = weightLength / (meanMass(world) * Math.max(world.scene.gravity, 1))
    for (const { x, y, forceX, forceY } of touches) {
      const scale = Math.min(pixels, longestForce / Math.hypot(forceX, forceY))
      drawLine(context, [x, y], [x + scale * forceX, y + scale * forceY], palette.alarm)
      drawDot(context, x, y, palette.alarm)
    }
  }

  function step() {
    const before = performance.now()
    pile.current!.step()
    // Browsers round their clocks to 100 µs, so one step says little: a mean that forgets slowly.
    mean.current += 0.05 * ((performance.now() - before) * 1000 - mean.current)
    const micros = mean.current
    const { world, ids, resting } = pile.current!
    setWork({ ...world.stats, released: ids.length, micros, resting })
  }

  // A new pile when its chips or their order change; `drop` counts the presses of the button.
  // biome-ignore lint/correctness/useExhaustiveDependencies: gravity, bounce and friction change in place, below
  useLayoutEffect(() => {
    if (!settings) return
    const element = stage.current!
    const elements = [...element.querySelectorAll<HTMLElement>('[data-chip]')]
    const measure = (chip: HTMLElement) => ({
      width: chip.offsetWidth,
      height: chip.offsetHeight,
      radius: Number.parseFloat(getComputedStyle(chip.firstElementChild!).borderTopLeftRadius),
    })
    const sizes = elements.map(measure)
    for (const chip of elements) chip.style.transform = 'translateY(-200%)'
    const { clientWidth: width, clientHeight: height } = element
    // The chips that they hold are gone, and will not hear of their end.
    presses.current.clear()
    pile.current = createPile({ width, height, gravity, bounce, friction, stagger, seed }, sizes)
    setWork(idle)
    kick.current()
    const resize = new ResizeObserver(() => {
      const { world, ids } = pile.current!
      world.resize(element.clientWidth, element.clientHeight)
      elements.forEach((chip, place) => {
        const size = measure(chip)
        const { width, height } = sizes[place]
        if (size.width === width && size.height === height) return
        // A font that came late makes other chips.
        sizes[place] = size
        if (place < ids.length) world.reshape(ids[place], { ...size, radius: cornerRadius(size) })
      })
      kick.current()
    })
    for (const box of [element, ...elements]) resize.observe(box)
    return () => resize.disconnect()
  }, [chips, stagger, seed, drop])

  useEffect(() => {
    pile.current?.world.configure({ gravity, bounce, friction })
    kick.current()
  }, [gravity, bounce, friction])

  // biome-ignore lint/correctness/useExhaustiveDependencies: runs what it finds in the refs
  useEffect(() => {
    let request = 0
    let before = 0
    let due = 0
    const tick = (time: number) => {
      request = 0
      due += before === 0 ? 1 : Math.min(3, ((time - before) / 1000) * 60 * speed)
      before = time
      for (; due >= 1; due--) step()
      paint()
      if (!pile.current!.resting) request = requestAnimationFrame(tick)
      else before = 0
    }
    kick.current = () => {
      if (playing && request === 0 && pile.current) {
        before = 0
        request = requestAnimationFrame(tick)
      } else if (!playing && pile.current) paint()
    }
    kick.current()
    return () => cancelAnimationFrame(request)
  }, [playing, speed, overlay])

  // biome-ignore lint/correctness/useExhaustiveDependencies: paints what it finds in the refs
  useEffect(() => {
    if (!overlay) return
    const theme = new MutationObserver(() => paint())
    theme.observe(document.documentElement, { attributeFilter: ['class'] })
    return () => theme.disconnect()
  }, [overlay])

  // A finger that holds a chip does not scroll. React's own listeners are passive, and can't prevent it.
  useEffect(() => {
    const element = stage.current!
    const scroll = (event: TouchEvent) => {
      const holds = [...presses.current.values()].some(({ grab }) => grab)
      if (holds && event.cancelable) event.preventDefault()
    }
    element.addEventListener('touchmove', scroll, { passive: false })
    return () => element.removeEventListener('touchmove', scroll)
  }, [])

  const point = (event: PointerEvent): [number, number, number] => {
    const box = stage.current!.getBoundingClientRect()
    return [event.clientX - box.left, event.clientY - box.top, event.timeStamp / 1000]
  }
  function down(event: PointerEvent<HTMLElement>, chip: number) {
    const id = pile.current?.ids[chip]
    if (!now.interactive || id === undefined || event.button !== 0) return
    event.currentTarget.setPointerCapture(event.pointerId)
    const { world } = pile.current!
    const [x, y, seconds] = point(event)
    const start = world.read(id)
    const press: Press = {
      down: { x, y },
      at: [x, y, seconds],
      hold() {
        clearTimeout(press.timer)
        // The chip may have moved on while a finger rested.
        const { x: chipX, y: chipY } = world.read(id)
        press.grab = world.grab(id, chipX + x - start.x, chipY + y - start.y)
        press.grab.moveTo(...press.at)
        kick.current()
      },
    }
    presses.current.set(event.pointerId, press)
    if (event.pointerType === 'touch') press.timer = setTimeout(press.hold, TOUCH_HOLD)
    else press.hold()
  }
  function move(event: PointerEvent) {
    const press = presses.current.get(event.pointerId)
    if (!press) return
    press.at = point(event)
    const [dx, dy] = [press.at[0] - press.down.x, press.at[1] - press.down.y]
    if (press.grab) press.grab.moveTo(...press.at)
    else if (Math.hypot(dx, dy) > TOUCH_DRAG_START) {
      // A finger that sets out up or down wants to scroll the page.
      if (Math.abs(dy) > Math.abs(dx)) letGo(event)
      else press.hold()
    }
  }
  function letGo(event: PointerEvent) {
    const press = presses.current.get(event.pointerId)
    clearTimeout(press?.timer)
    // Where the hand stands now: one that has stood still throws nothing.
    press?.grab?.moveTo(...point(event))
    press?.grab?.release()
    presses.current.delete(event.pointerId)
  }

  // Contacts outlast their work: on a stage at rest nothing is done about them.
  const done = work.resting ? idle : work
  const hint = 'absolute inset-0 grid place-items-center p-6 text-center text-muted-foreground text-sm'
  const button =
    'rounded-md border px-3 py-1.5 text-sm transition-colors hover:bg-muted aria-pressed:border-foreground aria-pressed:bg-foreground aria-pressed:text-background'

  return (
    <div className="mt-8 grid grid-cols-[minmax(0,1fr)] gap-6 lg:grid-cols-[minmax(0,1fr)_19rem] lg:grid-rows-[auto_1fr]">
      <div data-print="hide" className="min-w-0 self-start overflow-hidden rounded-2xl border bg-panel">
        <div className="flex flex-wrap items-center gap-2 border-b p-3 [@media(scripting:none)]:hidden">
          <button
            type="button"
            className={button}
            onClick={() => {
              setPlaying(true)
              setDrop(drop + 1)
            }}
          >
            Drop
          </button>
          <button type="button" className={button} onClick={() => setPlaying(!playing)}>
            {playing ? 'Pause' : 'Play'}
          </button>
          <button
            type="button"
            className={button}
            onClick={() => {
              setPlaying(false)
              step()
              paint()
            }}
          >
            Step
          </button>
          <fieldset className="flex flex-wrap items-center gap-2 sm:ml-auto">
            <legend className="sr-only">Speed</legend>
            {speeds.map(({ value, label }) => (
              <button
                key={value}
                type="button"
                className={button}
                aria-label={`Speed ${label}`}
                aria-pressed={speed === value}
                onClick={() => setSpeed(value)}
              >
                {label}
              </button>
            ))}
          </fieldset>
          <button
            type="button"
            className={button}
            aria-pressed={overlay}
            onClick={() => setOverlay(!overlay)}
          >
            Overlay
          </button>
        </div>
        <div
          ref={stage}
          data-slot="playground-stage"
          data-state={work.resting ? 'resting' : playing ? 'running' : 'paused'}
          className="relative isolate h-96 overflow-clip bg-stage contain-strict"
        >
          {chips.map(({ word, className }, chip) => (
            <div
              // biome-ignore lint/suspicious/noArrayIndexKey: words may repeat, and chips have no other name
              key={`${className} ${chip}`}
              data-chip
              onPointerDown={(event) => down(event, chip)}
              onPointerMove={move}
              onPointerUp={letGo}
              onPointerCancel={letGo}
              onLostPointerCapture={letGo}
              className={classes(
                'absolute top-0 left-0 flex w-max max-w-full select-none forced-colors:*:outline forced-colors:*:-outline-offset-1',
                now.interactive && 'cursor-grab touch-pan-y touch-pinch-zoom active:cursor-grabbing',
              )}
            >
              <span className={className}>{word}</span>
            </div>
          ))}
          {ready && !playing && work.released === 0 && (
            <p className={hint}>
              {stillMotion() ? 'Motion is off, as your system asks.' : 'Paused.'} Play drops the chips.
            </p>
          )}
          <noscript>
            <p className={hint}>The playground runs in your browser and needs JavaScript, which is off.</p>
          </noscript>
          {overlay && <canvas ref={canvas} className="pointer-events-none absolute inset-0 size-full" />}
        </div>
        <dl className="flex flex-wrap gap-x-4 gap-y-1 border-t px-4 py-3 text-muted-foreground text-sm tabular-nums [@media(scripting:none)]:hidden">
          {Object.entries({
            'awake chips': done.awake,
            pairs: done.pairs,
            contacts: done.contacts,
            islands: done.islands,
            'sub-steps, all islands': done.substeps,
            'µs a step': Math.round(done.micros).toLocaleString('en'),
          }).map(([name, value]) => (
            <div key={name} className="flex gap-2">
              <dt>{name}</dt>
              <dd className="min-w-10 font-medium text-foreground">{value}</dd>
            </div>
          ))}
        </dl>
        {overlay && (
          <p className="border-t px-4 py-3 text-muted-foreground text-sm">
            Chips that touch are one island and share a colour; grey with a dashed outline is asleep. Red dots
            are contact points; each line is the force there, {weightLength} px for the weight of an average
            chip.
          </p>
        )}
      </div>

      <form
        data-print="hide"
        aria-label="Settings"
        className="flex flex-col gap-5 self-start rounded-2xl border bg-panel p-5 text-sm lg:row-span-2 [@media(scripting:none)]:hidden"
      >
        <Field label="Words, with commas between">
          {(id) => (
            <textarea
              id={id}
              rows={3}
              maxLength={500}
              value={words}
              onChange={(event) => change({ words: event.target.value })}
              className="w-full resize-y rounded-md border border-input bg-background px-3 py-2"
            />
          )}
        </Field>
        <Choice label="Shape" value={shape} options={shapes} onChange={(value) => change({ shape: value })} />
        <Choice label="Look" value={look} options={looks} onChange={(value) => change({ look: value })} />
        <Range of="count" label="Chips" value={count} onChange={change} />
        <Range of="gravity" label="gravity" unit="px/s²" value={gravity} onChange={change} />
        <Range of="bounce" label="bounce" value={bounce} onChange={change} />
        <Range of="friction" label="friction" value={friction} onChange={change} />
        <Range of="stagger" label="stagger" unit="ms" value={stagger} onChange={change} />
        <Range of="seed" label="Seed (not in the code)" value={seed} onChange={change} />
        <label className="flex items-center gap-3">
          <input
            type="checkbox"
            checked={now.interactive}
            onChange={(event) => change({ interactive: event.target.checked })}
            className="size-4 accent-foreground"
          />
          <span className="font-mono text-[0.8125rem]">interactive</span>
        </label>
        <p className="-mt-3 text-muted-foreground">
          Here chips can only be dragged; in the component a tap makes one hop, too.
        </p>
        <button
          type="button"
          className={button}
          onClick={() => {
            change(defaults)
            setSpeed(1)
            setOverlay(false)
            setPlaying(!stillMotion())
            setDrop(drop + 1)
          }}
        >
          Reset
        </button>
      </form>

      <div className="code min-w-0 self-start overflow-hidden rounded-2xl border bg-panel lg:col-start-1">
        <div className="flex items-center justify-between border-b py-1 pr-1.5 pl-4">
          <span className="font-mono text-muted-foreground text-xs">pile.tsx</span>
          <CopyButton />
        </div>
        <LiveCode code={code} />
      </div>
    </div>
  )
}

function Field({ label, children }: { label: ReactNode; children: (id: string) => ReactNode }) {
  const id = useId()
  return (
    <div className="flex flex-col gap-1.5">
      <label htmlFor={id} className="flex flex-wrap justify-between gap-x-4">
        {label}
      </label>
      {children(id)}
    </div>
  )
}

function Range({
  of,
  label,
  unit,
  value,
  onChange,
}: {
  of: keyof typeof ranges
  label: string
  unit?: string
  value: number
  onChange: (next: Partial<Settings>) => void
}) {
  const [min, max, step] = ranges[of]
  const said = [value.toLocaleString('en'), unit].filter(Boolean).join('\u00a0')
  return (
    <Field
      label={
        <>
          {/* Props have their name as it is in the code. */}
          <span className={label === of ? 'font-mono text-[0.8125rem]' : undefined}>{label}</span>
          {/* A screen reader hears it as the slider's value. */}
          <span aria-hidden="true" className="text-muted-foreground tabular-nums">
            {said}
          </span>
        </>
      }
    >
      {(id) => (
        <input
          id={id}
          type="range"
          min={min}
          max={max}
          step={step}
          value={value}
          aria-valuetext={said}
          onChange={(event) => onChange({ [of]: Number(event.target.value) })}
          className="w-full accent-foreground"
        />
      )}
    </Field>
  )
}

function Choice<Value extends string>({
  label,
  value,
  options,
  onChange,
}: {
  label: string
  value: Value
  options: readonly Value[]
  onChange: (value: Value) => void
}) {
  return (
    <Field label={label}>
      {(id) => (
        <select
          id={id}
          value={value}
          onChange={(event) => onChange(event.target.value as Value)}
          className="w-full rounded-md border border-input bg-background px-3 py-2"
        >
          {options.map((option) => (
            <option key={option}>{option}</option>
          ))}
        </select>
      )}
    </Field>
  )
}

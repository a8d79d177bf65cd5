import { useEffect, useLayoutEffect, useRef, useState } from 'react'
import type { PileRecord } from '@/lib/pile-link'
import { type chipsOf, gravityOf, isClosed, type Settings } from '@/lib/playground'
import { cornerRadius } from '@/scenes/exact-distance'
import { createRecorder, createReplay, type Player, type Recorder } from '../lab/recorder'
import { createHands, type Hands } from './hands'
import { createHover, type Hover } from './hover'
import { drawOverlay } from './overlay'

/** What the solver did in the last step, and how long it took. */
export type Work = typeof idle
export const idle = {
  released: 0,
  awake: 0,
  pairs: 0,
  contacts: 0,
  substeps: 0,
  micros: 0,
  resting: false,
}

/** Whether a recorded pile came out as it was recorded, to the last bit. */
export type Outcome = 'same' | 'other' | undefined

/** Frames: a quarter of a second, as on the component's own stage. */
const headStart = 15

type Show = {
  chips: ReturnType<typeof chipsOf>
  settings: Settings
  /** Another number, another drop. */
  drop: number
  /** A recorded drop to be played instead of a new one. */
  replay: PileRecord | undefined
  version: string
  playing: boolean
  speed: number
  overlay: boolean
}

const chipsIn = (stage: HTMLElement) => [...stage.querySelectorAll<HTMLElement>('[data-chip]')]

/** Size and corner radius, px, of a chip or an obstacle; a chip's corners are those of what it wraps. */
const measure = (element: HTMLElement) => ({
  width: element.offsetWidth,
  height: element.offsetHeight,
  radius: Number.parseFloat(getComputedStyle(element.firstElementChild ?? element).borderTopLeftRadius),
})

/** The obstacle as the solver takes it, px of the stage; undefined where the stage has none. */
function measureObstacle(stage: HTMLElement, { obstacleX, obstacleY }: Settings) {
  const element = stage.querySelector<HTMLElement>('[data-static]')
  if (!element) return
  const shape = measure(element)
  return {
    ...shape,
    radius: cornerRadius(shape),
    x: (stage.clientWidth * obstacleX) / 100,
    y: (stage.clientHeight * obstacleY) / 100,
  }
}

/** A pile of the `data-chip` elements in `stage`, played frame by frame, and the pointers on it. */
export function usePile({ chips, settings, drop, replay, version, playing, speed, overlay }: Show) {
  const { bounce, friction, stagger, upright, seed, obstacle, obstacleX, obstacleY } = settings
  const gravity = gravityOf(settings)
  const ceiling = isClosed(settings)
  const [work, setWork] = useState(idle)
  const [outcome, setOutcome] = useState<Outcome>()
  const stage = useRef<HTMLDivElement>(null)
  const canvas = useRef<HTMLCanvasElement>(null)
  const player = useRef<Player>(null)
  const recorder = useRef<Recorder>(null)
  const hands = useRef<Hands>(null)
  const hover = useRef<Hover>(null)
  /** The settings of now, for what is called later. */
  const latest = useRef(settings)
  latest.current = settings
  const mean = useRef(0)
  /** Frames that a drop's beginning still waits for the look-ahead. */
  const waits = useRef(0)
  const kick = useRef(() => {})

  function paint() {
    const { world, ids, shapes, resting, turned } = player.current!.pile
    if (replay) {
      // A recorded stage keeps its size, and is shown smaller where there is less room.
      const { style, parentElement } = stage.current!
      const { width, height } = world.scene
      style.width = `${width}px`
      style.height = `${height}px`
      style.zoom = `${Math.min(1, parentElement!.clientWidth / width)}`
      const element = stage.current!.querySelector<HTMLElement>('[data-static]')
      if (element) {
        const body = player.current!.pile.obstacle
        element.style.visibility = body ? '' : 'hidden'
        for (const [name, value] of Object.entries(
          body ? { left: body.x, top: body.y, width: body.width, height: body.height } : {},
        ))
          element.style.setProperty(name, `${value}px`)
      }
    }
    const elements = chipsIn(stage.current!)
    ids.forEach((id, chip) => {
      const { x, y, ...body } = world.read(id)
      const angle = body.angle + turned(id).turn
      const { width, height } = shapes[chip]
      const { style } = elements[chip]
      style.transform = `translate(${x - width / 2}px, ${y - height / 2}px) rotate(${angle}rad)`
      // The light stays above a chip at rest, as on the component's own stage.
      style.setProperty('--light-x', resting ? `${Math.sin(angle)}` : '')
      style.setProperty('--light-y', resting ? `${Math.cos(angle)}` : '')
    })
    if (!canvas.current) return
    const words = elements.map((chip) => chip.textContent ?? '')
    drawOverlay(canvas.current, player.current!.pile, words)
  }

  /** Gives the look-ahead a few slices; whether it is far enough ahead. */
  const planned = () => [1, 2, 3].some(() => player.current!.pile.plan())

  function step() {
    const { pile } = player.current!
    if (upright) pile.plan()
    const before = performance.now()
    player.current!.step()
    // Browsers round their clocks to 100 µs, so one step says little: a mean that forgets slowly.
    mean.current += 0.05 * ((performance.now() - before) * 1000 - mean.current)
    const { world, ids, resting } = pile
    setWork({ ...world.stats, released: ids.length, micros: mean.current, resting })
    const { current } = player
    if (replay && current?.over) setOutcome(world.hash() === replay.hash ? 'same' : 'other')
  }

  // A new pile when its chips or their order change, or when it is dropped again.
  // biome-ignore lint/correctness/useExhaustiveDependencies: these props change in place, below
  useLayoutEffect(() => {
    if (chips.length === 0) return
    const element = stage.current!
    const elements = chipsIn(element)
    const sizes = elements.map(measure)
    for (const chip of elements) chip.style.transform = 'translateY(-200%)'
    Object.assign(element.style, { width: '', height: '', zoom: '' })
    waits.current = headStart
    setWork(idle)
    setOutcome(undefined)
    if (replay) {
      player.current = createReplay(replay)
      recorder.current = null
      hands.current = null
      hover.current = null
      kick.current()
      return
    }
    const { clientWidth: width, clientHeight: height } = element
    const options = { width, height, gravity, ceiling, bounce, friction, stagger, seed }
    const next = createRecorder(version, options, sizes)
    next.setObstacle(measureObstacle(element, settings))
    const pointers = createHands(element, next, () => kick.current())
    player.current = next
    recorder.current = next
    hands.current = pointers
    hover.current = createHover(element, next, () => kick.current())
    kick.current()
    const resize = new ResizeObserver(() => {
      next.resize(element.clientWidth, element.clientHeight)
      next.setObstacle(measureObstacle(element, latest.current))
      elements.forEach((chip, place) => {
        const size = measure(chip)
        const { width, height } = sizes[place]
        if (size.width === width && size.height === height) return
        // A font that came late makes other chips.
        sizes[place] = size
        next.reshape(place, size)
      })
      kick.current()
    })
    for (const box of [element, ...elements]) resize.observe(box)
    return () => {
      resize.disconnect()
      pointers.end()
    }
  }, [chips, stagger, upright, seed, drop, replay])

  useEffect(() => {
    recorder.current?.configure({ gravity: { x: gravity.x, y: gravity.y }, ceiling, bounce, friction })
    kick.current()
  }, [gravity.x, gravity.y, ceiling, bounce, friction])

  // biome-ignore lint/correctness/useExhaustiveDependencies: measures again when one of these has changed
  useLayoutEffect(() => {
    recorder.current?.setObstacle(measureObstacle(stage.current!, settings))
    kick.current()
  }, [obstacle, obstacleX, obstacleY])

  // biome-ignore lint/correctness/useExhaustiveDependencies: runs what it finds in the refs
  useEffect(() => {
    let request = 0
    let before = 0
    let due = 0
    const tick = (time: number) => {
      request = 0
      if (waits.current > 0 && upright && !planned()) {
        waits.current--
        request = requestAnimationFrame(tick)
        return
      }
      due += before === 0 ? 1 : Math.min(3, ((time - before) / 1000) * 60 * speed)
      before = time
      for (; due >= 1 && !player.current!.over; due--) step()
      paint()
      const { pile, over } = player.current!
      // A recorded pile may rest for a while before the next thing is done to it.
      if (replay ? !over : !pile.resting) request = requestAnimationFrame(tick)
      else before = 0
    }
    kick.current = () => {
      if (playing && request === 0 && player.current) {
        before = 0
        request = requestAnimationFrame(tick)
      } else if (!playing && player.current) paint()
    }
    kick.current()
    return () => cancelAnimationFrame(request)
  }, [playing, speed, overlay, replay])

  // biome-ignore lint/correctness/useExhaustiveDependencies: paints what it finds in the refs
  useEffect(() => {
    if (!overlay) return
    const theme = new MutationObserver(() => paint())
    theme.observe(document.documentElement, { attributeFilter: ['class'] })
    return () => theme.disconnect()
  }, [overlay])

  return {
    stage,
    canvas,
    hands,
    hover,
    work,
    outcome,
    /** What was done to the pile up to now; nothing where that is too much for an address. */
    record: () => recorder.current?.record() ?? replay,
    /** Plays one frame, also of a paused pile. */
    advance() {
      step()
      paint()
    },
  }
}

import { useEffect, useLayoutEffect, useRef, useState } from 'react'
import type { chipsOf, Settings } from '@/lib/playground'
import { cornerRadius } from '@/scenes/exact-distance'
import { createPile, type Pile } from '../lab/pile'
import { createHands, type Hands } from './hands'
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

/** Frames: a quarter of a second, as on the component's own stage. */
const headStart = 15

type Show = {
  chips: ReturnType<typeof chipsOf>
  settings: Settings
  /** Another number, another drop. */
  drop: number
  playing: boolean
  speed: number
  overlay: boolean
}

const chipsIn = (stage: HTMLElement) => [...stage.querySelectorAll<HTMLElement>('[data-chip]')]

const measure = (chip: HTMLElement) => ({
  width: chip.offsetWidth,
  height: chip.offsetHeight,
  radius: Number.parseFloat(getComputedStyle(chip.firstElementChild!).borderTopLeftRadius),
})

/** A pile of the `data-chip` elements in `stage`, played frame by frame, and the pointers on it. */
export function usePile({ chips, settings, drop, playing, speed, overlay }: Show) {
  const { gravity, bounce, friction, stagger, upright, seed } = settings
  const [work, setWork] = useState(idle)
  const stage = useRef<HTMLDivElement>(null)
  const canvas = useRef<HTMLCanvasElement>(null)
  const pile = useRef<Pile>(null)
  const hands = useRef<Hands>(null)
  const mean = useRef(0)
  /** Frames that a drop's beginning still waits for the look-ahead. */
  const waits = useRef(0)
  const kick = useRef(() => {})

  function paint() {
    const { world, ids, shapes, resting, turned } = pile.current!
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
    drawOverlay(canvas.current, pile.current!, words)
  }

  /** Gives the look-ahead a few slices; whether it is far enough ahead. */
  const planned = () => [1, 2, 3].some(() => pile.current!.plan())

  function step() {
    if (upright) pile.current!.plan()
    const before = performance.now()
    pile.current!.step()
    // Browsers round their clocks to 100 µs, so one step says little: a mean that forgets slowly.
    mean.current += 0.05 * ((performance.now() - before) * 1000 - mean.current)
    const { world, ids, resting } = pile.current!
    setWork({ ...world.stats, released: ids.length, micros: mean.current, resting })
  }

  // A new pile when its chips or their order change, or when it is dropped again.
  // biome-ignore lint/correctness/useExhaustiveDependencies: these props change in place, below
  useLayoutEffect(() => {
    if (chips.length === 0) return
    const element = stage.current!
    const elements = chipsIn(element)
    const sizes = elements.map(measure)
    for (const chip of elements) chip.style.transform = 'translateY(-200%)'
    const { clientWidth: width, clientHeight: height } = element
    const options = { width, height, gravity, bounce, friction, stagger, seed }
    const next = createPile(options, sizes)
    const { world, ids } = next
    const pointers = createHands(element, next, () => kick.current())
    pile.current = next
    waits.current = headStart
    hands.current = pointers
    setWork(idle)
    kick.current()
    const resize = new ResizeObserver(() => {
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
    return () => {
      resize.disconnect()
      pointers.end()
    }
  }, [chips, stagger, upright, seed, drop])

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
      if (waits.current > 0 && upright && !planned()) {
        waits.current--
        request = requestAnimationFrame(tick)
        return
      }
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

  return {
    stage,
    canvas,
    hands,
    work,
    /** Plays one frame, also of a paused pile. */
    advance() {
      step()
      paint()
    },
  }
}

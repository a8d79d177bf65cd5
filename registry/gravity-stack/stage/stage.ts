import { STEP } from '../solver/constants'
import { createWorld, type World } from '../solver/world'
import { type Chip, draw, halfHeight, look, round, tellAngle } from './chip'
import { createLoop } from './frame-loop'
import { kickOf } from './launch'
import { createLookAhead, LOOK_SLICE, uprightTurn } from './look-ahead'
import { createPointers, FIRST, hearing } from './pointers'
import { LIMITS, sane, warn, written } from './props'
import { reach } from './release'
import { addReleased, createReleaseQueue } from './release-queue'
import { observersOf, shownAtMost, type View, watched } from './visibility'

/** No physics while one of these holds: the chips stand in a row, by CSS alone. The markup's query also asks whether there is script. */
const STILL = 'print, (prefers-reduced-motion: reduce)'
/** Share of the stage in view that starts the drop; of one that is too large for that, share of what can be seen of it at once. */
const IN_VIEW = 0.25
const FILLS_VIEW = 0.5
/** ms until a stage that a transform has scaled to nothing is looked at again. */
const LOOK_AGAIN = 200
/** s, longest time that one frame simulates: after a longer gap the pile goes on where it was. */
const LONGEST_FRAME = 0.05
/** px², of what a corner moves before a moving chip is drawn again: 0.11 px, a tenth and what is lost to rounding. */
const VISIBLE = 0.0121
/** px, height of the hop of a tapped chip. */
const HOP = 36
/** px, how high a shake throws at most. */
const SHAKE = 230
/** s after the last release that a pile which lies there from the start is given to come to rest. */
const LONGEST_SETTLING = 20
/** s that the first release waits at most for how its chips will lie to be known. */
const HEAD_START = 0.25
/** What the component was given; whatever a caller wrote. */
export interface StageOptions {
  gravity?: number | undefined
  bounce?: number | undefined
  friction?: number | undefined
  stagger?: number | undefined
  interactive: boolean
  upright: boolean
  /** False: what is there at first lies there, and does not fall. */
  initial: boolean
  onSettle?: (() => void) | undefined
}

export interface Stage {
  /** Takes over new options at any time. */
  update(options: StageOptions): void
  drop(): void
  shake(): void
  /** To be called when `pausing` has changed. */
  sync(): void
  /** To be called once its element is on the page, and again after `detach`. */
  attach(): void
  /** Lets go of everything outside of it. Its pile it keeps: React ends the effects of what it only hides. */
  detach(): void
}

/** `pausing.current` is whether its owner has paused the stage, which may be asked for before there is one. */
export function createStage(root: HTMLElement, pausing: { current: boolean }): Stage {
  const page = root.ownerDocument
  // Observers are of the stage's own window: in one that the page has opened no other sees it.
  const view = page.defaultView as View
  const observers = observersOf(view)
  const still = view.matchMedia(STILL)
  const chips = new Map<Element, Chip>()
  const queue = createReleaseQueue()
  const lookAhead = createLookAhead<Chip>((chip) => {
    if (Number.isNaN(chip.radius)) look(chip, changes)
  })
  let bodies: Chip[] = []
  let options: StageOptions & { [name in keyof typeof LIMITS]: number }
  let world: World | undefined
  let width = 0
  let height = 0
  let state = 'static'
  /** Running or resting: people may touch it. */
  let live = false
  /** Whether the pile is still being made that lies there from the start. */
  let making = false
  /** Whether it is worth to know how chips will lie: before and during a drop. */
  let planning = false
  let started = false
  let inView = false
  /** Whether the stage was ever in view. */
  let seenOnce = false
  /** Whether sizes are watched: not where chips stand in their row. */
  let moving = false
  /** ms of the frame before, while frames run. */
  let last: number | undefined
  /** ms, when the clock was last right, while nothing moves and no frame counts the time. */
  let idleSince: number | undefined
  /** The next slice of the look-ahead. */
  let planned: ReturnType<typeof setTimeout> | undefined
  let timer: ReturnType<typeof setTimeout> | undefined
  let unseen: ReturnType<typeof setTimeout> | undefined
  /** The chip that got the focus before it lay. */
  let followed: Chip | undefined
  /** Whether what had left by the top was released anew since somebody last did something: in a full stage it would be for ever. */
  let fetched = false
  let front = 0
  let kicks = 0
  /** Ends all listeners. There from when the stage comes into view until it is detached. */
  let listening: AbortController | undefined
  const loop = createLoop(view, tick)
  const pointers = createPointers(root, {
    find(element) {
      const chip = chips.get(element!)
      return chip && chip.id >= 0 && live ? chip : undefined
    },
    take(chip, offX, offY) {
      const { x, y } = world!.read(chip.id)
      fetched = false
      toFront(chip)
      return world!.grab(chip.id, x + offX, y + offY)
    },
    show(chip, state) {
      mark(chip, state)
      draw(chip)
      sync()
    },
    tap(chip) {
      kick(chip, HOP)
      sync()
    },
  })

  // Shapes

  const sizes = new view.ResizeObserver((entries) => {
    for (const { target, contentRect } of entries) {
      const chip = chipAt(target)
      if (chip) shape(chip, contentRect.width, contentRect.height)
      else if (target === root) {
        const hidden = !(width * height)
        width = root.clientWidth
        height = root.clientHeight
        if (width * height > 0) {
          // A stage without a size counts as wholly in view, so that it tells nothing new when it is that with one.
          if (hidden && !started) lookAgain()
          if (world) world.resize(width, height)
          else begin()
          // What has lost its size meanwhile had none to lose.
          if (hidden)
            chips.forEach((chip) => {
              if (chip.width && !chip.element.offsetWidth) shape(chip, 0, 0)
            })
        }
      }
    }
    sync()
    if (world && pausing.current) {
      // No time passes, but nothing may stay behind a wall or in another chip.
      world.makeRoom()
      world.eachMoved(paint)
      // It had the focus before it had a size.
      bringIn(chipAt((root.getRootNode() as Document).activeElement))
    }
  })

  function lookAgain() {
    observers.view.unobserve(root)
    observers.view.observe(root)
  }

  /** Chips come, go and change their look without a word from React. */
  const changes = new MutationObserver((records) => {
    for (const { target } of records) reshape(target)
    collect()
    pointers.recapture()
    sync()
  })

  function collect() {
    // A chip that waits is clipped, which is out of view for Chromium: what loads lazily would wait for ever.
    for (const late of Array.from(root.querySelectorAll('[loading=lazy]')))
      late.setAttribute('loading', 'eager')
    for (const element of Array.from(root.children) as HTMLElement[]) {
      if (chips.has(element) || !element.hasAttribute('data-slot')) continue
      chips.set(element, {
        element,
        state: 'waiting',
        width: 0,
        radius: Number.NaN,
        id: -1,
        angle: 0,
        pinch: '',
      } as Chip)
      if (moving) sizes.observe(element)
      // It has come with the focus.
      if (element.matches(':focus-within')) focus({ target: element })
    }
    let waited = false
    chips.forEach((chip, element) => {
      if (element.parentNode === root) return
      sizes.unobserve(element)
      waited = withdraw(chip) || waited
      chips.delete(element)
    })
    if (waited) queue.reschedule()
  }

  function chipAt(target: EventTarget | null) {
    let node = target as Element | null
    while (node && !chips.has(node)) node = node.parentElement
    return chips.get(node!)
  }

  function reshape(target: EventTarget | null) {
    const chip = chipAt(target)
    if (chip?.width) shape(chip, chip.width, chip.height)
  }

  function shape(chip: Chip, chipWidth: number, chipHeight: number) {
    if (!(chipWidth * chipHeight)) {
      // Hidden with its stage, or while what it shows has the whole screen, it keeps its place in the pile.
      if (!(width * height) || chip.element.querySelector(':fullscreen')) return
      if (process.env.NODE_ENV !== 'production')
        warn(
          'a chip has no size, so it can’t fall. It will once it has one: give it content, or width and height.',
        )
      chip.width = 0
      if (withdraw(chip)) queue.reschedule()
      return
    }
    const known = chip.width === chipWidth && chip.height === chipHeight
    if (!chip.width) queue.add(chip)
    chip.width = chipWidth
    chip.height = chipHeight
    chip.reach = reach(chipWidth, chipHeight)
    // What still waits is looked at when its turn comes: at first that would be all of them in one frame.
    if (chip.id < 0) {
      chip.radius = Number.NaN
      queue.revision++
      return
    }
    const { radius } = chip
    look(chip, changes)
    if (known && chip.radius === radius) return
    takeTurn(chip)
    world!.reshape(chip.id, chip)
    draw(chip)
    round(chip)
  }

  /** Turns the body of a chip to where it is drawn: in another shape it would no longer look the same turned. */
  function takeTurn(chip: Chip) {
    if (chip.turn) world!.place(chip.id, { angle: world!.read(chip.id).angle + chip.turn })
    chip.turn = 0
  }

  // Releases

  function begin() {
    making = !world && !options.initial
    world = createWorld({ width, height, ...options })
    bodies = []
    queue.restart(options.upright && !making ? -HEAD_START : 0)
    idleSince = undefined
    // In the order of the children, however they came.
    for (const element of Array.from(root.children)) {
      const chip = chips.get(element)
      if (!chip) continue
      reset(chip)
      if (chip.width) queue.add(chip)
    }
  }

  /** Whether it waited for its release, so that those behind it are to move up. */
  function withdraw(chip: Chip) {
    const waited = queue.remove(chip)
    pointers.letGo(chip)
    world?.remove(chip.id)
    delete bodies[chip.id]
    reset(chip)
    return waited
  }

  function reset(chip: Chip) {
    chip.id = -1
    chip.turn = 0
    chip.turned = false
    mark(chip, 'waiting')
  }

  function release(chip: Chip) {
    const { radius } = chip
    look(chip, changes)
    // It has changed since it was looked at ahead of its turn.
    if (radius !== chip.radius) queue.revision++
    queue.latest = queue.clock
    chip.id = addReleased({ world: world!, chips: bodies }, chip, width, options.gravity)
    chip.x = Number.NaN
  }

  // The loop

  function advance(end: number) {
    while (queue.chips[0] && queue.chips[0].due <= end) {
      const chip = queue.chips.shift()!
      world!.step(chip.due - queue.clock)
      queue.clock = chip.due
      release(chip)
    }
    world!.step(end - queue.clock)
    queue.clock = end
  }

  /**
   * Counts the time in which nothing moved. The world has no part in it, as what moves by now has only just begun: so it is whole steps,
   * and every release falls where it does in its step.
   */
  function catchUp() {
    if (idleSince === undefined) return
    const now = performance.now()
    const passed = Math.min((now - idleSince) / 1000, (queue.chips[0]?.due ?? Infinity) - queue.clock)
    const steps = STEP * Math.max(0, Math.floor(passed / STEP))
    queue.clock += steps
    idleSince = Math.max(idleSince + 1000 * steps, now - 1000 * STEP)
  }

  function tick() {
    // The time of the frame itself: smoother than the moment its callbacks run.
    const time = Number(page.timeline.currentTime)
    advance(queue.clock + Math.min(Math.max(time - (last ?? time), 0) / 1000, LONGEST_FRAME))
    last = time
    world!.eachMoved(paint)
    plan()
    if (!world!.resting) return
    if (!options.gravity && !fetched) {
      fetched = true
      // What has left by the top would float there for good: it is released anew.
      bodies.forEach((chip) => {
        if (chip.y < -chip.reach) {
          withdraw(chip)
          queue.add(chip)
        }
      })
    }
    sync()
  }

  function paint(id: number, x: number, y: number, bodyAngle: number, asleep: boolean) {
    const chip = bodies[id]!
    if (!chip.turned) turnUnseen(chip, y, bodyAngle)
    const angle = bodyAngle + chip.turn
    const dx = x - chip.x
    const dy = y - chip.y
    const swung = (angle - chip.angle) * chip.reach
    // Once all that are released in this frame have been looked at: what is read after a write is styled twice.
    if (Number.isNaN(chip.x)) round(chip)
    // One corner at least has gone this far. A chip never drawn compares as not a number. A chip that has fallen asleep
    // is drawn where it lies: its last movement may have been too small to be drawn.
    if (asleep || !(dx * dx + dy * dy + swung * swung < VISIBLE)) {
      chip.x = x
      chip.y = y
      chip.angle = angle
      draw(chip)
    }
    if (chip.state !== 'held') mark(chip, asleep ? 'resting' : 'falling')
  }

  /** Turns a chip to what lies upright in the end: in the last frame in which it is sure to be above the stage, where nobody sees it turn. */
  function turnUnseen(chip: Chip, y: number, angle: number) {
    const fall = LONGEST_FRAME * (world!.read(chip.id).vy + (LONGEST_FRAME / 2) * options.gravity)
    if (y + chip.reach + fall < 0) return
    chip.turned = true
    // Before it is first drawn it is out of sight as well.
    if (y + halfHeight(chip, angle) > 0 && !Number.isNaN(chip.x)) return
    chip.turn = uprightTurn(chip, lookAhead.expectedAngle(chip) ?? 0)
  }

  function mark(chip: Chip, next: Chip['state']) {
    if (chip.state === next) return
    chip.state = next
    if (chip === followed && next === 'resting') {
      followed = undefined
      if (chip.element.matches(':focus-within')) chip.element.scrollIntoView({ block: 'nearest' })
    }
    chip.element.setAttribute('data-state', next)
    if (next !== 'waiting') return
    // It waits unseen, at the top of the stage, and comes back no nearer to the front than the rest, unless it has the focus.
    chip.element.style.transform = ''
    if (!chip.element.matches(':focus-within')) chip.element.style.zIndex = ''
  }

  /** Brings loop, timer and state in line with all there is to know. Every event ends here. */
  function sync() {
    if (!listening) return
    // Looked at here, as Chromium tells nothing of a change that somebody has read before its event: a tab that comes back.
    if (moving === still.matches) {
      moving = !moving
      sizes.disconnect()
      if (moving) {
        sizes.observe(root)
        chips.forEach(({ element }) => {
          sizes.observe(element)
        })
        // Who has the focus in the row waits for nobody.
        focus({ target: (root.getRootNode() as Document).activeElement })
      }
    }
    catchUp()
    const idle = world?.resting
    const next = still.matches
      ? 'static'
      : !started || !world || making
        ? 'waiting'
        : pausing.current
          ? 'paused'
          : idle && !queue.chips.length
            ? 'resting'
            : inView && !page.hidden && width * height
              ? 'running'
              : 'paused'
    const running = next === 'running'
    clearTimeout(timer)
    if (running && !idle) loop.start()
    else {
      loop.stop()
      last = undefined
      // Nothing moves before the next release: a timer is enough until then.
      if (running) timer = setTimeout(arrive, (queue.chips[0]!.due - queue.clock) * 1000)
    }
    live = running || next === 'resting'
    idleSince = live && idle ? (idleSince ?? performance.now()) : undefined
    if (!live) pointers.letGo()
    planning = !!world && (making || options.upright) && (running || next === 'waiting')
    plan()
    if (next === state) return
    const settled = state === 'running' && next === 'resting'
    // Not before: a stage that opens by and by is small at first. Its class keeps a chip a pixel narrower.
    if (process.env.NODE_ENV !== 'production' && next === 'resting')
      chips.forEach((chip) => {
        if (width * height && (chip.width > width - 2 || chip.height > height))
          warn(
            'a chip is as wide as its stage, or larger than it, so it may jam or be cut off. Make the chip smaller or the stage larger.',
          )
      })
    state = next
    fetched = false
    root.setAttribute('data-state', next)
    // Rules for chips go by this one: by its state they would all be styled anew each time that it changes.
    root.toggleAttribute('data-halted', !live && next !== 'waiting')
    if (next === 'resting') bodies.forEach(tellAngle)
    // After the frame: an error in it would end Motion's loop for the whole page.
    if (settled && options.onSettle) queueMicrotask(options.onSettle)
  }

  // The look-ahead

  /** Has the look-ahead go on outside of the frame, while there are chips that can still be turned. */
  function plan() {
    const left = making || queue.chips.length || bodies.some(({ turned }) => !turned)
    if (!planning || !left) lookAhead.end()
    else planned ??= setTimeout(lookOn)
  }

  /** Lets the drop pass slice by slice, as nobody sees it: the row stands until all lie still. */
  function make() {
    const end = performance.now() + LOOK_SLICE
    while (queue.chips[0] || (!world!.resting && queue.clock < queue.latest + LONGEST_SETTLING)) {
      if (performance.now() > end) return plan()
      advance(queue.clock + STEP)
    }
    for (const chip of bodies) {
      if (!chip) continue
      chip.turned = true
      if (options.upright) chip.turn = uprightTurn(chip, world!.read(chip.id).angle)
    }
    show()
    world!.eachMoved(paint)
    sync()
  }

  /** The row gives way to the pile. */
  function show() {
    making = false
    started = true
    root.removeAttribute('data-row')
  }

  function lookOn() {
    planned = undefined
    if (!planning) return
    if (making) return make()
    if (!lookAhead.advance({ world: world!, chips: bodies }, queue, width, options.gravity)) {
      // Where no frame brings the next slice.
      if (world!.resting) plan()
    } else if (queue.clock < 0 && queue.latest < 0) {
      // All is known that the first release has waited for.
      queue.clock = 0
      if (idleSince !== undefined) idleSince = performance.now()
      sync()
    }
  }

  function arrive() {
    idleSince = undefined
    advance(queue.chips[0]!.due)
    sync()
  }

  // Coming into view, and the focus

  /** The stage comes within a screen of the view for the first time. Until then it has done nothing. */
  function arm() {
    if (process.env.NODE_ENV !== 'production' && getComputedStyle(root).position === 'static')
      warn(
        'Tailwind has made no styles for it, so its words lie one over the other. Is Tailwind set up, and does it scan this file?',
      )
    changes.observe(root, { childList: true, subtree: true })
    listen()
    collect()
  }

  function seen(entry: IntersectionObserverEntry, near: boolean) {
    if (near) {
      if (!entry.isIntersecting) return
      observers.near.unobserve(root)
      observers.view.observe(root)
      arm()
      return sync()
    }
    const { isIntersecting, intersectionRatio, intersectionRect: shown, boundingClientRect: whole } = entry
    inView = isIntersecting
    seenOnce ||= inView
    const unsized = inView && !(whole.width * whole.height)
    if (process.env.NODE_ENV !== 'production' && unsized && !(root.clientWidth * root.clientHeight))
      warn(
        `a stage is ${root.clientWidth} px wide and ${root.clientHeight} px high, so nothing falls until it is larger. Give it a height such as h-80, and what is around it a width.`,
      )
    const area = shown.width * shown.height
    // Of a stage without a size the ratio is 1 as soon as it is anywhere in view.
    if (!started && area) started = intersectionRatio >= IN_VIEW || area > FILLS_VIEW * shownAtMost(entry)
    // Scaled to nothing it is as much in view as when it has grown, so nobody would tell: it is asked again.
    clearTimeout(unseen)
    if (unsized && root.offsetWidth * root.offsetHeight) unseen = setTimeout(lookAgain, LOOK_AGAIN)
    sync()
  }

  function listen() {
    listening?.abort()
    listening = new AbortController()
    const on = hearing(listening)
    on(still, 'change', sync)
    on(page, 'visibilitychange', sync)
    on(root, 'transitionend', ({ target }) => {
      reshape(target)
      sync()
    })
    on(root, 'focusin', focus)
    pointers.letGo()
    if (options.interactive) pointers.listen(on)
  }

  function focus({ target }: { target: EventTarget | null }) {
    const chip = chipAt(target)
    if (!chip) return
    toFront(chip)
    if (still.matches) return
    // It goes on falling. Where it can't be seen yet the stage comes into view, and when it lies, if that was not enough, the chip
    // itself. Not for a press, though a field shows its focus then as well. The focus that a dialog gives back scrolls nothing.
    const unseen = chip.state === 'waiting' || (target as Element).matches(':focus-visible:not(:active)')
    if (unseen && chip.state !== 'resting') {
      if (chip.state === 'waiting' || chip.y < 0) root.scrollIntoView({ block: 'nearest' })
      followed = chip
      // Whoever scrolls on meanwhile is not brought back.
      for (const type of ['wheel', 'touchmove', 'keydown'])
        hearing(listening!)(view, type, () => (followed = undefined), { ...FIRST, once: true })
    }
    if (chip.id < 0) {
      started = true
      catchUp()
      queue.reschedule()
    }
    if (unseen) bringIn(chip)
    sync()
  }

  function toFront(chip: Chip) {
    chip.element.style.zIndex = `${++front}`
  }

  /** In a paused stage no time passes, so a chip that waits or is in the air above it is put where it can be seen. */
  function bringIn(chip: Chip | undefined) {
    if (!chip || !world || !pausing.current) return
    if (chip.id < 0 ? !withdraw(chip) : chip.state === 'resting' || chip.y > 0) return
    if (chip.id < 0) release(chip)
    world.place(chip.id, { y: chip.reach })
    world.eachMoved(paint)
  }

  /** Sends a chip about `height` px up. */
  function kick(chip: Chip, height: number) {
    fetched = false
    world!.place(chip.id, kickOf(kicks++, height, options.gravity, chip.angle))
  }

  return {
    update(next) {
      const before = options
      options = { ...next } as typeof options
      for (const name of ['interactive', 'upright', 'initial'] as const)
        if (process.env.NODE_ENV !== 'production' && typeof next[name] !== 'boolean')
          warn(
            `${name} is ${written(next[name])}, which is neither true nor false, so it counts as ${!!next[name]}. Pass true or false.`,
          )
      if (typeof next.onSettle !== 'function') {
        // `ready && save` is how people leave it out.
        if (process.env.NODE_ENV !== 'production' && next.onSettle)
          warn(
            `onSettle is ${written(next.onSettle)}, which can’t be called, so nothing is. Pass a function, or leave it out.`,
          )
        options.onSettle = undefined
      }
      let changed = false
      for (const name of Object.keys(LIMITS) as (keyof typeof LIMITS)[]) {
        options[name] = sane(name, next[name])
        if (options[name] !== before?.[name] && name !== 'stagger') changed = true
      }
      queue.stagger = options.stagger
      if (listening && !options.interactive !== !before.interactive) listen()
      const paced = options.stagger !== before?.stagger
      if (!world || !(changed || paced)) return
      if (changed) world.configure(options)
      if (paced) queue.reschedule()
      sync()
    },
    drop() {
      if (!world || !seenOnce || still.matches) return
      pointers.letGo()
      show()
      pausing.current = false
      begin()
      sync()
    },
    shake() {
      if (still.matches || making) return
      bodies.forEach((chip) => {
        kick(chip, SHAKE)
      })
      sync()
    },
    sync,
    attach() {
      watched.set(root, seen)
      observers.near.observe(root)
    },
    detach() {
      inView = false
      sync()
      pointers.letGo()
      observers.near.unobserve(root)
      observers.view.unobserve(root)
      watched.delete(root)
      listening?.abort()
      listening = undefined
      clearTimeout(unseen)
      clearTimeout(planned)
      planned = undefined
      planning = false
      lookAhead.end()
      sizes.disconnect()
      moving = false
      changes.disconnect()
    },
  }
}

import { cancelFrame, frame } from 'motion'
import { BOUNCE, FRICTION, GRAVITY } from './constants'
import { releasePose, releaseTime, scatter } from './drop'
import { createWorld, type World } from './world'

// The only room with a DOM. Layout is read in observers and at a press, written in the frame loop as transforms.
// React renders the chips' wrappers and never touches their style or state again: those are the stage's.

/** No physics while one of these holds: the chips stand in a row, by CSS alone. The markup has the same query. */
const STILL = 'print, (prefers-reduced-motion: reduce)'
/** ms between releases. */
export const STAGGER = 150
/** Share of the stage in view that starts the drop; of a very tall stage, the share of the window that it fills. */
const IN_VIEW = 0.25
const FILLS_WINDOW = 0.5
/** s, longest time that one frame simulates: after a longer gap the pile goes on where it was. */
const LONGEST_FRAME = 0.05
/** px that a corner moves before a chip is drawn again. */
const VISIBLE = 0.1
/** Size of a held chip, as if pressed between two fingers. */
const HELD_SCALE = 0.97
/** px that a pointer moves before a press is a drag, and ms that a finger rests before it holds instead of scrolls. */
const DRAG_START = 4
const TOUCH_DRAG_START = 8
const TOUCH_HOLD = 180
/** px, height of the hop of a tapped chip, px/s² of the least gravity it is made for, and rad/s of twist at its edge. */
const HOP = 36
const HOP_GRAVITY = 100
const HOP_SPIN = 4
/** px/s, rad/s: the most that a shake gives. */
const SHAKE = 1100
const SHAKE_SPIN = 8
/** Elements that a press belongs to, and elements that a tap belongs to. */
const EDITABLE = 'input, textarea, select, [contenteditable]'
const CONTROL = `${EDITABLE}, a, button, label, summary, [tabindex]`

export interface StageOptions {
  gravity: number
  bounce: number
  friction: number
  stagger: number
  interactive: boolean
  onSettle?: (() => void) | undefined
}

export interface Stage {
  /** Takes over new options at any time. */
  update(options: StageOptions): void
  drop(): void
  shake(): void
  pause(): void
  resume(): void
  /** Lets go of everything and leaves the elements as they were rendered. */
  destroy(): void
}

interface Chip {
  element: HTMLElement
  state: 'waiting' | 'falling' | 'held' | 'resting'
  /** Border box and corner radius, px. Zero width: not measured, or nothing to see. */
  width: number
  height: number
  radius: number
  /** Number of its release, and its time on the stage's clock, s. */
  turn: number
  due: number
  /** In the world, or -1. */
  id: number
  /** Pose as drawn. */
  x: number
  y: number
  angle: number
}

/** A pointer that is down on a chip. It holds the chip once there is a grab. */
interface Press {
  chip: Chip
  grab?: ReturnType<World['grab']>
  /** Where it went down, and where it is on the stage. */
  clientX: number
  clientY: number
  x: number
  y: number
  seconds: number
  /** The point of the chip under the pointer, in the chip's own axes. */
  localX: number
  localY: number
  toStage: (event: PointerEvent) => [x: number, y: number]
  moved: boolean
  touch: boolean
  timer?: ReturnType<typeof setTimeout>
}

declare const process: { env: { NODE_ENV?: string } }

const warned = new Set<string>()

/** Tells a developer once what is wrong, why, and what to do; bundlers drop it from production. */
function warn(message: string) {
  if (warned.has(message)) return
  warned.add(message)
  console.warn(`GravityStack: ${message}`)
}

/** A number between `low` and `high`, whatever the caller wrote. */
function sane(name: string, value: unknown, fallback: number, low: number, high: number) {
  const result = Number.isFinite(value) ? Math.min(Math.max(value as number, low), high) : fallback
  if (process.env.NODE_ENV !== 'production' && result !== value)
    warn(`${name} is ${value}, which is no number from ${low} to ${high}. Going on with ${result}.`)
  return result
}

let watcher: IntersectionObserver | undefined
const watched = new WeakMap<Element, (entry: IntersectionObserverEntry) => void>()

/** Tells what is in view of `element`; all stages of a page share one observer. */
function watch(element: Element, seen: (entry: IntersectionObserverEntry) => void) {
  watched.set(element, seen)
  watcher ??= new IntersectionObserver(
    (entries) => {
      for (const entry of entries) watched.get(entry.target)?.(entry)
    },
    { threshold: [0, 0.1, IN_VIEW] },
  )
  watcher.observe(element)
}

/** From a pointer to the stage's own px, through whatever scales, turns or skews its ancestors: three points tell. */
function pointerMap(root: HTMLElement) {
  const probes = [0, 0, 1000, 0, 0, 1000].flatMap((left, i, all) => {
    if (i % 2) return []
    const probe = root.ownerDocument.createElement('i')
    probe.style.cssText = `position:absolute;left:${left}px;top:${all[i + 1]}px`
    return root.appendChild(probe)
  })
  type Three = [DOMRect, DOMRect, DOMRect]
  const [o, u, v] = probes.map((probe) => probe.getBoundingClientRect()) as Three
  const before = root.getBoundingClientRect()
  for (const probe of probes) probe.remove()
  const [ux, uy, vx, vy] = [u.x - o.x, u.y - o.y, v.x - o.x, v.y - o.y]
  const scale = 1000 / (ux * vy - uy * vx || 1)
  return (event: PointerEvent): [number, number] => {
    // Scrolled since: the whole stage has moved by as much as its bounding box.
    const now = root.getBoundingClientRect()
    const x = event.clientX - o.x - now.x + before.x
    const y = event.clientY - o.y - now.y + before.y
    return [(x * vy - y * vx) * scale, (y * ux - x * uy) * scale]
  }
}

export function createStage(root: HTMLElement): Stage {
  const page = root.ownerDocument
  const still = page.defaultView!.matchMedia(STILL)
  const chips = new Map<Node, Chip>()
  const presses = new Map<number, Press>()
  /** Chips whose release is to come, the next one first. */
  let queue: Chip[] = []
  let bodies: Chip[] = []
  let options: StageOptions
  let world: World | undefined
  let width = 0
  let height = 0
  let state = 'static'
  let armed = false
  let started = false
  let inView = false
  let stopped = false
  /** s simulated since the stage began, and ms of the frame before, while frames run. */
  let clock = 0
  let last: number | undefined
  let turns = 0
  let slot = 0
  /** The chip whose release a timer waits for. */
  let awaited: Chip | undefined
  let timer: ReturnType<typeof setTimeout> | undefined
  let front = 0
  let swallowClick = false
  const life = new AbortController()
  let input: AbortController | undefined
  let grip: AbortController | undefined

  // Shapes

  const sizes = new ResizeObserver((entries) => {
    for (const { target, contentRect } of entries) {
      const chip = chips.get(target)
      if (chip) shape(chip, contentRect.width, contentRect.height)
      else if (target === root) {
        const style = getComputedStyle(root)
        width =
          contentRect.width + Number.parseFloat(style.paddingLeft) + Number.parseFloat(style.paddingRight)
        height =
          contentRect.height + Number.parseFloat(style.paddingTop) + Number.parseFloat(style.paddingBottom)
        if (width * height > 0) {
          if (world) world.resize(width, height)
          else begin()
        }
      }
    }
    sync()
  })

  /** Chips come, go and change their look without a word from React. */
  const changes = new MutationObserver((records) => {
    for (const { target } of records) reshape(target)
    collect()
    sync()
  })

  function collect() {
    for (const element of Array.from(root.children)) {
      if (chips.has(element) || !element.hasAttribute('data-slot')) continue
      const chip = { element, state: 'waiting', width: 0, id: -1 } as unknown as Chip
      chips.set(element, chip)
      if (!still.matches) sizes.observe(element)
      if (input) listen(chip, input.signal)
    }
    for (const [element, chip] of chips) {
      if (element.parentNode === root) continue
      sizes.unobserve(chip.element)
      withdraw(chip)
      chips.delete(element)
    }
  }

  function chipAt(node: Node | null) {
    while (node && !chips.has(node)) node = node.parentNode
    return chips.get(node as Node)
  }

  function reshape(node: EventTarget | null) {
    const chip = chipAt(node as Node)
    if (chip?.width) shape(chip, chip.width, chip.height)
  }

  function shape(chip: Chip, chipWidth: number, chipHeight: number) {
    if (!(chipWidth * chipHeight)) {
      if (process.env.NODE_ENV !== 'production')
        warn(
          'a chip has no size, so it can’t fall. It will once it has one: give it content, or width and height.',
        )
      chip.width = 0
      return withdraw(chip)
    }
    if (process.env.NODE_ENV !== 'production' && (chipWidth > width || chipHeight > height) && width * height)
      warn(
        'a chip is larger than its stage and can’t be seen whole. Make the chip smaller or the stage larger.',
      )
    // The least of the four corners, so that nothing drawn reaches out of its body. A share means one of the shorter side.
    const corners = getComputedStyle(chip.element.firstElementChild ?? chip.element).borderRadius.split(
      /[ /]+/,
    )
    const short = Math.min(chipWidth, chipHeight)
    const radius = Math.min(
      ...corners.map((corner) => (Number.parseFloat(corner) || 0) * (corner.endsWith('%') ? short / 100 : 1)),
      short / 2,
    )
    if (chip.width === chipWidth && chip.height === chipHeight && chip.radius === radius) return
    chip.width = chipWidth
    chip.height = chipHeight
    chip.radius = radius
    if (chip.id >= 0) {
      world!.reshape(chip.id, { width: chipWidth, height: chipHeight, radius })
      draw(chip)
    } else if (!queue.includes(chip)) enqueue(chip)
  }

  // Releases

  function begin() {
    world = createWorld({ width, height, ...options })
    bodies = []
    queue = []
    clock = turns = slot = 0
    for (const chip of chips.values()) {
      chip.id = -1
      mark(chip, 'waiting')
      if (chip.width) enqueue(chip)
    }
  }

  function enqueue(chip: Chip) {
    chip.turn = turns++
    slot = Math.max(slot, clock)
    chip.due = releaseTime(chip.turn, slot)
    slot += options.stagger / 1000
    queue.push(chip)
    queue.sort((a, b) => a.due - b.due)
  }

  function withdraw(chip: Chip) {
    queue = queue.filter((other) => other !== chip)
    for (const [pointer, press] of presses) if (press.chip === chip) letGo(pointer)
    if (chip.id >= 0) world!.remove(chip.id)
    chip.id = -1
    mark(chip, 'waiting')
  }

  function release(chip: Chip) {
    const obstacles = []
    for (const other of chips.values()) {
      if (other.id < 0) continue
      const { x, y } = world!.read(other.id)
      obstacles.push({ x, y, reach: Math.hypot(other.width, other.height) / 2 })
    }
    const pose = releasePose(chip.turn, chip.width, chip.height, width, options.gravity, obstacles)
    const { radius } = chip
    chip.id = world!.add({ width: chip.width, height: chip.height, radius, ...pose })
    chip.x = chip.y = chip.angle = Number.NaN
    bodies[chip.id] = chip
  }

  // The loop

  function advance(seconds: number) {
    const end = clock + seconds
    while (queue[0] && queue[0].due <= end) {
      const chip = queue.shift()!
      world!.step(Math.max(chip.due - clock, 0))
      clock = Math.max(chip.due, clock)
      release(chip)
    }
    world!.step(end - clock)
    clock = end
  }

  function tick(now: { timestamp: number }) {
    // The time of the frame itself, where the browser tells: smoother than the moment its callbacks run.
    const time = Number(page.timeline?.currentTime ?? now.timestamp)
    advance(Math.min(Math.max(time - (last ?? time), 0) / 1000, LONGEST_FRAME))
    last = time
    world!.eachMoved(paint)
    sync()
  }

  function paint(id: number, x: number, y: number, angle: number, asleep: boolean) {
    const chip = bodies[id]!
    x = Math.round(x * 100) / 100
    y = Math.round(y * 100) / 100
    angle = Math.round(angle * 1e4) / 1e4
    const dx = x - chip.x
    const dy = y - chip.y
    const turned = angle - chip.angle
    const farSquared = (chip.width * chip.width + chip.height * chip.height) / 4
    // One corner at least has gone this far. A chip never drawn compares as not a number.
    if (!(dx * dx + dy * dy + turned * turned * farSquared < VISIBLE * VISIBLE)) {
      chip.x = x
      chip.y = y
      chip.angle = angle
      draw(chip)
    }
    if (chip.state !== 'held') mark(chip, asleep ? 'resting' : 'falling')
  }

  function draw(chip: Chip) {
    const { element, x, y, angle } = chip
    const at = `translate(${x - chip.width / 2}px,${y - chip.height / 2}px)rotate(${angle}rad)`
    element.style.transform = chip.state === 'held' ? `${at}scale(${HELD_SCALE})` : at
  }

  function mark(chip: Chip, next: Chip['state']) {
    if (chip.state === next) return
    chip.state = next
    chip.element.setAttribute('data-state', next)
  }

  /** Brings loop, timer and state in line with all there is to know. Every event ends here. */
  function sync() {
    const idle = !world || world.resting
    const next = still.matches
      ? 'static'
      : !started || !world
        ? 'waiting'
        : stopped
          ? 'paused'
          : idle && !queue.length
            ? 'resting'
            : inView && !page.hidden && width * height
              ? 'running'
              : 'paused'
    const running = next === 'running'
    if (running && !idle) frame.render(tick, true)
    else {
      cancelFrame(tick)
      last = undefined
    }
    // Nothing moves before the next release: a timer is enough until then.
    const upcoming = running && idle ? queue[0] : undefined
    if (upcoming !== awaited) {
      awaited = upcoming
      clearTimeout(timer)
      if (upcoming) timer = setTimeout(arrive, (upcoming.due - clock) * 1000)
    }
    if (!running && next !== 'resting') for (const pointer of presses.keys()) letGo(pointer)
    if (next === state) return
    const settled = state === 'running' && next === 'resting'
    state = next
    root.setAttribute('data-state', next)
    if (settled) options.onSettle?.()
  }

  function arrive() {
    awaited = undefined
    advance(Math.max(queue[0]!.due - clock, 0))
    sync()
  }

  function stillChanged() {
    sizes.disconnect()
    if (!still.matches) {
      sizes.observe(root)
      for (const chip of chips.values()) sizes.observe(chip.element)
    }
    sync()
  }

  /** The stage comes near the view for the first time. Until then it has done nothing. */
  function arm() {
    armed = true
    const { signal } = life
    still.addEventListener('change', stillChanged, { signal })
    page.addEventListener('visibilitychange', sync, { signal })
    root.addEventListener('transitionend', ({ target }) => reshape(target), { signal })
    root.addEventListener(
      'focusin',
      ({ target }) => {
        const chip = chipAt(target as Node)
        if (!chip) return
        toFront(chip)
        // Nobody can use what still waits out of sight.
        if (!queue.includes(chip)) return
        root.scrollIntoView({ block: 'nearest' })
        started = true
        chip.due = clock
        awaited = undefined
        queue.sort((a, b) => a.due - b.due)
        sync()
      },
      { signal },
    )
    changes.observe(root, { attributeFilter: ['class'], childList: true, subtree: true })
    collect()
    stillChanged()
    setInput()
  }

  // Pointers

  function setInput() {
    const wanted = armed && options.interactive
    if (wanted === !!input) return
    input?.abort()
    input = undefined
    for (const pointer of presses.keys()) letGo(pointer)
    if (!wanted) return
    input = new AbortController()
    const { signal } = input
    root.addEventListener('pointerdown', down, { signal })
    root.addEventListener('dragstart', (event) => presses.size && event.preventDefault(), { signal })
    root.addEventListener('click', click, { capture: true, signal })
    for (const chip of chips.values()) listen(chip, signal)
  }

  /** A held chip keeps the finger from scrolling. On the chips alone: the rest of the stage scrolls unasked. */
  function listen(chip: Chip, signal: AbortSignal) {
    const hold = (event: Event) => chip.state === 'held' && event.cancelable && event.preventDefault()
    chip.element.addEventListener('touchmove', hold, { passive: false, signal })
  }

  function toFront(chip: Chip) {
    chip.element.style.zIndex = `${++front}`
  }

  function down(event: PointerEvent) {
    swallowClick = false
    const target = event.target as Element
    const chip = chipAt(target)
    const { clientX, clientY, pointerId } = event
    if (!chip || chip.id < 0 || event.button || event.ctrlKey || target.closest(EDITABLE)) return
    if (state !== 'running' && state !== 'resting') return
    for (const press of presses.values()) if (press.chip === chip) return
    const toStage = pointerMap(root)
    const [x, y] = toStage(event)
    const [cos, sin] = [Math.cos(chip.angle), Math.sin(chip.angle)]
    const press: Press = {
      chip,
      clientX,
      clientY,
      x,
      y,
      toStage,
      seconds: event.timeStamp / 1000,
      localX: cos * (x - chip.x) + sin * (y - chip.y),
      localY: cos * (y - chip.y) - sin * (x - chip.x),
      moved: false,
      touch: event.pointerType === 'touch',
    }
    letGo(pointerId)
    if (!presses.size) {
      grip = new AbortController()
      const { signal } = grip
      const view = page.defaultView!
      view.addEventListener('pointermove', move, { signal })
      view.addEventListener('pointerup', up, { signal })
      const lose = ({ pointerId }: PointerEvent) => letGo(pointerId)
      view.addEventListener('pointercancel', lose, { signal })
      view.addEventListener('lostpointercapture', lose, { signal })
    }
    presses.set(pointerId, press)
    if (press.touch) press.timer = setTimeout(hold, TOUCH_HOLD, press)
    else hold(press)
  }

  function hold(press: Press) {
    const { chip, localX, localY } = press
    const { x, y, angle } = world!.read(chip.id)
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)]
    clearTimeout(press.timer)
    press.grab = world!.grab(chip.id, x + cos * localX - sin * localY, y + sin * localX + cos * localY)
    press.grab.moveTo(press.x, press.y, press.seconds)
    mark(chip, 'held')
    toFront(chip)
    draw(chip)
    sync()
  }

  function move(event: PointerEvent) {
    const press = presses.get(event.pointerId)
    if (!press) return
    const dx = event.clientX - press.clientX
    const dy = event.clientY - press.clientY
    ;[press.x, press.y] = press.toStage(event)
    press.seconds = event.timeStamp / 1000
    if (!press.moved && Math.hypot(dx, dy) > (press.touch ? TOUCH_DRAG_START : DRAG_START)) {
      // A finger that sets out up or down wants to scroll the page.
      if (!press.grab && Math.abs(dy) > Math.abs(dx)) return letGo(event.pointerId)
      press.moved = true
      try {
        // A finger is captured by what it touched from the start.
        if (!press.touch) press.chip.element.setPointerCapture(event.pointerId)
      } catch {
        // The pointer is gone already, or a script made it up.
      }
      if (!press.grab) hold(press)
    }
    press.grab?.moveTo(press.x, press.y, press.seconds)
  }

  function up(event: PointerEvent) {
    const press = presses.get(event.pointerId)
    if (!press) return
    move(event)
    swallowClick = press.moved
    letGo(event.pointerId)
  }

  function letGo(pointer: number) {
    const press = presses.get(pointer)
    if (!press) return
    presses.delete(pointer)
    clearTimeout(press.timer)
    if (!presses.size) grip!.abort()
    if (!press.grab) return
    press.grab.release()
    mark(press.chip, 'falling')
    draw(press.chip)
    sync()
  }

  function click(event: MouseEvent) {
    if (swallowClick && event.detail) {
      swallowClick = false
      event.preventDefault()
      event.stopPropagation()
      return
    }
    const chip = chipAt(event.target as Node)
    // A way to move a chip without dragging.
    if (!chip || chip.id < 0 || (event.target as Element).closest(CONTROL)) return
    if (state !== 'running' && state !== 'resting') return
    const lift = Math.sqrt(2 * HOP * Math.max(options.gravity, HOP_GRAVITY))
    const [x] = pointerMap(root)(event as PointerEvent)
    const spin = (HOP_SPIN * (x - chip.x)) / chip.width
    world!.place(chip.id, { ...world!.read(chip.id), vy: -lift, spin })
    sync()
  }

  watch(root, ({ isIntersecting, intersectionRatio, intersectionRect, rootBounds }) => {
    inView = isIntersecting
    if (inView && !armed) arm()
    const fills = intersectionRect.height >= FILLS_WINDOW * (rootBounds?.height ?? Number.POSITIVE_INFINITY)
    if (inView && (intersectionRatio >= IN_VIEW || fills)) started = true
    if (armed) sync()
  })

  return {
    update(next) {
      const before = options
      options = {
        ...next,
        gravity: sane('gravity', next.gravity, GRAVITY, 0, 20000),
        bounce: sane('bounce', next.bounce, BOUNCE, 0, 1),
        friction: sane('friction', next.friction, FRICTION, 0, 10),
        stagger: sane('stagger', next.stagger, STAGGER, 0, 60000),
      }
      const { gravity, bounce, friction } = options
      setInput()
      if (!world || (gravity === before.gravity && bounce === before.bounce && friction === before.friction))
        return
      world.configure({ gravity, bounce, friction })
      sync()
    },
    drop() {
      if (!world) return
      for (const pointer of presses.keys()) letGo(pointer)
      started = true
      begin()
      sync()
    },
    shake() {
      for (const chip of chips.values()) {
        if (chip.id < 0) continue
        const either = (channel: number) => 2 * scatter(turns++, channel) - 1
        const vy = -SHAKE * (0.7 + 0.3 * either(2))
        world!.place(chip.id, {
          ...world!.read(chip.id),
          vx: 0.5 * SHAKE * either(1),
          vy,
          spin: SHAKE_SPIN * either(3),
        })
      }
      sync()
    },
    pause() {
      stopped = true
      sync()
    },
    resume() {
      stopped = false
      sync()
    },
    destroy() {
      for (const pointer of presses.keys()) letGo(pointer)
      watcher!.unobserve(root)
      life.abort()
      input?.abort()
      sizes.disconnect()
      changes.disconnect()
      clearTimeout(timer)
      cancelFrame(tick)
      root.setAttribute('data-state', 'static')
      for (const chip of chips.values()) {
        mark(chip, 'waiting')
        chip.element.style.transform = chip.element.style.zIndex = ''
      }
    },
  }
}

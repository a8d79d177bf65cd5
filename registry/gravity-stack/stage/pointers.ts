import type { Grab } from '../solver/world'
import type { Children } from './children'
import { type Chip, draw, setState } from './chip'
import type { Context } from './context'
import type { Focus } from './focus'
import type { Lifecycle } from './lifecycle'
import { CAPTURE, type Listen, listenUntil } from './listeners'
import type { StagePile } from './pile'

/** ms that a finger rests on a chip, or px that it moves aside, before it holds the chip instead of scrolling the page. */
export const TOUCH_HOLD = 180
export const TOUCH_DRAG_START = 8

/** px, how high a tapped chip hops. */
const HOP = 36
/** Size of a held chip, as if pressed between two fingers. */
const HELD_SCALE = 0.97
/** px that a mouse moves before a press is a drag. */
const DRAG_START = 4
/** Elements that a press belongs to, and elements that a tap belongs to. */
const EDITABLE =
  'input, textarea, select, [controls], [contenteditable]:not([contenteditable=false]), [role=slider], [data-slot=slider], [data-no-grab]'
const CONTROL = `${EDITABLE}, a, button, label, summary, [tabindex]`
/** Elements that are drawn over the page, not in the chip that they are of. */
const ELSEWHERE = ':is(dialog, [popover], :fullscreen)'

/** A pointer that is down on a chip. It holds the chip once there is a grab. */
interface Press {
  chip: Chip
  down: PointerEvent
  /** Its last event. */
  at: PointerEvent
  /** From the stage's bounding box, as it is now, to its own px. */
  toStage: DOMMatrix
  box?: DOMRect
  /** Client px, where it went down; a page that scrolls takes that along. */
  fromX: number
  fromY: number
  /** The pointer, px of the stage and s, and where it went down, from the centre of the chip. */
  x: number
  y: number
  seconds: number
  offX: number
  offY: number
  /** What it went down on. */
  origin: Element
  touch: boolean
  moved?: boolean
  timer?: ReturnType<typeof setTimeout>
  grab?: Grab
}

/** Nothing comes of it, and nobody on the way hears of it. */
function stop(event: Event) {
  event.preventDefault()
  event.stopPropagation()
}

/** Whether an event is about something of a kind inside the chip, in a shadow tree too; what is around the stage does not count. */
function isInside({ element }: Chip, event: Event, kind: string) {
  const path = event.composedPath() as Element[]
  return path.slice(0, path.indexOf(element)).some((inner) => inner.matches?.(kind))
}

/** Whether a press is on a scroll bar: outside of what its target shows of its content. Events tell nothing of bars. */
function isOnScrollBar({ target, offsetX, offsetY }: PointerEvent) {
  const { clientWidth, clientHeight } = target as Element
  const scrolled = offsetX >= 0 && offsetY >= 0 && offsetX < clientWidth && offsetY < clientHeight
  return !scrolled && /auto|scroll/.test(getComputedStyle(target as Element).overflow)
}

/** From the bounding box `box` of the stage to its own px, through whatever scales, turns or skews its ancestors: three points tell. */
function pointerMap(root: HTMLElement, box: DOMRect) {
  const probes = [0, 1, 2].map((i) => {
    const probe = root.appendChild(root.ownerDocument.createElement('stage-point'))
    // By transforms, not far, and of some size: where there are columns it would go to another one.
    probe.style.cssText = `position:absolute;left:0;top:0;margin:0;padding:.1px;transform:translate(${i === 1 ? 100 : 0}px,${i === 2 ? 100 : 0}px)`
    return probe
  })
  // All are written before any is read: one layout.
  const [o, u, v] = probes.map((probe) => probe.getBoundingClientRect()) as [DOMRect, DOMRect, DOMRect]
  for (const probe of probes) probe.remove()
  return new DOMMatrix([u.x - o.x, u.y - o.y, v.x - o.x, v.y - o.y, o.x - box.x, o.y - box.y])
    .scale(0.01)
    .inverse()
}

function capture({ chip, down }: Press) {
  try {
    chip.element.setPointerCapture(down.pointerId)
  } catch {
    // A pointer that is gone, or made up by a script, can't be captured.
  }
}

/** Presses, drags and taps on the chips of a stage, by as many pointers as there are. */
export function createPointers(
  { root, view, update }: Context,
  { chips }: Children,
  pile: StagePile,
  focus: Focus,
  { isLive }: Lifecycle,
) {
  /** Pointers that are down on a chip, by their id. */
  const presses = new Map<number, Press>()
  let swallowClick = false
  /** Ends the listeners that follow pointers while one is down. */
  let pressing: AbortController | undefined

  /** Hears wherever a pointer that is down goes. While none is, the page's moves and scrolls are nobody's business here. */
  function listenToPointers() {
    pressing = new AbortController()
    const on = listenUntil(pressing)
    // No link, and no draggable thing around the stage, drags along with a chip, or thinks that it does.
    on(view, 'dragstart', stop, CAPTURE)
    on(view, 'pointermove', move, CAPTURE)
    on(view, 'scroll', follow, CAPTURE)
    on(view, 'pointerup', up, CAPTURE)
    on(view, 'pointercancel', up, CAPTURE)
    on(view, 'lostpointercapture', up, CAPTURE)
  }

  const holds = () => root.querySelector('[data-state=held]')

  /** While a chip is held no finger on the stage scrolls the page: the browser would take all of them, and the chip would fall. */
  function scroll(event: TouchEvent) {
    if (event.cancelable && holds()) event.preventDefault()
  }

  /** Two fingers at once are the browser's. One may join another that already holds a chip. */
  function pinch({ touches }: TouchEvent) {
    if (touches[1] && !holds()) presses.forEach(letGo)
  }

  /** The chip that an event is about. Of a stage in a chip the inner one is meant. */
  function touched(event: Event) {
    const chip = chips.get((event.target as Element).closest('[data-slot=gravity-stack-chip]')!)
    return chip && chip.id >= 0 && isLive() && !isInside(chip, event, ELSEWHERE) ? chip : undefined
  }

  function down(event: PointerEvent) {
    // Its last release may have been lost: to a dialog, another frame.
    up(event)
    const chip = touched(event)
    if (!chip || event.button || event.ctrlKey) return
    if (isInside(chip, event, EDITABLE) || isOnScrollBar(event)) return
    const touch = event.pointerType === 'touch'
    const press = {
      chip,
      down: event,
      origin: event.target as Element,
      fromX: event.clientX,
      fromY: event.clientY,
      touch,
    } as Press
    track(press, event)
    press.offX = press.x - chip.x
    press.offY = press.y - chip.y
    if (!presses.size) listenToPointers()
    presses.set(event.pointerId, press)
    if (touch) {
      press.timer = setTimeout(hold, TOUCH_HOLD, press)
      // From what is taken off the page meanwhile the root would hear no more.
      listenUntil(pressing!)(press.origin, 'touchmove', scroll, { passive: false })
    } else hold(press)
  }

  function track(press: Press, event: PointerEvent) {
    // A page that scrolls moves the whole stage by as much as its bounding box; what is around it may grow, as under a pointer.
    const box = root.getBoundingClientRect()
    if (box.width !== press.box?.width || box.height !== press.box.height)
      press.toStage = pointerMap(root, box)
    // The same event again: the page has scrolled, and takes along where it went down.
    if (event === press.at) {
      press.fromX += box.x - press.box!.x
      press.fromY += box.y - press.box!.y
    }
    press.box = box
    const { x, y } = press.toStage.transformPoint({ x: event.clientX - box.x, y: event.clientY - box.y })
    press.at = event
    press.x = x
    press.y = y
    press.seconds = event.timeStamp / 1000
  }

  /** The page scrolls under a pointer that stands still. */
  function follow() {
    presses.forEach((press) => {
      move(press.at)
    })
  }

  function hold(press: Press) {
    const { chip } = press
    // Another hand may have it, or may have taken it while a finger waited.
    if (chip.state === 'held') return letGo(press)
    clearTimeout(press.timer)
    focus.toFront(chip)
    press.grab = pile.grab(chip, press.offX, press.offY)
    press.grab.moveTo(press.x, press.y, press.seconds)
    // The point in the hand stays where it is: what shrank away from under the pointer would miss its click.
    const c = (1 - HELD_SCALE) * Math.cos(chip.angle)
    const s = (1 - HELD_SCALE) * Math.sin(chip.angle)
    chip.pinch = `translate(${c * press.offX + s * press.offY}px,${c * press.offY - s * press.offX}px)scale(${HELD_SCALE})`
    show(chip, 'held')
  }

  function move(event: PointerEvent) {
    const press = presses.get(event.pointerId)
    if (!press) return
    // Its release was lost: to a menu of the system, an alert.
    if (event.isTrusted && event.type === 'pointermove' && !(event.buttons & 1)) return letGo(press)
    track(press, event)
    const dx = event.clientX - press.fromX
    const dy = event.clientY - press.fromY
    if (!press.moved && Math.hypot(dx, dy) > (press.touch ? TOUCH_DRAG_START : DRAG_START)) {
      // A finger that sets out up or down wants to scroll the page.
      if (!press.grab && Math.abs(dy) > Math.abs(dx)) return letGo(press)
      press.moved = true
      capture(press)
      if (!press.grab) return hold(press)
    }
    press.grab?.moveTo(press.x, press.y, press.seconds)
  }

  /** The pointer is up, or lost to the browser. */
  function up(event: PointerEvent) {
    const press = presses.get(event.pointerId)
    if (!press) return
    // The chip has taken it from what is inside it, or has it again.
    if (event.type === 'lostpointercapture' && press.chip.element.hasPointerCapture(event.pointerId)) return
    if (event.type === 'pointerup') move(event)
    letGo(press)
  }

  function show(chip: Chip, state: Chip['state']) {
    setState(chip, state)
    draw(chip)
    update()
  }

  function letGo(press: Press) {
    presses.delete(press.down.pointerId)
    if (!presses.size) pressing!.abort()
    clearTimeout(press.timer)
    if (press.moved) swallowClick = true
    if (!press.grab) return
    press.grab.release()
    press.chip.pinch = ''
    show(press.chip, 'falling')
  }

  /** A drag is no click. Nobody on the way to the stage hears of it either. */
  function swallow(event: PointerEvent) {
    // A key's click is no drag's: Firefox counts Enter on a link as one, older browsers tell no type of pointer.
    if (!swallowClick || !(event.pointerType ?? event.detail) || !event.composedPath().includes(root)) return
    swallowClick = false
    stop(event)
  }

  /** A way to move a chip without dragging. */
  function click(event: PointerEvent) {
    // From a closed shadow tree the window is not told where the click is.
    swallow(event)
    const chip = touched(event)
    if (event.defaultPrevented || !chip || isInside(chip, event, CONTROL)) return
    pile.launch(chip, HOP)
    update()
  }

  return {
    /** Hears presses and clicks from now on, and touches. */
    listen(on: Listen) {
      // Not every drag ends in a click, and the next press may be on a label outside.
      on(view, 'pointerdown', () => (swallowClick = false), CAPTURE)
      on(root, 'pointerdown', down)
      on(view, 'click', swallow, CAPTURE)
      on(root, 'click', click, CAPTURE)
      // Where fingers are listened to browsers ask before one comes down, so these two are there from the start. One that holds a chip does not scroll.
      on(view, 'touchstart', pinch, CAPTURE)
      on(root, 'touchmove', scroll, { passive: false })
    },
    /** An element that React moves to another place loses the pointer. */
    recapture() {
      presses.forEach((press) => {
        if (press.moved || !press.origin.isConnected) capture(press)
      })
    },
    /** Lets go of one chip, or of all. */
    letGo(chip?: Chip) {
      presses.forEach((press) => {
        if (!chip || press.chip === chip) letGo(press)
      })
    },
  }
}

import type { Grab } from '../solver/input'
import { type Chip, draw, setState } from './chip'
import type { Clicks } from './clicks'
import type { Context } from './context'
import type { Focus } from './focus'
import type { Lifecycle } from './lifecycle'
import { type Listen, listenUntil, stop } from './listeners'
import type { StagePile } from './pile'
import { type Place, placeOf } from './pointer-map'
import { chipUnder, EDITABLE, isInside, isOnScrollBar } from './targets'

/** ms that a finger rests on a chip, or px that it moves sideways, before it holds the chip (D-066). */
export const TOUCH_HOLD = 180
export const TOUCH_DRAG_START = 8

/** Scale at which a held chip is drawn (D-066). */
const HELD_SCALE = 0.97
/** px that a mouse moves before a press is a drag (D-066). */
const DRAG_START = 4
/** A pointer that is down on a chip. It holds the chip once there is a grab. */
interface Press {
  chip: Chip
  /** The last event of the pointer. */
  at: PointerEvent
  place: Place
  /** Client px, where the pointer went down; scrolling moves that along. */
  fromX: number
  fromY: number
  /** px from the centre of the chip, where the pointer went down. */
  offX: number
  offY: number
  /** The element that the pointer went down on. */
  origin: Element
  moved?: boolean
  timer?: ReturnType<typeof setTimeout>
  grab?: Grab
}

function capture({ chip, at }: Press) {
  try {
    chip.element.setPointerCapture(at.pointerId)
  } catch {
    // A pointer that is gone, or that a script has made up, can't be captured.
  }
}

/** Leads the chip to where the pointer is. */
function moveGrab({ grab, place }: Press) {
  grab?.moveTo(place.x, place.y, place.seconds)
}

/** CSS transforms that shrink a chip towards the pointer, so that a click still meets its element. */
function pinchOf({ chip, offX, offY }: Press) {
  const c = (1 - HELD_SCALE) * Math.cos(chip.angle)
  const s = (1 - HELD_SCALE) * Math.sin(chip.angle)
  return `translate(${c * offX + s * offY}px,${c * offY - s * offX}px)scale(${HELD_SCALE})`
}

/** Presses and drags on the chips of a stage, by as many pointers as there are. */
export function createPointers(
  { root, view, chips, update }: Context,
  pile: StagePile,
  focus: Focus,
  { isLive }: Lifecycle,
  clicks: Clicks,
) {
  /** Pointers that are down on a chip, by their id. */
  const presses = new Map<number, Press>()
  /** Ends the listeners that follow pointers while one is down. */
  let pressing: AbortController | undefined

  /** Follows pointers that are down. While none is, nobody listens to moves and scrolls of the page. */
  function listenToPointers() {
    pressing = new AbortController()
    const on = listenUntil(pressing)
    // No link in a chip, and no draggable element around the stage, is dragged along.
    on(view, 'dragstart', stop)
    on(view, 'pointermove', move)
    on(view, 'scroll', follow)
    on(view, 'pointerup', up)
    on(view, 'pointercancel', up)
    on(view, 'lostpointercapture', up)
  }

  const holds = () => root.querySelector('[data-state=held]')

  /** No finger scrolls while a chip is held: the browser would take all fingers, and the chip would fall. */
  function scroll(event: TouchEvent) {
    if (event.cancelable && holds()) event.preventDefault()
  }

  /** Two fingers at once zoom the page; but a second finger may join one that holds a chip. */
  function pinch({ touches }: TouchEvent) {
    if (touches[1] && !holds()) presses.forEach(letGo)
  }

  function down(event: PointerEvent) {
    // The last release of this pointer may have gone to a dialog or another frame.
    up(event)
    const chip = chipUnder(event, chips)
    if (!chip || !isLive() || event.button || event.ctrlKey) return
    if (isInside(chip, event, EDITABLE) || isOnScrollBar(event)) return
    const place = placeOf(event, root)
    const press: Press = {
      chip,
      at: event,
      place,
      origin: event.target as Element,
      fromX: event.clientX,
      fromY: event.clientY,
      offX: place.x - chip.x,
      offY: place.y - chip.y,
    }
    if (!presses.size) listenToPointers()
    presses.set(event.pointerId, press)
    if (event.pointerType === 'touch') {
      press.timer = setTimeout(hold, TOUCH_HOLD, press)
      // Touches stay with their element: if it is taken off the page, they no longer reach the stage.
      listenUntil(pressing!)(press.origin, 'touchmove', scroll, { passive: false })
    } else hold(press)
  }

  /** The page scrolls under pointers that stand still. */
  function follow() {
    presses.forEach((press) => {
      move(press.at)
    })
  }

  function hold(press: Press) {
    const { chip } = press
    // Another pointer may hold the chip by now.
    if (chip.state === 'held') return letGo(press)
    clearTimeout(press.timer)
    focus.toFront(chip)
    press.grab = pile.grab(chip, press.offX, press.offY)
    moveGrab(press)
    chip.pinch = pinchOf(press)
    show(chip, 'held')
  }

  function move(event: PointerEvent) {
    const press = presses.get(event.pointerId)
    if (!press) return
    // The release was lost to a menu of the system or an alert.
    if (event.isTrusted && event.type === 'pointermove' && !(event.buttons & 1)) return letGo(press)
    const { box } = press.place
    press.place = placeOf(event, root, press.place)
    // The same event comes again after the page has scrolled, which moves the place of the press along.
    if (event === press.at) {
      press.fromX += press.place.box.x - box.x
      press.fromY += press.place.box.y - box.y
    }
    press.at = event
    const dx = event.clientX - press.fromX
    const dy = event.clientY - press.fromY
    if (
      !press.moved &&
      Math.hypot(dx, dy) > (event.pointerType === 'touch' ? TOUCH_DRAG_START : DRAG_START)
    ) {
      // A finger that moves up or down first is to scroll the page.
      if (!press.grab && Math.abs(dy) > Math.abs(dx)) return letGo(press)
      press.moved = true
      capture(press)
      if (!press.grab) return hold(press)
    }
    moveGrab(press)
  }

  /** The pointer is up, or lost to the browser. */
  function up(event: PointerEvent) {
    const press = presses.get(event.pointerId)
    if (!press) return
    // The chip has captured the pointer from an element inside it, or again.
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
    presses.delete(press.at.pointerId)
    if (!presses.size) pressing!.abort()
    clearTimeout(press.timer)
    if (press.moved) clicks.stopNext()
    if (!press.grab) return
    press.grab.release()
    press.chip.pinch = ''
    show(press.chip, 'falling')
  }

  return {
    listen(on: Listen) {
      on(root, 'pointerdown', down, { capture: false })
      // Browsers ask before a finger comes down whether anybody listens to touches, so these two are there
      // from the start.
      on(view, 'touchstart', pinch)
      on(root, 'touchmove', scroll, { passive: false })
    },
    /** Captures pointers again: an element that React moves to another place loses them. */
    capture() {
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

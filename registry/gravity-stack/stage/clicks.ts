import type { Context } from './context'
import type { Lifecycle } from './lifecycle'
import { CAPTURE, type Listen, stop } from './listeners'
import type { StagePile } from './pile'
import { CONTROL, chipUnder, isInside } from './targets'

/** px, how high a tapped chip hops (D-002). */
const HOP = 36

/** Clicks on the chips of a stage: a tap lets its chip hop, and the click that ends a drag is stopped. */
export function createClicks({ root, view, chips, update }: Context, pile: StagePile, { isLive }: Lifecycle) {
  /** Whether the next click ends a drag. */
  let dragged = false

  function stopAfterDrag(event: PointerEvent) {
    // A click by a key ends no drag. Firefox takes Enter on a link for a click; older browsers have no type
    // of pointer.
    if (!dragged || !(event.pointerType ?? event.detail) || !event.composedPath().includes(root)) return
    dragged = false
    stop(event)
  }

  /** Taps let people move a chip without dragging. */
  function click(event: PointerEvent) {
    // The window does not learn that a click in a closed shadow tree is in the stage.
    stopAfterDrag(event)
    const chip = chipUnder(event, chips)
    if (event.defaultPrevented || !chip || !isLive() || isInside(chip, event, CONTROL)) return
    pile.launch(chip, HOP)
    update()
  }

  return {
    listen(on: Listen) {
      // Not every drag ends in a click, and the next press may be on a label outside.
      on(view, 'pointerdown', () => (dragged = false), CAPTURE)
      on(view, 'click', stopAfterDrag, CAPTURE)
      on(root, 'click', click, CAPTURE)
    },
    /** A drag has ended. */
    stopNext() {
      dragged = true
    },
  }
}

export type Clicks = ReturnType<typeof createClicks>

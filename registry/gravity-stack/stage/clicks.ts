import type { Context } from './context'
import type { Lifecycle } from './lifecycle'
import { type Listen, stop } from './listeners'
import type { StagePile } from './pile'
import { CONTROL, chipUnder, isInside } from './targets'

/** px, how high a tapped chip hops (D-002). */
const HOP = 36

/** Clicks on the chips of a stage: a tap lets its chip hop, and the click that ends a drag is stopped. */
export function createClicks({ root, view, chips, update }: Context, pile: StagePile, { isLive }: Lifecycle) {
  /** Whether the next click ends a drag. */
  let dragged = false

  function stopAfterDrag(event: PointerEvent) {
    // A click by a key ends no drag: the type of its pointer is empty. In older browsers no click has such a
    // type, and the detail of a key's click is 0.
    if (!dragged || !(event.pointerType ?? event.detail) || !event.composedPath().includes(root)) return
    dragged = false
    stop(event)
  }

  /** A tap lets people move a chip without a drag. */
  function click(event: PointerEvent) {
    // If the stage is in a closed shadow tree, the window's listener can't tell that this click is in it.
    stopAfterDrag(event)
    const chip = chipUnder(event, chips)
    if (event.defaultPrevented || !chip || !isLive() || isInside(chip, event, CONTROL)) return
    pile.launch(chip, HOP)
    update()
  }

  return {
    listen(on: Listen) {
      // A drag may end without a click. It must not stop the click of a later press.
      on(view, 'pointerdown', () => (dragged = false))
      on(view, 'click', stopAfterDrag)
      on(root, 'click', click)
    },
    /** A drag has ended: the click that follows it is stopped. */
    stopNext() {
      dragged = true
    },
  }
}

export type Clicks = ReturnType<typeof createClicks>

import { chipAt } from './children'
import type { Chip } from './chip'
import type { Context } from './context'
import type { Listen } from './listeners'
import type { StagePile } from './pile'

/** Brings the chip with the focus to the front and into view; calls `hurry` if that chip waits. */
export function createFocus(
  { root, view, still, pausing, chips, update }: Context,
  pile: StagePile,
  hurry: () => void,
) {
  let front = 0
  /** The chip that got the focus while it waited or fell, until that chip lies. */
  let followed: Chip | undefined
  let listen: Listen

  const focus = {
    listen(on: Listen) {
      listen = on
      on(root, 'focusin', ({ target }: Event) => focus.on(target))
    },

    toFront({ element }: Chip) {
      element.style.zIndex = `${++front}`
    },

    /** The element `target` has got the focus. */
    on(target: EventTarget | null) {
      const chip = chipAt(chips, target)
      if (!chip) return
      focus.toFront(chip)
      if (still.matches) return
      // A chip that can't be seen yet goes on falling, and its stage comes into view. Once the chip lies,
      // `follow` brings the chip itself into view. A press scrolls nothing, though a pressed field shows its
      // focus as well; nor does the focus that a dialog gives back to a chip at rest.
      const unseen = chip.state === 'waiting' || (target as Element).matches(':focus-visible:not(:active)')
      if (unseen && chip.state !== 'resting') {
        if (chip.state === 'waiting' || chip.y < 0) root.scrollIntoView({ block: 'nearest' })
        followed = chip
        // People who scroll on meanwhile are not brought back.
        for (const type of ['wheel', 'touchmove', 'keydown'])
          listen(view, type, () => (followed = undefined), { once: true })
      }
      if (chip.id < 0) hurry()
      if (unseen) focus.bringIn(chip)
      update()
    },

    /** The element that has the focus, in the page or the shadow tree. */
    active: () => (root.getRootNode() as Document).activeElement,

    /** In a paused stage, where no time passes, moves a chip into sight: without one, that with the focus. */
    bringIn(chip = chipAt(chips, focus.active())) {
      if (!chip || !pile.world || !pausing.current) return
      if (chip.id < 0 ? !pile.withdraw(chip) : chip.state === 'resting' || chip.y > 0) return
      if (chip.id < 0) pile.release(chip)
      pile.world.place(chip.id, { y: chip.reach })
      pile.draw()
    },

    /** Brings the chip in `followed` into view once that chip lies. */
    follow() {
      if (followed?.state !== 'resting') return
      if (followed.element.matches(':focus-within')) followed.element.scrollIntoView({ block: 'nearest' })
      followed = undefined
    },
  }
  return focus
}

export type Focus = ReturnType<typeof createFocus>

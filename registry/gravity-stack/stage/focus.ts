import { chipAt } from './children'
import type { Chip } from './chip'
import type { Context } from './context'
import { CAPTURE, type Listen } from './listeners'
import type { StagePile } from './pile'

/** Brings the chip with the focus to the front and into view; calls `hurry` if it waits for its release. */
export function createFocus(
  { root, view, still, pausing, chips, update }: Context,
  pile: StagePile,
  hurry: () => void,
) {
  let front = 0
  /** The chip that got the focus before it lay, until it lies. */
  let followed: Chip | undefined
  let listen: Listen

  const focus = {
    listen(on: Listen) {
      listen = on
      on(root, 'focusin', focus.on)
    },

    toFront({ element }: Chip) {
      element.style.zIndex = `${++front}`
    },

    on({ target }: { target: EventTarget | null }) {
      const chip = chipAt(chips, target)
      if (!chip) return
      focus.toFront(chip)
      if (still.matches) return
      // The chip goes on falling. Where it can't be seen yet, the stage comes into view; once the chip lies,
      // it comes itself if that was not enough. A press scrolls nothing, though a field shows its focus then
      // as well; nor does the focus that a dialog gives back.
      const unseen = chip.state === 'waiting' || (target as Element).matches(':focus-visible:not(:active)')
      if (unseen && chip.state !== 'resting') {
        if (chip.state === 'waiting' || chip.y < 0) root.scrollIntoView({ block: 'nearest' })
        followed = chip
        // People who scroll on meanwhile are not brought back.
        for (const type of ['wheel', 'touchmove', 'keydown'])
          listen(view, type, () => (followed = undefined), { ...CAPTURE, once: true })
      }
      if (chip.id < 0) hurry()
      if (unseen) focus.bringIn(chip)
      update()
    },

    /** An event's target for the element that has the focus, in the page or the shadow tree. */
    active: () => ({ target: (root.getRootNode() as Document).activeElement }),

    /** In a paused stage, where no time passes, puts a chip, or that with the focus, where it can be seen. */
    bringIn(chip = chipAt(chips, focus.active().target)) {
      if (!chip || !pile.world || !pausing.current) return
      if (chip.id < 0 ? !pile.withdraw(chip) : chip.state === 'resting' || chip.y > 0) return
      if (chip.id < 0) pile.release(chip)
      pile.world.place(chip.id, { y: chip.reach })
      pile.draw()
    },

    /** Brings the chip that was followed into view once it lies. */
    follow() {
      if (followed?.state !== 'resting') return
      if (followed.element.matches(':focus-within')) followed.element.scrollIntoView({ block: 'nearest' })
      followed = undefined
    },
  }
  return focus
}

export type Focus = ReturnType<typeof createFocus>

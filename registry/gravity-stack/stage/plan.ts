import { STEP } from '../solver/constants'
import type { Chip } from './chip'
import type { Context } from './context'
import { type LookAhead, SLICE, uprightTurn } from './look-ahead'
import type { Obstacles } from './obstacles'
import type { StagePile } from './pile'
import type { Pile } from './release'
import type { ReleaseQueue } from './release-queue'
import type { Visibility } from './visibility'

/** s after the last release that an unseen pile gets to come to rest, where there is no drop (D-003). */
const LONGEST_SETTLING = 20
/** s that the first release waits at most for the plan (D-001). */
const HEAD_START = 0.25

/** Begins drops, and computes between frames how chips will lie, or a pile that lies there from the start. */
export function createPlan(
  context: Context,
  queue: ReleaseQueue,
  lookAhead: LookAhead<Chip>,
  pile: StagePile,
  visibility: Visibility,
  obstacles: Obstacles,
) {
  const { settings } = context
  let timer: ReturnType<typeof setTimeout> | undefined
  let enabled = false

  function work() {
    timer = undefined
    if (!enabled) return
    if (plan.settling) return settle()
    if (!lookAhead.advance(pile as Pile<Chip>, queue)) {
      // While nothing moves no frame asks for the next slice.
      if (pile.world!.resting) plan.request()
    } else if (queue.clock < 0 && queue.latest < 0) {
      queue.skipHeadStart()
      context.update()
    }
  }

  /** Lets the drop pass, for as long as a slice is. */
  function settle() {
    const end = performance.now() + SLICE
    while (queue.chips[0] || (!pile.world!.resting && queue.clock < queue.latest + LONGEST_SETTLING)) {
      if (performance.now() > end) return plan.request()
      pile.advance(queue.clock + STEP)
    }
    // Nobody has seen the chips yet: each turns to what is upright where it lies.
    pile.chips.forEach((chip) => {
      chip.turned = true
      if (settings.upright) chip.turn = uprightTurn(chip, pile.world!.read(chip.id).angle)
    })
    plan.show()
    pile.draw()
    context.update()
  }

  const plan = {
    /** Whether the pile that lies there from the start is still falling, unseen. */
    settling: false,

    /** Begins a drop. */
    begin() {
      plan.settling = !pile.world && !settings.initial
      pile.begin(settings.upright && !plan.settling ? -HEAD_START : 0)
      obstacles.enter()
    },

    /** The row gives way to the pile. */
    show() {
      plan.settling = false
      visibility.start()
      context.root.removeAttribute('data-row')
    },

    /** Says whether slices are worth their time. */
    enable(yes: boolean) {
      enabled = yes
      plan.request()
    },

    /** Asks for a slice outside of the frame, if a chip can still be turned. */
    request() {
      if (enabled && (plan.settling || queue.chips.length || pile.chips.some(({ turned }) => !turned)))
        timer ??= setTimeout(work)
      else lookAhead.end()
    },

    end() {
      clearTimeout(timer)
      timer = undefined
      plan.enable(false)
    },
  }
  return plan
}

export type Plan = ReturnType<typeof createPlan>

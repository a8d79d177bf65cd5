import { STEP } from '../solver/constants'
import type { Chip } from './chip'
import type { Settings } from './props'
import { releaseTime } from './release'

/** The chips that wait for their release, and the stage's clock, which the releases go by. */
export function createReleaseQueue(settings: Settings) {
  let count = 0
  /** s, the earliest time of the next release to be planned. */
  let slot = 0
  /** ms, when `clock` was last updated, while nothing moves; undefined while frames count the time. */
  let idleSince: number | undefined

  function schedule(chip: Chip) {
    const { chips, clock } = queue
    // Nobody can use a chip with the focus while it waits unseen.
    chip.due = chip.element.matches(':focus-within') ? clock : Math.max(releaseTime(chip.order, slot), clock)
    slot = Math.max(slot, clock) + settings.stagger / 1000
    let place = chips.length
    while (place > 0 && chips[place - 1]!.due > chip.due) place--
    chips.splice(place, 0, chip)
    queue.revision++
  }

  const queue = {
    /** The chips that wait, the next one first. */
    chips: [] as Chip[],
    /** s since the drop began, pauses left out; below 0 before its first release. */
    clock: 0,
    /** s, time of the last release. */
    latest: -Infinity,
    /** Another number each time that a chip came, went, changed or got another time. */
    revision: 0,

    /** Begins a drop with no chips, and with the clock at `clock`. */
    restart(clock: number) {
      count = slot = 0
      queue.clock = clock
      queue.chips = []
      queue.latest = -Infinity
      queue.revision++
      idleSince = undefined
    },

    /** Lets a chip wait for its release, after all that were added before. */
    add(chip: Chip) {
      chip.order = count++
      schedule(chip)
    },

    /** Takes a chip out; returns whether it waited. */
    remove(chip: Chip) {
      const place = queue.chips.indexOf(chip)
      if (place < 0) return false
      queue.chips.splice(place, 1)
      queue.revision++
      return true
    },

    /** Times the coming releases anew. */
    reschedule() {
      const waiting = queue.chips
      queue.chips = []
      // Counted from the last release: counted from now, a stagger that changes again and again would put the
      // next one off for ever.
      slot = Math.max(0, queue.latest + settings.stagger / 1000)
      waiting.forEach(schedule)
    },

    /** Says whether nothing moves, so that the clock goes by the time of day. */
    setIdle(idle: boolean) {
      idleSince = idle ? (idleSince ?? performance.now()) : undefined
    },

    /**
     * Brings the clock up to now while nothing moves. It goes in whole steps, as the world does, so that a
     * release falls on the same place within its step as without a pause.
     */
    catchUp() {
      if (idleSince === undefined) return
      const now = performance.now()
      const untilNext = (queue.chips[0]?.due ?? Infinity) - queue.clock
      const steps = STEP * Math.max(0, Math.floor(Math.min((now - idleSince) / 1000, untilNext) / STEP))
      queue.clock += steps
      idleSince = Math.max(idleSince + 1000 * steps, now - 1000 * STEP)
    },

    /** Skips what is left of the time before the first release. */
    skipHeadStart() {
      queue.clock = 0
      if (idleSince !== undefined) idleSince = performance.now()
    },
  }
  return queue
}

export type ReleaseQueue = ReturnType<typeof createReleaseQueue>

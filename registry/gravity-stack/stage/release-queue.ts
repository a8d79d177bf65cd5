import type { World } from '../solver/world'
import type { Chip } from './chip'
import { type Obstacle, type Release, releasePose, releaseTime } from './release'

/** A world, and what was released into it, by the ids of the bodies. */
export interface Pile<T extends Release = Release> {
  world: World
  chips: T[]
}

/** Puts something into a pile where its release says, clear of all that is still above the stage there; returns the id of its body. */
export function addReleased<T extends Release>(
  { world, chips }: Pile<T>,
  next: T,
  stageWidth: number,
  gravity: number,
): number {
  const obstacles: Obstacle[] = []
  chips.forEach(({ reach }, id) => {
    const { x, y } = world.read(id)
    if (y < reach) obstacles.push({ x, y, reach })
  })
  const { order, width, height, radius } = next
  const pose = releasePose(order, width, height, stageWidth, gravity, obstacles)
  const id = world.add({ width, height, radius, ...pose })
  chips[id] = next
  return id
}

/** The chips whose release is to come, and the stage's clock, which their releases go by. */
export function createReleaseQueue() {
  let count = 0
  /** s, the least time of the next release to be planned. */
  let slot = 0

  function schedule(chip: Chip) {
    const { chips, clock, stagger } = queue
    // Nobody can use what still waits unseen.
    chip.due = chip.element.matches(':focus-within') ? clock : Math.max(releaseTime(chip.order, slot), clock)
    slot = Math.max(slot, clock) + stagger / 1000
    let place = chips.length
    while (place > 0 && chips[place - 1]!.due > chip.due) place--
    chips.splice(place, 0, chip)
    queue.revision++
  }

  const queue = {
    /** Those that wait, the next one first. */
    chips: [] as Chip[],
    /** s simulated since the drop began. */
    clock: 0,
    /** s, time of the last release. */
    latest: -Infinity,
    /** ms between two releases. */
    stagger: 0,
    /** How often something waiting came, went, changed or got another time. */
    revision: 0,

    /** Begins a drop, with the clock at `clock` and nothing waiting. */
    restart(clock: number) {
      count = slot = 0
      queue.clock = clock
      queue.chips = []
      queue.latest = -Infinity
      queue.revision++
    },

    /** Lets a chip wait for its turn behind all that were added before. */
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

    /** Times the releases to come anew. */
    reschedule() {
      const waiting = queue.chips
      queue.chips = []
      // From the last release on, not from now: a stagger that changes again and again would put the next one off for ever.
      slot = Math.max(0, queue.latest + queue.stagger / 1000)
      waiting.forEach(schedule)
    },
  }
  return queue
}

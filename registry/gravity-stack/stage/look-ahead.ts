import { STEP } from '../solver/constants'
import { createWorld } from '../solver/world'
import type { Release } from './release'
import { addReleased, type Pile } from './release-queue'

// Words land the right way up. A copy of the world goes ahead of the shown one and tells how each chip will lie; equal steps give equal
// bits, so it tells the truth. A chip is then drawn turned from the start: after half a turn its body is the same, and so is the pile.

/** s that the copy goes ahead. Of 60 words 5 % end upside down with 1 s, 2 % with 2 s, 1 % with 3 s; discs roll on for longer. */
const FORESIGHT = 6
/** ms of one slice of this work. */
export const LOOK_SLICE = 4

type Outline = Pick<Release, 'width' | 'height' | 'radius'>

/** rad that turn a body lying at `angle` as near to upright as it goes without a change of its outline. */
export function uprightTurn({ width, height, radius }: Outline, angle: number) {
  if (width === height && radius >= width / 2) return -angle
  const same = width === height ? Math.PI / 2 : Math.PI
  return -same * Math.round(angle / same)
}

/** What is to come on a stage: its releases, in their order, and its clock, s. */
export interface Coming<T extends Release = Release> {
  chips: T[]
  clock: number
  /** Another number whenever something else is to come than before. */
  revision: number
}

/** `prepare` is called with each chip before its release in the copy. */
export function createLookAhead<T extends Release>(prepare: (chip: T) => void) {
  let copy: Pile<T> | undefined
  let waiting: T[] = []
  let revision = Number.NaN
  /** s of the stage's clock to which the copy has come. */
  let time = 0

  return {
    /**
     * Lets the copy go on for a slice, from the shown pile if something has interfered with that, or if the copy has fallen behind.
     * Returns whether it is as far ahead as it is to go.
     */
    advance(shown: Pile<T>, coming: Coming<T>, stageWidth: number, gravity: number): boolean {
      const end = performance.now() + LOOK_SLICE
      const now = coming.clock - shown.world.left
      copy ??= { world: createWorld({ width: 1, height: 1 }), chips: [] }
      const { world } = copy
      if (revision !== coming.revision || !world.follows(shown.world) || time < now - STEP / 2) {
        world.follow(shown.world)
        copy.chips = shown.chips.slice()
        waiting = [...coming.chips]
        revision = coming.revision
        time = now
      }
      // Where nothing moves the next thing to happen is a release.
      const first = coming.chips[0]
      const horizon = FORESIGHT + (first && shown.world.resting ? first.due : now)
      while (time < horizon && (waiting[0] || !world.resting)) {
        if (performance.now() > end) return false
        time += STEP
        while (waiting[0] && waiting[0].due < time) {
          const chip = waiting.shift()!
          prepare(chip)
          addReleased(copy, chip, stageWidth, gravity)
        }
        world.step(STEP)
      }
      return true
    },

    /** rad at which the body of a released chip is expected to lie, as far as that is known by now. */
    expectedAngle(chip: T): number | undefined {
      return copy?.chips[chip.id] === chip ? copy.world.read(chip.id).angle : undefined
    },

    /** Gives the copy back. */
    end() {
      copy = undefined
      revision = Number.NaN
    },
  }
}

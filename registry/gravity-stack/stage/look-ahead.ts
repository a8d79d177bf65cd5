import { STEP } from '../solver/constants'
import { createWorld } from '../solver/world'
import { addReleased, type Pile, type Release } from './release'

// Words land the right way up. A copy of the world goes ahead of the shown one and tells how each chip will
// lie. Equal steps give equal bits, so the forecast is exact. Each chip is drawn turned from the start: its
// body looks the same after half a turn.

/**
 * s that the copy goes ahead. Of 60 words, 5 % end upside down with 1 s, 2 % with 2 s, 1 % with 3 s (D-001).
 */
const FORESIGHT = 6
/** ms, how long one slice of the work takes (D-001). */
export const SLICE = 4

type Outline = Pick<Release, 'width' | 'height' | 'radius'>

/** rad by which a body at `angle` has to turn to be as near to upright as it can be with the same outline. */
export function uprightTurn({ width, height, radius }: Outline, angle: number) {
  if (width === height && radius >= width / 2) return -angle
  const same = width === height ? Math.PI / 2 : Math.PI
  return -same * Math.round(angle / same)
}

/** The releases that are to come on a stage, in their order, and the clock of the stage, s. */
export interface Coming<T extends Release = Release> {
  chips: T[]
  clock: number
  /** Another number each time that the releases to come have changed. */
  revision: number
}

/** Goes ahead of a pile in a copy of its world; calls `prepare` with each chip before its release there. */
export function createLookAhead<T extends Release>(prepare: (chip: T) => void) {
  let copy: Pile<T> | undefined
  let waiting: T[] = []
  let revision = Number.NaN
  /** s on the stage's clock, how far the copy has come. */
  let time = 0

  return {
    /**
     * Lets the copy go on for a slice. It starts again from the shown pile when something but time has
     * changed that, or when the copy has fallen behind. Returns whether the copy is as far ahead as it is to
     * go.
     */
    advance(shown: Pile<T>, coming: Coming<T>): boolean {
      const end = performance.now() + SLICE
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
      // While nothing moves, the next event is a release.
      const first = coming.chips[0]
      const horizon = FORESIGHT + (first && shown.world.resting ? first.due : now)
      while (time < horizon && (waiting[0] || !world.resting)) {
        if (performance.now() > end) return false
        time += STEP
        while (waiting[0] && waiting[0].due < time) {
          const chip = waiting.shift()!
          prepare(chip)
          addReleased(copy, chip)
        }
        world.step(STEP)
      }
      return true
    },

    /** rad at which the body of a released chip is expected to lie; undefined while that is not known. */
    expectedAngle(chip: T): number | undefined {
      return copy?.chips[chip.id] === chip ? copy.world.read(chip.id).angle : undefined
    },

    /** Drops the copy, so that its memory is free. */
    end() {
      copy = undefined
      revision = Number.NaN
    },
  }
}

export type LookAhead<T extends Release> = ReturnType<typeof createLookAhead<T>>

import { createWorld, type Reading, type WorldOptions } from '@/registry/gravity-stack/world'
import { type Chip, frame } from '@/scenes/scene'

export type State = Reading

/** A run of the solver that can be scrubbed: the state of every chip, frame by frame from the start. */
type Recording = {
  chips: Chip[]
  frames: State[][]
  /** Iterations of the contact solver that the whole run took. */
  iterations: number
}

/** Runs the component's solver over `chips` and keeps every frame. `late` joins them at its frame. */
export function record(
  options: WorldOptions,
  chips: Chip[],
  seconds: number,
  late?: { chip: Chip; at: number },
): Recording {
  const world = createWorld(options)
  const ids = chips.map((chip) => world.add(chip))
  const frames: State[][] = []
  let iterations = 0
  for (let n = 0; n <= Math.round(seconds / frame); n++) {
    if (n === late?.at) ids.push(world.add(late.chip))
    if (n > 0) world.step(frame)
    if (n > 0) iterations += world.stats.sweeps
    frames.push(ids.map((id) => world.read(id)))
  }
  return { chips: late ? [...chips, late.chip] : chips, frames, iterations }
}

// What a frame costs beside the solver of another commit.
import { callInWorker } from '../worker/worker'
import { type Solver, worldScript } from './solver'

/** Median µs of processor a frame of both, and their ratio: median and quartiles of all rounds. */
export type Timing = {
  count: number
  phase: string
  now: number
  before: number
  ratio: { low: number; median: number; high: number }
}

/** A solver counts as dearer if three rounds of four say so: one beside itself varies around 1. */
export const isDearer = ({ ratio }: Timing) => ratio.low > 1

export async function timings(now: Solver, before: Solver): Promise<Timing[]> {
  const files = [await worldScript(now, 'esm'), await worldScript(before, 'esm')]
  return callInWorker('accept/time-worlds', 'timeWorlds', files, 3600)
}

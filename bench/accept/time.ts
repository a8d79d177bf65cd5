// What a frame costs beside the solver of another commit.
import { execFile } from 'node:child_process'
import { promisify } from 'node:util'
import { bundle } from '../worker/run-job'
import { type Solver, worldScript } from './solver'

/** Median µs of processor a frame of both, and their ratio: median and quartiles of all rounds. */
export type Timing = {
  count: number
  phase: string
  now: number
  before: number
  ratio: { low: number; median: number; high: number }
}

/** A solver counts as dearer where three rounds of four say so: the same one beside itself comes out a little above or below 1. */
export const isDearer = ({ ratio }: Timing) => ratio.low > 1

export async function timings(now: Solver, before: Solver): Promise<Timing[]> {
  const files = [await worldScript(now, 'esm'), await worldScript(before, 'esm')]
  const { stdout } = await promisify(execFile)(process.execPath, [await bundle('accept-time'), ...files])
  return stdout
    .trimEnd()
    .split('\n')
    .map((line) => JSON.parse(line))
}

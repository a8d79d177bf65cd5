// What a frame costs beside the solver of another commit.
import { execFile } from 'node:child_process'
import { promisify } from 'node:util'
import { bundle } from '../run-job'
import { type Solver, worldScript } from './solver'

/** Median µs a frame of both, and the median of their ratios round by round. */
export type Timing = { count: number; phase: string; now: number; before: number; ratio: number }

/** How much dearer a frame may be than before. */
export const ratioBound = 1

export async function timings(now: Solver, before: Solver): Promise<Timing[]> {
  const files = [await worldScript(now, 'esm'), await worldScript(before, 'esm')]
  const { stdout } = await promisify(execFile)(process.execPath, [await bundle('accept-time'), ...files])
  return stdout
    .trimEnd()
    .split('\n')
    .map((line) => JSON.parse(line))
}

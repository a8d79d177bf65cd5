import { openWorker, type Worker } from '../worker/worker'
import type { AtLeast, Cost, Job } from './job'

export type Outcome<J extends Job> = J extends { kind: 'errors' }
  ? number[][]
  : J extends { kind: 'scene cost' }
    ? (number | AtLeast)[]
    : J extends { kind: 'pour cost' }
      ? Cost | AtLeast
      : number

/** Seconds of processor that jobs have taken in all. */
export const spent = { seconds: 0 }

/** ms after which a job that may take so many seconds of processor does not come back at all. */
const hung = (patience: number) => 1000 * (3 * patience + 30)

/**
 * The outcome of a job in a worker of its own, or null when it took more than `patience` seconds of
 * processor: however busy the machine is, the same jobs are given up. One that doesn't come back at all is
 * ended from here.
 */
export async function runJob<J extends Job>(
  file: string,
  job: J,
  patience = 300,
): Promise<Outcome<J> | null> {
  const flags =
    job.kind === 'allocation' ? ['--expose-gc', '--min-semi-space-size=256', '--max-semi-space-size=256'] : []
  const worker = openWorker(file, { flags, unbounded: true })
  const answer = await worker.call<Outcome<J>>([job, patience], hung(patience))
  worker.close()
  spent.seconds += answer?.seconds ?? patience
  return answer?.outcome ?? null
}

/** A worker that takes the jobs of one engine in turns and waits in between, so that it warms up once. */
export function openTurns(file: string) {
  const worker: Worker = openWorker(file, { unbounded: true })
  let before = 0
  return {
    /** The outcome of a job, or null when it did not come back. */
    async take<J extends Job>(job: J, patience: number): Promise<Outcome<J> | null> {
      const answer = await worker.call<Outcome<J>>([job], hung(patience))
      spent.seconds += answer ? answer.seconds - before : patience
      before = answer?.seconds ?? before
      return answer?.outcome ?? null
    },
    close: worker.close,
  }
}
export type Turns = ReturnType<typeof openTurns>

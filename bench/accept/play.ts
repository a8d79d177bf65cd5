// Plays subjects in two processes at once, the longest first, and says how far it is.
import { createHash } from 'node:crypto'
import { appendFileSync, existsSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { root } from '../build/root'
import { openWorker } from '../worker/worker'
import type { Run, Subject } from './row'

type Part = { subject: Subject; seeds: number[] }

/** ms that a part takes at most, so that both processes end together. A single run may take longer. */
const mostWeight = 1000

function partsOf(subjects: Subject[], isKnown: (name: string, seed: number) => boolean): Part[] {
  return subjects
    .toSorted((a, b) => b.weight - a.weight)
    .flatMap((subject) => {
      const size = Math.max(1, Math.floor(mostWeight / subject.weight))
      const seeds = Array.from({ length: subject.seeds }, (_, i) => i + 1).filter(
        (seed) => !isKnown(subject.name, seed),
      )
      return Array.from({ length: Math.ceil(seeds.length / size) }, (_, i) => ({
        subject,
        seeds: seeds.slice(i * size, (i + 1) * size),
      }))
    })
}

/** Runs that the same solver has played in the same scenes. A command that was stopped goes on from there. */
function openKept(bundles: string[]) {
  const digest = createHash('sha256').update(process.version)
  for (const file of bundles) digest.update(readFileSync(file))
  const file = join(root, 'node_modules/.cache', `accept-${digest.digest('hex').slice(0, 16)}.jsonl`)
  const kept = new Map<string, Run>()
  const lines = existsSync(file) ? readFileSync(file, 'utf8').split('\n') : []
  for (const line of lines) {
    // The last line of a run that was killed may be half a line.
    if (!line.endsWith('}}')) continue
    // JSON has no Infinity and writes null: a figure without bound.
    const { key, run } = JSON.parse(line, (_, value) => value ?? Number.POSITIVE_INFINITY)
    kept.set(key, run)
  }
  const keyOf = (name: string, seed: number) => `${name} ${seed}`
  return {
    get: (name: string, seed: number) => kept.get(keyOf(name, seed)),
    add(name: string, seed: number, run: Run) {
      kept.set(keyOf(name, seed), run)
      appendFileSync(file, `${JSON.stringify({ key: keyOf(name, seed), run })}\n`)
    },
  }
}

/** ms after which a part that has not come back is given up. */
const hung = 30 * 60_000

function startPlayer(file: string, worldFile: string) {
  const worker = openWorker(file, { args: [worldFile], unbounded: true })
  return {
    async take({ subject: { name }, seeds }: Part): Promise<Run[]> {
      const answer = await worker.call<Run[]>([name, seeds], hung)
      if (!answer) throw new Error(`${name} has not come back from the seeds ${seeds.join(', ')}`)
      return answer.outcome
    },
    end: worker.close,
  }
}

/** ms between two words of progress where nobody watches a terminal. */
const between = 15_000

function progress(total: number) {
  const begun = performance.now()
  let done = 0
  let said = begun
  return (weight: number, name: string) => {
    done += weight
    const now = performance.now()
    const share = done / total
    const left = ((now - begun) * (1 - share)) / share / 1000
    const text = `${Math.round(100 * share)} %, about ${Math.round(left)} s left; ${name}`
    if (process.stderr.isTTY) process.stderr.write(`\r\x1b[K${share < 1 ? text : ''}`)
    else if (now - said > between) {
      said = now
      process.stderr.write(`${text}\n`)
    }
  }
}

/** The runs of each subject by seed. Those that are `fresh` are played though they are kept. */
export async function playAll(subjects: Subject[], child: string, worldFile: string, fresh: boolean) {
  const kept = openKept([child, worldFile])
  const parts = partsOf(subjects, (name, seed) => !fresh && kept.get(name, seed) !== undefined)
  const tell = progress(parts.reduce((all, { subject, seeds }) => all + seeds.length * subject.weight, 0))
  const work = async () => {
    const player = startPlayer(child, worldFile)
    for (let part = parts.shift(); part; part = parts.shift()) {
      const { subject, seeds } = part
      for (const [i, run] of (await player.take(part)).entries()) kept.add(subject.name, seeds[i], run)
      tell(seeds.length * subject.weight, subject.name)
    }
    player.end()
  }
  // Where all is known no process is started.
  await Promise.all(parts.slice(0, 2).map(work))
  return new Map(
    subjects.map(({ name, seeds }) => [
      name,
      Array.from({ length: seeds }, (_, i) => kept.get(name, i + 1)!),
    ]),
  )
}

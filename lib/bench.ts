import 'server-only'
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import type { BrowserResults } from '@/bench/browser/results'
import { ours, type Results } from '@/bench/report'

const read = (file: string) => JSON.parse(readFileSync(join(process.cwd(), 'bench/results', file), 'utf8'))

/** A processor's name as a page says it. */
const plain = (cpu: string) => cpu.replaceAll('(R)', '')

/** µs that the solver takes for a frame of 60 awake chips, from the committed benchmark, and the machine it ran on. */
export function costOf60(): { micros: number; cpu: string } {
  const { pourCosts, machine }: Results = read('results.json')
  const { cost } = pourCosts.find((row) => row.engine === ours && row.chips === 60)!
  return { micros: Math.round(cost!.mean), cpu: plain(machine.cpu) }
}

/** ms of script in a usual frame of a page with 60 chips, physics and all else, and the machine it ran on. */
export function scriptOf60(): { ms: number; cpu: string } {
  const { stages, machine }: BrowserResults = read('browser.json')
  const drop = stages[ours].drops.find(({ chips, throttle }) => chips === 60 && throttle === 1)!
  return { ms: drop.script.median, cpu: plain(machine.cpu) }
}

import 'server-only'
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { ours, type Results } from '@/bench/report'

/** µs that a frame of 60 awake chips takes, from the committed benchmark, and the machine it ran on. */
export function costOf60(): { micros: number; cpu: string } {
  const file = join(process.cwd(), 'bench/results/results.json')
  const { pourCosts, machine }: Results = JSON.parse(readFileSync(file, 'utf8'))
  const { cost } = pourCosts.find((row) => row.engine === ours && row.chips === 60)!
  return { micros: Math.round(cost!.mean), cpu: machine.cpu }
}

import 'server-only'
import { existsSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { ours, type Results } from '@/bench/report'

/** µs that a frame of 60 awake chips takes, from the committed benchmark, and the machine it ran on. */
export function costOf60(): { micros: number; cpu: string } | undefined {
  const file = join(process.cwd(), 'bench/results/results.json')
  if (!existsSync(file)) return
  const { pourCosts, machine }: Results = JSON.parse(readFileSync(file, 'utf8'))
  const cost = pourCosts.find((row) => row.engine === ours && row.chips === 60)?.cost
  return cost ? { micros: Math.round(cost.mean), cpu: machine.cpu } : undefined
}

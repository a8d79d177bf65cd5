import { execFileSync } from 'node:child_process'
import { beforeAll, describe, expect, it } from 'vitest'
import { hardScenes } from '../scenes/hard'
import { type HardRow, misses } from './hard-run'
import kept from './results/stability.json'
import { bundle, root } from './run-job'

const advice = 'npx tsx bench/stability.ts shows the figures; with --write the page shows them as well'

let rows: HardRow[]

// In a process of its own: what a test runner does to modules makes the solver ten times slower.
beforeAll(async () => {
  const options = { cwd: root, encoding: 'utf8', maxBuffer: 2 ** 24 } as const
  rows = JSON.parse(execFileSync(process.execPath, [await bundle('stability-child')], options))
}, 600_000)

describe('scenes that break solvers', () => {
  for (const { name, title, seeds } of hardScenes) {
    const known = misses(kept, name)
    const but = known.length > 0 ? `; the page says what it misses: ${known.join(', ')}` : ''
    it(`${title}, and every bound holds over ${seeds} seeds${but}`, () => {
      expect(misses(rows, name), advice).toEqual(known)
    })
  }

  it('are all on the page, with the bounds that they have', () => {
    const bounds = ({ scene, figure, bound }: HardRow) => ({ scene, figure, bound })
    expect(kept.map(bounds), advice).toEqual(rows.map(bounds))
  })
})

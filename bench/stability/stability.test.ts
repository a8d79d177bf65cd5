import { beforeAll, describe, expect, it } from 'vitest'
import { hardScenes } from '../../scenes/hard'
import kept from '../results/stability.json'
import { callInWorker } from '../worker/worker'
import { type HardRow, misses } from './play'

const advice = 'npx tsx bench/stability.ts shows the figures; with --write the page shows them as well'

let rows: HardRow[]

beforeAll(async () => {
  rows = await callInWorker('stability/play', 'allHardRows', [], 1500)
}, 1_600_000)

describe('scenes that break solvers', () => {
  for (const { name, title, seeds } of hardScenes) {
    const known = misses(kept, name)
    const but = known.length > 0 ? `; the page says what it misses: ${known.join(', ')}` : ''
    it(`${title}, and every bound holds over ${seeds} seeds${but}`, () => {
      expect(misses(rows, name), advice).toEqual(known)
    })
  }

  it('are all on the page, with the figures and bounds that they have', () => {
    // The solver's bits are the same everywhere, the last ones of what is measured on it need not be.
    const figures = (rows: HardRow[]) =>
      rows.map((row) => ({ ...row, value: row.value && Number(row.value.toPrecision(6)) }))
    expect(figures(kept), advice).toEqual(figures(rows))
  })
})

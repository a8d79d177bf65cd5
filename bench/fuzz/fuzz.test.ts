import { beforeAll, describe, expect, it } from 'vitest'
import { type Check, checks, foundScenes } from '../../scenes/fuzzed'
import { callInWorker } from '../worker/worker'
import known from './accepted.json'
import type { Misses } from './search'

const advice = 'npm run fuzz shows and keeps the scene; what is mended or known: npm run fuzz -- --accept'

let result: {
  asked: Partial<Record<Check, number>>
  misses: Partial<Record<Check, Misses>>
  failing: string[]
}

beforeAll(async () => {
  result = await callInWorker('fuzz/search', 'firstBlock', [], 250)
}, 300_000)

describe('in 2,000 random scenes', () => {
  const asked: Partial<Record<Check, number>> = known.asked
  const allowed: Partial<Record<Check, number>> = known.misses
  for (const [check, says] of Object.entries(checks) as [Check, string][]) {
    const but = allowed[check] ? `, but for ${allowed[check]} known` : ''
    it(`${says}, in the ${asked[check]} that it is asked of${but}`, () => {
      expect(result.asked[check], advice).toBe(asked[check])
      const { count, worst } = result.misses[check] ?? { count: 0, worst: 0 }
      expect(count, `worst ${worst}; ${advice}`).toBeLessThanOrEqual(allowed[check] ?? 0)
    })
  }
})

describe('a scene that once went wrong', () => {
  for (const { name, check, open } of foundScenes) {
    if (open) continue
    it(`holds: ${name}, ${checks[check]}`, () => {
      expect(result.failing).not.toContain(name)
    })
  }

  it('is open only while it goes wrong', () => {
    const open = foundScenes.filter((found) => found.open).map(({ name }) => name)
    expect(
      open.filter((name) => !result.failing.includes(name)),
      advice,
    ).toEqual([])
  })
})

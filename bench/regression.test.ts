import { beforeAll, describe, expect, it } from 'vitest'
import accepted from './bounds.json'
import { type Bounds, gated } from './gate'
import { printed } from './run-job'

const bounds: Bounds = accepted
const advice = 'if this is meant: npx tsx bench/accept.ts, and commit the difference'

let measured: Bounds

describe('the solver', () => {
  beforeAll(async () => {
    measured = await printed('gate-child', 250)
  }, 300_000)

  for (const { name, title } of gated) {
    it(`is no worse than it was, for the very work it took: ${title}`, () => {
      const bound = bounds[name]
      expect(bound, `${name} has no bounds yet; ${advice}`).toBeDefined()
      const { errors, work } = measured[name]
      expect(Object.keys(errors), `measures of ${name}; ${advice}`).toEqual(Object.keys(bound.errors))
      for (const [key, value] of Object.entries(errors)) {
        const most = bound.errors[key] as number
        expect(value ?? Number.POSITIVE_INFINITY, `${name}, ${key}; ${advice}`).toBeLessThanOrEqual(most)
      }
      expect(work, `work of ${name}; ${advice}`).toEqual(bound.work)
    })
  }
})

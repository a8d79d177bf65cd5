import { beforeAll, describe, expect, it } from 'vitest'
import { scenes } from '../../scenes'
import { callInWorker } from '../worker/worker'
import accepted from './bounds.json'
import type { Bounds } from './regression'

const bounds: Bounds = accepted
const advice = 'if this is meant: npx tsx bench/renew-bounds.ts, and commit the difference'

let measured: Bounds

describe('the solver', () => {
  beforeAll(async () => {
    measured = await callInWorker('accuracy/regression', 'measureAll', [], 250)
  }, 300_000)

  for (const { name, title } of scenes) {
    it(`is no worse than it was, for the very work it took: ${title}`, () => {
      const bound = bounds[name]
      expect(bound, `${name} has no bounds yet; ${advice}`).toBeDefined()
      const { errors, work } = measured[name]
      expect(Object.keys(errors), `measures of ${name}; ${advice}`).toEqual(Object.keys(bound.errors))
      for (const [key, value] of Object.entries(errors)) {
        // JSON has no infinity: what is lost comes as null.
        const error = value ?? Number.POSITIVE_INFINITY
        expect(error, `${name}, ${key}; ${advice}`).toBeLessThanOrEqual(bound.errors[key])
      }
      expect(work, `work of ${name}; ${advice}`).toEqual(bound.work)
    })
  }
})

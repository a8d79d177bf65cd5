// `npm run accept` runs as people call it, and a broken solver fails in it: each group meets its own fault.
import { execFile } from 'node:child_process'
import { join } from 'node:path'
import { promisify } from 'node:util'
import { afterEach, describe, expect, it, vi } from 'vitest'
import { FIRST_CHIP, SPIN, STATE, VX, X, Y } from '../../registry/gravity-stack/solver/state'
import type { World } from '../../registry/gravity-stack/world'
import { root } from '../build/root'
import { groups } from './groups'
import { holds, type Run } from './row'

type Fault = (state: Float64Array, step: number) => void

let fault: Fault | undefined
let restless = false

vi.mock(import('../../registry/gravity-stack/world'), async (load) => {
  const real = await load()
  return {
    ...real,
    createWorld(options) {
      const world: World = real.createWorld(options)
      const { step } = world
      let steps = 0
      return Object.create(world, {
        step: {
          value(seconds: number) {
            step(seconds)
            fault?.(world.scene.bodies.state, ++steps)
          },
        },
        resting: { get: () => world.resting && !restless },
      })
    },
  }
})

afterEach(() => {
  fault = undefined
  restless = false
})

/** Adds to a number of the first chip in a step, or from it on. */
const adds =
  (at: number, amount: number, from: number, to = from): Fault =>
  (state, step) => {
    if (step >= from && step <= to) state[FIRST_CHIP * STATE + at] += amount
  }

/** The first chip stands 300 px behind the pointer when it is let go. */
const losesHold: Fault = (state, step) => {
  if (step !== 30) return
  state[FIRST_CHIP * STATE + X] -= 300
  state[FIRST_CHIP * STATE + VX] = 0
}

/** The bounds that a subject misses, played from its first seed. */
async function missed(group: string, subject: string) {
  const { subjects, rows } = groups.find(({ name }) => name === group)!
  const one = subjects.find(({ name }) => name === subject)!
  const runs: Run[] = [await one.play(1)]
  return rows(new Map([[subject, runs]]))
    .filter((row) => !holds({ group, ...row }))
    .map(({ figure }) => figure)
}

const ever = Number.POSITIVE_INFINITY

describe('a bound is missed by', () => {
  const faults: [group: string, subject: string, figure: string, is: string, Fault?][] = [
    [
      'pours',
      'pour-pills-12',
      'peak overlap, worst',
      'a chip 3 px in the floor in one frame',
      adds(Y, 350, 3),
    ],
    ['pours', 'pour-pills-12', 'overlap at rest, worst', 'a chip moved into the wall', adds(X, -5, 1, ever)],
    ['pours', 'pour-badges-12', 'asleep, latest', 'chips that never sleep'],
    ['drops', 'drop-mixed-12', 'never asleep', 'chips that never sleep'],
    ['stages', 'stage-grown', 'asleep after', 'chips that never sleep'],
    ['knocks', 'thrown-at-a-row', 'no deeper than 1 px', 'a chip that goes through', adds(X, 60, 3)],
    ['tossed', 'bullets-at-a-plate', 'went through', 'a plate that jumps', adds(X, -500, 3)],
    ['held', 'throw', 'of the pointer’s speed, least', 'a hand that loses its chip', losesHold],
    ['stacks', 'mass-ratio', 'drift', 'half a pixel of creep', adds(X, 0.6, 100)],
    ['exact', 'slide', 'error', 'a tenth of a pixel', adds(X, 0.1, 90)],
    ['energy', 'energy-weightless', 'energy gained', 'a chip that sets out by itself', adds(VX, 3000, 30)],
    ['energy', 'energy-weightless', 'lost to NaN', 'a spin that is no number', adds(SPIN, Number.NaN, 5)],
  ]
  for (const [group, subject, figure, is, broken] of faults) {
    it(`${subject}, ${figure}: ${is}`, async () => {
      expect(await missed(group, subject)).not.toContain(figure)
      fault = broken
      restless = !broken
      expect(await missed(group, subject)).toContain(figure)
    })
  }
})

it('prints the table of what it is asked for, and says by its code whether all bounds hold', async () => {
  const tsx = join(root, 'node_modules/tsx/dist/cli.mjs')
  const args = [tsx, 'bench/accept.ts', '--seeds', '1', '--only', 'drop-pills-12,slide,work-12']
  const { stdout } = await promisify(execFile)(process.execPath, args, { cwd: root })
  for (const part of ['drop-pills-12', 'peak overlap, worst', 'slide', 'code run, minified'])
    expect(stdout).toContain(part)
  expect(stdout).toMatch(/(\d+) of \1 bounds hold/)
})

// Looks through random scenes, block by block: the same ones from the same seed.
import fc from 'fast-check'
import { type Check, type FuzzScene, foundScenes } from '../../scenes/fuzzed'
import { playFuzz } from './play'
import { anyScene } from './scenes'

/** Scenes that come from one seed. `npm test` plays the first block of seed 1. */
export const block = 2000

export type Misses = { count: number; worst: number }

const options = (seed: number, index: number, numRuns: number) => ({ seed: 1000 * seed + index, numRuns })

/** Of how many scenes of a block each check was asked, how often it failed, and by how much at worst. */
export function survey(seed: number, index: number, numRuns = block, only?: Check) {
  const asked: Partial<Record<Check, number>> = {}
  const misses: Partial<Record<Check, Misses>> = {}
  fc.assert(
    fc.property(anyScene, (scene) => {
      const made = new Set<Check>()
      const failure = playFuzz(scene, only, made)
      for (const check of made) asked[check] = 1 + (asked[check] ?? 0)
      if (!failure) return
      const known = misses[failure.check]
      misses[failure.check] = {
        count: 1 + (known?.count ?? 0),
        worst: Math.max(failure.value, known?.worst ?? 0),
      }
    }),
    options(seed, index, numRuns),
  )
  return { asked, misses }
}

/** The first scene of a block that fails a check, made as small as it goes: fewer chips, simpler numbers. */
export function smallest(check: Check, seed: number, index: number): FuzzScene | undefined {
  const fails = fc.property(anyScene, (scene) => playFuzz(scene, check) === undefined)
  return fc.check(fails, options(seed, index, block)).counterexample?.[0]
}

/** What the first block shows, and which of the scenes that once went wrong still do; for a worker. */
export function firstBlock() {
  const failing = foundScenes.filter(({ scene, check }) => playFuzz(scene, check)).map(({ name }) => name)
  return { ...survey(1, 0), failing }
}

import { energy, held, knocked, stages, tossed } from './moved'
import { exact, random, stacks } from './named'
import { drops, pours } from './pours'
import type { Group, Run } from './row'
import { shelves } from './shelves'
import { work } from './work'

/** All that runs from seeds, in the order of the table. */
export const groups: Group[] = [
  pours,
  drops,
  shelves,
  stages,
  knocked,
  tossed,
  held,
  stacks,
  exact,
  energy,
  random,
  work,
]

/** Plays a subject from so many seeds; for a worker. */
export async function playSubject(name: string, seeds: number[]) {
  const subject = groups.flatMap(({ subjects }) => subjects).find((one) => one.name === name)!
  const runs: Run[] = []
  for (const seed of seeds) runs.push(await subject.play(seed))
  return runs
}

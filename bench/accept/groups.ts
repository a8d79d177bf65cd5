import { energy, held, knocked, stages, tossed } from './moved'
import { exact, random, stacks } from './named'
import { drops, pours } from './pours'
import type { Group } from './row'
import { work } from './work'

/** All that runs from seeds, in the order of the table. */
export const groups: Group[] = [
  pours,
  drops,
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

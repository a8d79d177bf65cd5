// Pours 60 chips, then makes another world, with marks before and after. Run by world.test.ts with --trace-deopt, in a process of
// its own, where nothing else has shaped the compiled code.
import { writeSync } from 'node:fs'
import { pourChips } from '../../scenes/piles'
import { run, worldOf } from './testing'

const chips = pourChips('pills', 60, 1)
run(worldOf(chips).world, 20)
writeSync(1, '\n<another world>\n')
worldOf(chips)
writeSync(1, '\n</another world>\n')

// Pours 60 chips twice, makes another world, then pours the same chips again when all of these have gone, with marks between. Run by
// world.test.ts with --trace-deopt, --trace-opt and --expose-gc, in a process of its own, where nothing else has shaped the
// compiled code.
import { writeSync } from 'node:fs'
import { pourChips } from '../../scenes/piles'
import { run, worldOf } from './testing'

const chips = pourChips('pills', 60, 1)
const mark = (name: string) => writeSync(1, `\n<${name}>\n`)
const pour = () => run(worldOf(chips, { sleep: false }).world, 20)

pour()
// What is met late in a pour is compiled anew in the next.
pour()
mark('another world')
worldOf(chips)
mark('/another world')
globalThis.gc!()
pour()
mark('both gone')

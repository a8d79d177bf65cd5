// Pours 60 chips, makes another world, then pours the same chips again when the first two have gone, with
// marks between. Run by world.test.ts with --trace-deopt, --trace-opt and --expose-gc, in a process of its
// own, where nothing else has shaped the compiled code.
import { writeSync } from 'node:fs'
import { pourChips } from '../../../scenes/piles'
import { run, worldOf } from './worlds'

const chips = pourChips('pills', 60, 1)
const mark = (name: string) => writeSync(1, `\n<${name}>\n`)
const pour = () => run(worldOf(chips, { sleep: false }).world, 20)

pour()
mark('another world')
worldOf(chips)
mark('/another world')
globalThis.gc!()
pour()
mark('both gone')

// Prints how the solver bears the scenes that break solvers, each figure beside its bound.
//   npx tsx bench/stability.ts [--scene part,of,names] [--seeds 20] [--each] [--write]
//   npx tsx bench/stability.ts --scene seams --engine planck,rapier
// --each prints every seed. --write keeps stability.json and slides.json in bench/results.
// --engine plays the scenes in which a chip slides with other engines at their defaults, and prints how much
// slower it gets.
import { writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { parseArgs } from 'node:util'
import { type HardFigures, hardScenes, hardUnits } from '../scenes/hard'
import { root } from './build/root'
import { type HardRow, hardRows, holds, playHardScene } from './stability/play'
import { type SlideRow, slideRows, slideScenes, slidingEngines } from './stability/slides'

const { values: options } = parseArgs({
  options: {
    scene: { type: 'string' },
    seeds: { type: 'string', default: '20' },
    each: { type: 'boolean', default: false },
    write: { type: 'boolean', default: false },
    engine: { type: 'string' },
  },
})

if (options.write && (options.scene || options.each || options.seeds !== '20'))
  throw new Error('--write keeps the figures of every scene and seed: leave --scene, --seeds and --each out')
const wanted = options.scene?.split(',')
const scenes = hardScenes.filter(({ name }) => !wanted || wanted.some((part) => name.includes(part)))
if (scenes.length === 0) throw new Error(`No scene is named like ${options.scene}`)
if (options.engine) {
  for (const name of options.engine.split(','))
    for (const { engine, scene, slides, slowed, worst, bound } of await slideRows(
      name,
      scenes,
      Number(options.seeds),
    ))
      console.log(
        `${engine.padEnd(20)}${scene.padEnd(18)}${slowed} of ${slides} slowed by over ${bound} px/s, at worst ${worst}`,
      )
  process.exit(0)
}
let broken = 0
const kept: HardRow[] = []
console.log(`${'scene'.padEnd(28)}${'figure'.padEnd(16)}${'worst'.padStart(10)}${'bound'.padStart(9)}`)
for (const scene of scenes) {
  if (options.each) {
    for (let seed = 1; seed <= Math.min(scene.seeds, Number(options.seeds)); seed++) {
      console.log(seed, JSON.stringify(playHardScene(scene, seed)))
    }
    continue
  }
  for (const [i, row] of hardRows(scene, Number(options.seeds)).entries()) {
    const { figure, value, bound } = row
    const unit = hardUnits[figure as keyof HardFigures]
    if (!holds(row)) broken++
    kept.push(row)
    const shown = value === null ? 'never' : Number(value.toPrecision(3)).toString()
    console.log(
      `${(i === 0 ? scene.name : '').padEnd(28)}${figure.padEnd(16)}${shown.padStart(10)}${String(bound).padStart(9)} ${unit} ${holds(row) ? '✓' : '✗'}`,
    )
  }
}
if (options.write) {
  const keep = (file: string, rows: object[]) =>
    writeFileSync(join(root, 'bench/results', file), `${JSON.stringify(rows, null, 1)}\n`)
  keep('stability.json', kept)
  const slides: SlideRow[] = []
  for (const engine of slidingEngines) slides.push(...(await slideRows(engine, slideScenes, 20)))
  keep('slides.json', slides)
}
if (!options.each) console.log(broken === 0 ? '\nall hold' : `\n${broken} do not hold`)
process.exit(broken === 0 ? 0 : 1)

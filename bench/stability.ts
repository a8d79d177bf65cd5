// Prints how the solver bears the scenes that break solvers, each figure beside its bound.
//   npx tsx bench/stability.ts [--scene part,of,names] [--seeds 20] [--each] [--write]
// --each prints every seed; --write keeps the figures for the docs in bench/results/stability.json.
import { writeFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { parseArgs } from 'node:util'
import { type HardFigures, hardScenes, hardUnits } from '../scenes/hard'
import { type HardRow, hardRows, holds, playHardScene } from './hard-run'

const { values: options } = parseArgs({
  options: {
    scene: { type: 'string' },
    seeds: { type: 'string', default: '20' },
    each: { type: 'boolean', default: false },
    write: { type: 'boolean', default: false },
  },
})

if (options.write && (options.scene || options.each || options.seeds !== '20'))
  throw new Error('--write keeps the figures of every scene and seed: leave --scene, --seeds and --each out')
const wanted = options.scene?.split(',')
const scenes = hardScenes.filter(({ name }) => !wanted || wanted.some((part) => name.includes(part)))
if (scenes.length === 0) throw new Error(`No scene is named like ${options.scene}`)
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
  const file = fileURLToPath(new URL('./results/stability.json', import.meta.url))
  writeFileSync(file, `${JSON.stringify(kept, null, 1)}\n`)
}
if (!options.each) console.log(broken === 0 ? '\nall hold' : `\n${broken} do not hold`)
process.exit(broken === 0 ? 0 : 1)

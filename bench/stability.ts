// Prints how the solver bears the scenes that break solvers, each figure beside its bound.
//   npx tsx bench/stability.ts [--scene part,of,names] [--seeds 20] [--each] [--write]
// --each prints every seed; --write keeps the figures for the docs in bench/results/stability.json.
import { writeFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { parseArgs } from 'node:util'
import { type HardFigures, hardScenes, hardUnits } from '../scenes/hard'
import { hardFigures, playHardScene } from './hard-run'

/** A figure of a scene, the worst of its seeds; null is one without bound: never asleep. */
export type HardRow = { scene: string; figure: string; value: number | null; bound: number }

const { values: options } = parseArgs({
  options: {
    scene: { type: 'string' },
    seeds: { type: 'string', default: '20' },
    each: { type: 'boolean', default: false },
    write: { type: 'boolean', default: false },
  },
})

const wanted = options.scene?.split(',')
let broken = 0
const kept: HardRow[] = []
console.log(`${'scene'.padEnd(28)}${'figure'.padEnd(16)}${'worst'.padStart(10)}${'bound'.padStart(9)}`)
for (const scene of hardScenes) {
  if (wanted && !wanted.some((part) => scene.name.includes(part))) continue
  if (options.each) {
    for (let seed = 1; seed <= Math.min(scene.seeds, Number(options.seeds)); seed++) {
      console.log(seed, JSON.stringify(playHardScene(scene, seed)))
    }
    continue
  }
  const figures = hardFigures(scene, Number(options.seeds))
  Object.entries(scene.bounds).forEach(([name, bound], i) => {
    const value = figures[name as keyof HardFigures] ?? Number.NaN
    const holds = value <= bound
    if (!holds) broken++
    kept.push({ scene: scene.name, figure: name, value: Number.isFinite(value) ? value : null, bound })
    const shown = Number.isFinite(value) ? Number(value.toPrecision(3)).toString() : 'never'
    console.log(
      `${(i === 0 ? scene.name : '').padEnd(28)}${name.padEnd(16)}${shown.padStart(10)}${String(bound).padStart(9)} ${hardUnits[name as keyof HardFigures]} ${holds ? '✓' : '✗'}`,
    )
  })
}
if (options.write) {
  const file = fileURLToPath(new URL('./results/stability.json', import.meta.url))
  writeFileSync(file, `${JSON.stringify(kept, null, 1)}\n`)
}
console.log(broken === 0 ? '\nall hold' : `\n${broken} do not hold`)
process.exit(broken === 0 ? 0 : 1)

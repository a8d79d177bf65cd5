// Prints how the solver bears the scenes that break solvers, each figure beside its bound.
//   npx tsx bench/stability.ts [--scene part,of,names] [--seeds 20] [--each] [--write]
//   npx tsx bench/stability.ts --scene seams --engine planck,rapier
// --each prints every seed; --write keeps the figures for the docs in bench/results/stability.json.
// --engine plays the scenes in which a chip slides with other engines, at their defaults, and prints by how much it is slowed.
import { writeFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { parseArgs } from 'node:util'
import { type HardFigures, hardScenes, hardUnits } from '../scenes/hard'
import { simulateScene } from './accuracy/trajectory'
import { loadEngine } from './engines'
import { type HardRow, hardRows, holds, playHardScene, slowedBy } from './stability/play'

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
  for (const name of options.engine.split(',')) {
    const engine = await loadEngine(name)
    for (const scene of scenes) {
      const { slider } = scene
      if (slider === undefined) continue
      const slowed = Array.from({ length: Math.min(scene.seeds, Number(options.seeds)) }, (_, i) => {
        const known = { ...scene, measures: [], measure: () => [] }
        const { trajectory } = simulateScene(engine, known, engine.settings[0], i + 1)
        const frames = Array.from({ length: trajectory.frames }, (_, k) => k + 1)
        return Math.max(
          ...frames.map((k) => slowedBy(scene, trajectory.chips[slider], k, trajectory.state(k, slider).vx)),
        )
      })
      const bound = scene.bounds.slowed!
      const trips = slowed.filter((by) => by > bound).length
      const worst = Number(Math.max(...slowed).toPrecision(3))
      console.log(
        `${name.padEnd(20)}${scene.name.padEnd(18)}${trips} of ${slowed.length} slowed by over ${bound} px/s, at worst ${worst}`,
      )
    }
  }
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
  const file = fileURLToPath(new URL('./results/stability.json', import.meta.url))
  writeFileSync(file, `${JSON.stringify(kept, null, 1)}\n`)
}
if (!options.each) console.log(broken === 0 ? '\nall hold' : `\n${broken} do not hold`)
process.exit(broken === 0 ? 0 : 1)

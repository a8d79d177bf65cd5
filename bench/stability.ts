// Prints how the solver bears the scenes that break solvers, each figure beside its bound.
//   npx tsx bench/stability.ts [--scene part,of,names] [--seeds 20]
import { parseArgs } from 'node:util'
import { type HardFigures, hardScenes } from '../scenes/hard'
import { hardFigures, playHardScene } from './hard-run'

const { values: options } = parseArgs({
  options: {
    scene: { type: 'string' },
    seeds: { type: 'string', default: '20' },
    each: { type: 'boolean', default: false },
  },
})

const units: HardFigures | Record<string, string> = {
  lost: 'chips',
  outside: 'px',
  gain: 'of energy',
  loss: 'of energy',
  overlap: 'px',
  'overlap during': 'px',
  speed: 'px/s',
  drift: 'px',
  asleep: 's',
  hanging: 'chips',
  through: 'chips',
}
const wanted = options.scene?.split(',')
let broken = 0
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
    const shown = Number.isFinite(value) ? Number(value.toPrecision(3)).toString() : 'never'
    console.log(
      `${(i === 0 ? scene.name : '').padEnd(28)}${name.padEnd(16)}${shown.padStart(10)}${String(bound).padStart(9)} ${units[name as keyof typeof units]} ${holds ? '✓' : '✗'}`,
    )
  })
}
console.log(broken === 0 ? '\nall hold' : `\n${broken} do not hold`)
process.exit(broken === 0 ? 0 : 1)

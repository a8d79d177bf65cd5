// Prints microseconds per frame, all chips awake, beside another engine measured in the same run.
//   npx tsx bench/cost.ts [--engine ours] [--against box2d3-wasm-simd] [--chips 12,60] [--substeps 4,8]
//                         [--kind pills|badges|mixed] [--rounds 3] [--ms 800]
import { parseArgs } from 'node:util'
import type { Kind } from '../scenes/piles'
import { median } from './accuracy/trajectory'
import { bundleWorker } from './build/bundle'
import { loadEngine } from './engines'
import { settingName } from './engines/engine'
import { type Cost, medianCost, pourSeeds } from './speed/job'
import { runJob } from './speed/run-job'

const { values: options } = parseArgs({
  options: {
    engine: { type: 'string', default: 'ours' },
    against: { type: 'string', default: 'box2d3-wasm-simd' },
    chips: { type: 'string', default: '12,60,250,1000' },
    substeps: { type: 'string' },
    kind: { type: 'string', default: 'pills' },
    rounds: { type: 'string', default: '3' },
    /** of warming up */
    ms: { type: 'string', default: '800' },
  },
})

const worker = await bundleWorker('speed/measure', 'measure')
const reference = (await loadEngine(options.against)).settings[0]
const settings = options.substeps
  ? options.substeps.split(',').map((substeps) => ({ substeps: Number(substeps) }))
  : [(await loadEngine(options.engine)).settings[0]]

const phases = ['pour', 'settled', 'mean', 'p95', 'worst'] as const
const compared = ['pour', 'settled', 'mean'] as const
const heading = phases.map((name) => name.padStart(9)).join('')
const ratioHeading = compared.map((name) => name.padStart(9)).join('')
console.log(`${`µs per frame, ${options.kind}`.padEnd(43)}${heading}    ratio:${ratioHeading}`)

for (const chips of options.chips.split(',').map(Number)) {
  const variants = [
    { engine: options.against, setting: reference },
    ...settings.map((setting) => ({ engine: options.engine, setting })),
  ]
  const rounds: Cost[][] = variants.map(() => [])
  for (let round = 0; round < Number(options.rounds); round++) {
    for (const [i, variant] of variants.entries()) {
      const cost = await runJob(worker, {
        kind: 'pour cost',
        ...variant,
        chips,
        shape: options.kind as Kind,
        seeds: pourSeeds(chips),
        warmUp: Number(options.ms),
        patience: 60_000,
      })
      if (!cost || !('mean' in cost)) throw new Error(`${variant.engine} was given up with ${chips} chips`)
      rounds[i].push(cost)
    }
  }
  variants.forEach((variant, i) => {
    const cost = medianCost(rounds[i])
    const cells = phases.map((phase) => cost[phase].toFixed(1).padStart(9)).join('')
    // Ratios within a round, then their median: what slows the machine down slows both alike.
    const ratios = compared.map((phase) =>
      median(rounds[i].map((own, round) => own[phase] / rounds[0][round][phase]))
        .toFixed(2)
        .padStart(9),
    )
    const name = `${variant.engine} ${settingName(variant.setting)}`
    const label = `${String(chips).padStart(5)}  ${name.padEnd(36)}`
    console.log(`${label}${cells}${i === 0 ? '' : `          ${ratios.join('')}`}`)
  })
}
process.exit(0)

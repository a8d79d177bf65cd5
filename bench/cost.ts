// Prints microseconds per frame, all chips awake, beside another engine measured in the same run.
//   npx tsx bench/cost.ts [--engine ours] [--against box2d3-wasm-simd] [--chips 12,60,250,1000] [--substeps 4,8]
//                         [--kind pills|badges|mixed] [--rounds 3] [--ms 400]
import { parseArgs } from 'node:util'
import { bundleChild, type Contestant, type Cost, measureCost, medianCost } from './cost-runs'
import { settingName } from './engine'
import { loadEngine } from './engines'
import { median } from './film'

const { values: options } = parseArgs({
  options: {
    engine: { type: 'string', default: 'ours' },
    against: { type: 'string', default: 'box2d3-wasm-simd' },
    chips: { type: 'string', default: '12,60,250,1000' },
    substeps: { type: 'string' },
    kind: { type: 'string', default: 'pills' },
    rounds: { type: 'string', default: '3' },
    ms: { type: 'string', default: '400' },
  },
})

const child = await bundleChild()
const reference = (await loadEngine(options.against)).settings[0]
const settings = options.substeps
  ? options.substeps.split(',').map((substeps) => ({ substeps: Number(substeps) }))
  : [(await loadEngine(options.engine)).settings[0]]

const heading = ['pour', 'settled', 'mean', 'p95', 'worst'].map((name) => name.padStart(9)).join('')
const ratioHeading = ['pour', 'settled', 'mean'].map((name) => name.padStart(9)).join('')
console.log(`µs per frame, ${options.kind}, ${' '.repeat(18)}${heading}    ratio:${ratioHeading}`)

for (const chips of options.chips.split(',').map(Number)) {
  const contestants: Contestant[] = [
    { engine: options.against, setting: reference, chips, kind: options.kind },
    ...settings.map((setting) => ({ engine: options.engine, setting, chips, kind: options.kind })),
  ]
  const rounds: Cost[][] = contestants.map(() => [])
  for (let round = 0; round < Number(options.rounds); round++) {
    contestants.forEach((contestant, i) => {
      rounds[i].push(measureCost(child, contestant, Number(options.ms)))
    })
  }
  const costs = rounds.map(medianCost)
  contestants.forEach((contestant, i) => {
    const { pour, settled, mean, p95, worst } = costs[i]
    const cells = [pour, settled, mean, p95, worst].map((value) => value.toFixed(1).padStart(9)).join('')
    // Ratios within a round, then their median: what slows the machine down slows both alike.
    const ratio = (key: 'pour' | 'settled' | 'mean') =>
      median(rounds[i].map((cost, round) => cost[key] / rounds[0][round][key]))
    const ratios = (['pour', 'settled', 'mean'] as const).map((key) => ratio(key).toFixed(2).padStart(9))
    const name = `${contestant.engine} ${settingName(contestant.setting)}`
    const label = `${String(chips).padStart(5)}  ${name.padEnd(36)}`
    console.log(`${label}${cells}${i === 0 ? '' : `          ${ratios.join('')}`}`)
  })
}
process.exit(0)

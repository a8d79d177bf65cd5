// Prints the results of a benchmark, and writes them.
import { mkdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { type Engine, settingName } from '../engines/engine'
import { type Results, verdicts } from './report'

/** Three digits, or a power of ten where those would not do. */
export const short = (value: number | null | undefined) => {
  if (value === null || value === undefined) return '–'
  if (value === 0) return '0'
  if (!Number.isFinite(value)) return '∞'
  return value < 1e-3 || value >= 1e5 ? value.toExponential(1) : value.toPrecision(3)
}

/** Two tables: what a frame costs by chips, and who owns the frontier scene by scene. */
export function printResults(results: Results, engines: Engine[]) {
  const { machine, pourCosts } = results
  console.log(`\n${machine.cpu}, ${machine.cores} cores, Node ${machine.node}, ${results.date}`)
  const sizes = [...new Set(pourCosts.map(({ chips }) => chips))]
  if (sizes.length > 0) {
    console.log('\nµs per frame, all awake, mean of 4 s (p95)')
    console.log(`${''.padEnd(50)}${sizes.map((size) => `${size} chips`.padStart(18)).join('')}`)
    for (const engine of engines) {
      const settings = results.quick ? [engine.settings[0]] : [engine.settings[0], engine.accurate]
      for (const name of settings.map(settingName)) {
        const cells = sizes.map((size) => {
          const row = pourCosts.find(
            ({ engine: of, chips, setting }) =>
              of === engine.name && chips === size && settingName(setting) === name,
          )
          const bound = row?.atLeast ? `> ${short(row.atLeast)}` : '–'
          return (row?.cost ? `${short(row.cost.mean)} (${short(row.cost.p95)})` : bound).padStart(18)
        })
        console.log(`${`${engine.name}, ${name}`.padEnd(50)}${cells.join('')}`)
      }
    }
  }

  const table = verdicts(results)
  if (table.length === 0) return
  console.log('\nOur default against every peer at every setting')
  console.log(
    `${'scene'.padEnd(17)}${'measure'.padEnd(17)}${'error'.padStart(9)}${'µs'.padStart(9)}   ${'best peer as cheap'.padEnd(34)}${'cheapest peer as exact'.padEnd(34)}frontier`,
  )
  for (const { scene, measure, error, cost, asCheap, asExact, beaten, open } of table) {
    const cheap = asCheap ? `${asCheap.engine} ${short(asCheap.factor)}× the error` : 'none'
    const exact = asExact ? `${asExact.engine} ${short(asExact.factor)}× the cost` : 'none at any setting'
    const owner =
      beaten.length === 0 ? 'ours' : `beaten by ${[...new Set(beaten.map((p) => p.engine))].join(', ')}`
    const left = open.length > 0 ? `, ${open.length} settings open` : ''
    console.log(
      `${scene.name.padEnd(17)}${scene.measures[measure].name.padEnd(17)}${short(error).padStart(9)}${short(cost).padStart(9)}   ${cheap.padEnd(34)}${exact.padEnd(34)}${owner}${left}`,
    )
  }
}

const quote = (text: string) => `"${text}"`

/**
 * Writes all of it as JSON, errors and costs as CSV too. Every line of a CSV says what was measured, when and
 * where.
 */
export function writeResults(results: Results, folder: string) {
  mkdirSync(folder, { recursive: true })
  writeFileSync(join(folder, 'results.json'), `${JSON.stringify(results, null, 1)}\n`)
  const originHead = 'version,date,commit,machine'
  const { cpu, cores, memoryGB, system, node } = results.machine
  const where = quote(`${cpu}, ${cores} cores, ${memoryGB} GB, ${system}, Node ${node}`)
  const origin = (engine: string) => [quote(results.versions[engine]), results.date, results.commit, where]
  const write = (file: string, head: string, lines: string[]) =>
    writeFileSync(join(folder, file), `${[`${head},${originHead}`, ...lines].join('\n')}\n`)

  const errorLines = results.errors.flatMap((row) => {
    const scene = results.scenes.find((candidate) => candidate.name === row.scene)!
    const cost = results.sceneCosts.find(
      (other) =>
        other.engine === row.engine &&
        other.scene === row.scene &&
        settingName(other.setting) === settingName(row.setting),
    )
    return scene.measures.map((measure, i) =>
      [
        row.scene,
        quote(measure.name),
        measure.unit,
        measure.target ?? '',
        row.engine,
        quote(settingName(row.setting)),
        row.seeds,
        row.errors[i] ?? 'inf',
        cost?.cost.toFixed(3) ?? '',
        cost?.spread?.toFixed(3) ?? '',
        cost?.rounds ?? '',
        ...origin(row.engine),
      ].join(','),
    )
  })
  write(
    'errors.csv',
    'scene,measure,unit,target,engine,setting,seeds,error,us_per_frame,spread,rounds',
    errorLines,
  )

  const costLines = results.pourCosts.map((row) =>
    [
      row.engine,
      quote(settingName(row.setting)),
      row.chips,
      ...(['mean', 'pour', 'settled', 'p50', 'p95', 'worst'] as const).map(
        (key) => row.cost?.[key].toFixed(2) ?? '',
      ),
      row.spread?.toFixed(3) ?? '',
      row.rounds,
      row.atLeast?.toFixed(0) ?? '',
      quote(row.reason ?? ''),
      ...origin(row.engine),
    ].join(','),
  )
  write(
    'costs.csv',
    'engine,setting,chips,mean_us,pour_us,settled_us,p50_us,p95_us,worst_us,spread,rounds,at_least_us,reason',
    costLines,
  )
}

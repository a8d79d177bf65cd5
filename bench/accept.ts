// Everything that people can see of the solver, over many seeds, each figure beside its bound.
//   npm run accept                          the whole table, kept in bench/results/accept.json and accept.md
//   npm run accept -- --only pours,crammed  groups, or subjects whose names hold these words; keeps nothing
//   npm run accept -- --seeds 10            so many seeds of each subject; keeps nothing
//   npm run accept -- --against main~5      and what a frame costs beside the solver of that commit
//   npm run accept -- --only time --against main~5
//   npm run accept -- --solver main~5       the table of that commit's solver, kept as accept-before.json
//   npm run accept -- --fresh               plays again what it knows of this very solver from before
//   npm run accept -- --list                names of all groups and subjects
import { existsSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { parseArgs } from 'node:util'
import { groups } from './accept/groups'
import { playAll } from './accept/play'
import { holds, type Row } from './accept/row'
import { sizeRows } from './accept/size'
import { here, solverAt, worldScript } from './accept/solver'
import { markdown, printTable, printTimings, type Titled } from './accept/table'
import { isDearer, type Timing, timings } from './accept/time'
import { bundleWorker } from './build/bundle'
import { root } from './build/root'

const { values: options } = parseArgs({
  options: {
    only: { type: 'string' },
    seeds: { type: 'string' },
    against: { type: 'string' },
    solver: { type: 'string' },
    fresh: { type: 'boolean', default: false },
    list: { type: 'boolean', default: false },
  },
})

const size: Titled = { name: 'size', title: 'What there is to load and to read' }

if (options.list) {
  for (const { name, subjects } of groups)
    console.log(`${name}: ${subjects.map((one) => one.name).join(', ')}`)
  console.log('size\ntime')
  process.exit(0)
}

const begun = performance.now()
const wanted = options.only?.split(',')
const seeds = options.seeds === undefined ? undefined : Number(options.seeds)
if (seeds !== undefined && !(seeds >= 1)) throw new Error(`--seeds ${options.seeds} is no number of seeds`)
const isGroup = (word: string) => [...groups.map(({ name }) => name), 'size', 'time'].includes(word)
const isWanted = (group: string, subject = '') =>
  !wanted || wanted.some((word) => (isGroup(word) ? word === group : subject.includes(word)))
const chosen = groups.flatMap(({ name: group, subjects }) =>
  subjects
    .filter(({ name }) => isWanted(group, name))
    .map((one) => ({ ...one, seeds: one.seeds > 1 && seeds ? seeds : one.seeds })),
)
const wantsSize = isWanted(size.name)
const wantsTime = options.against !== undefined && isWanted('time')
if (chosen.length === 0 && !wantsSize && !wantsTime)
  throw new Error(`Nothing is named like ${options.only}; --list prints all names`)

const solver = options.solver ? solverAt(options.solver) : here()
const child = await bundleWorker(
  'accept/groups',
  'playSubject',
  options.solver && join(solver.dir, 'registry/gravity-stack/world.ts'),
)
const runs =
  chosen.length > 0
    ? await playAll(chosen, child, await worldScript(solver, 'iife'), options.fresh)
    : new Map()
for (const { name } of groups.flatMap(({ subjects }) => subjects))
  if (runs.get(name)?.length === 0) runs.delete(name)
const rows: Row[] = groups.flatMap((group) => group.rows(runs).map((row) => ({ group: group.name, ...row })))
if (wantsSize) rows.push(...(await sizeRows(solver)))

const results = join(root, 'bench/results')
type Kept = { commit?: string; rows: Row[] }
const beforeFile = join(results, 'accept-before.json')
const before: Kept = existsSync(beforeFile) ? JSON.parse(readFileSync(beforeFile, 'utf8')) : { rows: [] }
const titled = [...groups, size]
printTable(titled, rows, options.solver ? [] : before.rows)

let timed: Timing[] = []
if (wantsTime) {
  timed = await timings(solver, solverAt(options.against!))
  printTimings(timed)
}

const judged = rows.filter(({ bound }) => bound !== undefined)
const missed = judged.filter((row) => !holds(row))
const dear = timed.filter(isDearer)
const bounds = judged.length + timed.length
console.log(`\n${bounds - missed.length - dear.length} of ${bounds} bounds hold`)
for (const { what, figure } of missed) console.log(`  not: ${what}, ${figure}`)
for (const { count, phase } of dear) console.log(`  not: time of ${count} pills, ${phase}`)

if (!wanted && seeds === undefined) {
  const write = (name: string, text: string) => writeFileSync(join(results, name), text)
  const json = (kept: object) => `${JSON.stringify(kept, null, 1)}\n`
  if (options.solver) write('accept-before.json', json({ commit: solver.commit, rows }))
  else {
    write('accept.json', json({ rows }))
    write('accept.md', markdown(titled, rows, before.rows))
    // Times are another machine's affair: they stand apart, so that a change of the solver shows alone.
    if (wantsTime) write('accept-times.json', json({ against: options.against, timings: timed }))
  }
}
console.log(`${Math.round((performance.now() - begun) / 1000)} s`)
process.exit(missed.length + dear.length > 0 ? 1 : 0)

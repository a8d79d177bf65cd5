// Plays random scenes and looks for one in which something goes wrong that never may:
//   npm run fuzz [-- --scenes 2000 --seed 1 --from 0 --check asleep --dry --accept --write]
// The first failure of each check is shrunk to its smallest form and kept, named, in scenes/found.json, which
// the tests play.
// --from starts at a later block of 2,000, --check looks at one property only, --dry keeps nothing.
// --accept makes today's misses what the tests hold the solver to. --write keeps how many scenes failed in
// bench/results/fuzz.json, which the docs read.
import { readFileSync, writeFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { parseArgs } from 'node:util'
import { type Check, checks, type Found, fromJson, toJson } from '../scenes/fuzzed'
import { playFuzz } from './fuzz/play'
import { block, smallest, survey } from './fuzz/search'

const { values } = parseArgs({
  options: {
    scenes: { type: 'string', default: String(block) },
    seed: { type: 'string', default: '1' },
    from: { type: 'string', default: '0' },
    check: { type: 'string' },
    dry: { type: 'boolean', default: false },
    accept: { type: 'boolean', default: false },
    write: { type: 'boolean', default: false },
  },
})
const only = values.check as Check | undefined
if (only && !(only in checks))
  throw new Error(`no check "${only}"; there are ${Object.keys(checks).join(', ')}`)
const scenes = Number(values.scenes)
const seed = Number(values.seed)
const pathOf = (name: string) => fileURLToPath(new URL(name, import.meta.url))
const foundFile = pathOf('../scenes/found.json')
const load = (): Found[] => fromJson(readFileSync(foundFile, 'utf8'))

if (values.write && (only || values.seed !== '1' || values.from !== '0'))
  throw new Error(
    '--write keeps what the first scenes of seed 1 show of every check: leave --seed, --from and --check out',
  )
if (values.accept) {
  const { asked, misses } = survey(1, 0)
  const counts = Object.fromEntries(Object.entries(misses).map(([check, { count }]) => [check, count]))
  writeFileSync(pathOf('./fuzz/accepted.json'), `${toJson({ asked, misses: counts })}\n`)
  const found = load().map(({ name, check, scene }) => {
    const open = playFuzz(scene, check) !== undefined
    console.log(`${name}: ${open ? 'open' : 'holds'}`)
    return { name, check, ...(open ? { open } : {}), scene }
  })
  writeFileSync(foundFile, `${toJson(found)}\n`)
  console.log(`misses in the first ${block} scenes: ${JSON.stringify(counts)}`)
  process.exit(0)
}

const total = new Map<Check, number>()
const first = new Map<Check, number>()
for (let index = Number(values.from), played = 0; played < scenes; index++) {
  const numRuns = Math.min(block, scenes - played)
  const { misses } = survey(seed, index, numRuns, only)
  played += numRuns
  for (const [check, { count }] of Object.entries(misses) as [Check, { count: number }][]) {
    total.set(check, count + (total.get(check) ?? 0))
    if (!first.has(check)) first.set(check, index)
  }
  const list = Object.entries(misses).map(
    ([check, { count, worst }]) => `${check} ${count} (${worst.toPrecision(3)})`,
  )
  console.log(`block ${index}, ${played} of ${scenes}: ${list.join(', ') || 'all hold'}`)
}
for (const [check, count] of total) console.log(`${check}: ${count} of ${scenes}`)

if (values.write)
  writeFileSync(pathOf('./results/fuzz.json'), `${toJson({ scenes, misses: Object.fromEntries(total) })}\n`)

if (!values.dry) {
  const found = load()
  for (const [check, index] of first) {
    const scene = smallest(check, seed, index)
    if (!scene || found.some((other) => toJson(other.scene) === toJson(scene))) continue
    const name = `${check}-${1 + found.filter((other) => other.check === check).length}`
    found.push({ name, check, open: true, scene })
    console.log(`\n${name}, against “${checks[check]}”:\n${toJson(scene)}`)
  }
  writeFileSync(foundFile, `${toJson(found)}\n`)
}
process.exit(total.size > 0 ? 1 : 0)

// Run time against error, for every engine, setting and scene.
//   npm run bench                     everything; takes up where an interrupted run stopped
//   npm run bench -- --quick          two scenes, each engine as it comes, under a minute, writes nothing
//   npm run bench -- --scene pour,stack --engine ours,planck
//   npm run bench -- --errors         errors alone, which the next run keeps
//   npm run bench -- --out folder     writes there, parts too (the whole goes to bench/results)
//   npm run bench -- --minutes 5      stops after five; the next call goes on from there
//   npm run bench -- --fresh          forgets what was measured before
import { join } from 'node:path'
import { parseArgs } from 'node:util'
import { openErrorRuns } from './accuracy/error-runs'
import { root } from './build/root'
import { collect } from './publish/collect'
import { printResults, writeResults } from './publish/write'
import { enough, openPlan } from './speed/plan'
import { openTimes } from './speed/schedule'
import { openTimings } from './speed/timings'

const { values: options } = parseArgs({
  options: {
    scene: { type: 'string' },
    engine: { type: 'string' },
    quick: { type: 'boolean', default: false },
    errors: { type: 'boolean', default: false },
    out: { type: 'string' },
    minutes: { type: 'string', default: 'Infinity' },
    fresh: { type: 'boolean', default: false },
    rounds: { type: 'string', default: '3' },
  },
})

process.on('SIGINT', () => {
  console.error('\nstopped; the same command goes on from here')
  process.exit(130)
})

const plan = await openPlan({
  ...options,
  rounds: Number(options.rounds),
  deadline: performance.now() + 60_000 * Number(options.minutes),
})
const { quick, errors, rounds, deadline, engines, sizes, allScenes } = plan
const { outcomeOf, runAll, timing, complete } = plan.tasks
const timings = openTimings(plan)
const errorRuns = openErrorRuns(plan, timings)
const times = openTimes(plan, timings, errorRuns)

/** What is measured once for each engine. */
const singles = (kind: 'asleep' | 'allocation') =>
  quick || errors || !allScenes
    ? []
    : engines.map(({ name, settings }) => ({ kind, engine: name, setting: settings[0], chips: 60 }))

// First every engine and setting once, then the simulations that the claim needs, then the rest in the time
// left.
if (!errors) {
  await timing(async () => {
    await times.pours(sizes.filter((chips) => chips <= 1000))
    await times.scenes([0])
    await times.otherSettings()
  })
}
await errorRuns.play('errors', errorRuns.claimed(), singles('allocation'), deadline)

if (!errors) {
  await timing(async () => {
    await times.pours(sizes.filter((chips) => chips > 1000))
    await runAll('asleep', singles('asleep'), 1)
  })
  await errorRuns.play('errors of what costs more', errorRuns.all(), [], enough)
  await timing(async () => {
    if (rounds > 1) await times.scenes(Array.from({ length: rounds - 1 }, (_, i) => i + 1))
    if (!quick) await times.slowest()
  })
}
await errorRuns.play('errors, further', errorRuns.further, [], errors ? deadline : enough)
if (errors) process.exit(0)
// What later rounds have found to be no dearer after all.
await errorRuns.play('errors', errorRuns.claimed(), [], deadline)

const results = await collect(plan, timings, errorRuns, times.variants, (kind) =>
  Object.fromEntries(singles(kind).map((job) => [job.engine, outcomeOf(job)])),
)
printResults(results, engines)
if (options.out || (!quick && allScenes && !options.engine)) {
  const folder = options.out ?? join(root, 'bench/results')
  writeResults(results, folder)
  if (!options.out) complete()
  console.log(
    `\nwritten after ${results.minutes} minutes: results.json, errors.csv and costs.csv in ${folder}`,
  )
}
process.exit(0)

// The work of a frame, all awake: what the solver counts itself, and how much of its code runs, as V8 counts.
import { readFileSync } from 'node:fs'
import { type Profiler, Session } from 'node:inspector/promises'
import { setFlagsFromString } from 'node:v8'
import { Script } from 'node:vm'
import type { createWorld as CreateWorld } from '../../registry/gravity-stack/world'
import { aired } from '../../scenes/hard'
import { pourChips, pourStage } from '../../scenes/piles'
import { frame } from '../../scenes/scene'
import { figureOf, type Group, over, type Run, type Subject } from './row'

/** Frames of a pour that are counted, by what its chips do then. */
const phases = [
  { phase: 'landing', from: 0, to: 90 },
  { phase: 'settled', from: 180, to: 240 },
]
const counters = ['rows', 'hits', 'narrow', 'substeps']

/** The script that holds the world alone, as `accept.ts` hands it on. */
const worldFile = () => process.argv[2]

/** Characters of a script that have run, each as often as it did: of nested ranges the innermost counts. */
function charactersRun(functions: Profiler.FunctionCoverage[]) {
  const ranges = functions
    .flatMap(({ ranges }) => ranges)
    .sort((a, b) => a.startOffset - b.startOffset || b.endOffset - a.endOffset)
  let total = 0
  const open: Profiler.CoverageRange[] = []
  for (const range of ranges) {
    while (open.length > 0 && open[open.length - 1].endOffset <= range.startOffset) open.pop()
    const length = range.endOffset - range.startOffset
    total += range.count * length - (open.at(-1)?.count ?? 0) * length
    open.push(range)
  }
  return total
}

async function countWork(chips: number, seed: number): Promise<Run> {
  // Code that the optimizing compiler has inlined is not counted, and when it does so is chance.
  setFlagsFromString('--no-opt')
  setFlagsFromString('--no-maglev')
  const counted = await count(chips, seed)
  setFlagsFromString('--opt')
  return counted
}

async function count(chips: number, seed: number): Promise<Run> {
  const session = new Session()
  session.connect()
  await session.post('Profiler.enable')
  // Before the code is compiled: blocks compiled without counters are never counted.
  await session.post('Profiler.startPreciseCoverage', { callCount: true, detailed: true })
  // Each run has a script of its own: the same text would come from the cache, without counters.
  const filename = `world-${chips}-${seed}.js`
  const source = `${readFileSync(worldFile(), 'utf8')};world // ${filename}`
  const script = new Script(source, { filename })
  const { createWorld }: { createWorld: typeof CreateWorld } = script.runInThisContext()
  const world = createWorld({ ...pourStage(chips), ...aired, sleep: false })
  for (const chip of pourChips('pills', chips, seed)) world.add(chip)
  const counted: Run = {}
  for (let k = 0, p = 0; p < phases.length; k++) {
    const { phase, from, to } = phases[p]
    if (k === from) {
      await session.post('Profiler.takePreciseCoverage')
      for (const key of counters) counted[`${phase} ${key}`] = 0
    }
    world.step(frame)
    // A solver that counts nothing has these rows empty, and its code counted all the same.
    const stats: Record<string, number> = { ...world.stats }
    for (const key of counters) counted[`${phase} ${key}`] += (stats[key] ?? Number.NaN) / (to - from)
    if (k < to - 1) continue
    const { result } = await session.post('Profiler.takePreciseCoverage')
    const functions = result.filter(({ url }) => url === filename).flatMap((script) => script.functions)
    counted[`${phase} code`] = charactersRun(functions) / (to - from) / 1000
    p++
  }
  await session.post('Profiler.stopPreciseCoverage')
  session.disconnect()
  return counted
}

const seedsOf: Record<number, number> = { 12: 12, 60: 6, 250: 2, 1000: 1 }
const counts = Object.keys(seedsOf).map(Number)
const nameOf = (chips: number) => `work-${chips}`

export const work: Group = {
  name: 'work',
  title: 'Work a frame, all awake: in the first 1.5 s of a pour, and in its fourth second',
  subjects: counts.map(
    (chips): Subject => ({
      name: nameOf(chips),
      title: `${chips} pills`,
      seeds: seedsOf[chips],
      weight: 4 * chips,
      play: (seed) => countWork(chips, seed),
    }),
  ),
  rows: (runs) =>
    counts.flatMap((chips) => {
      const of = runs.get(nameOf(chips))
      if (!of) return []
      return phases.flatMap(({ phase }) => {
        const row = (figure: string, unit: string, key: string) =>
          figureOf(`${chips} pills ${phase}`, figure, unit, of, over.mean, `${phase} ${key}`)
        return [
          row('contacts visited by iterations', 'a frame', 'rows'),
          row('contacts visited for impacts', 'a frame', 'hits'),
          row('pairs measured', 'a frame', 'narrow'),
          row('sub-steps', 'a frame', 'substeps'),
          row('code run, minified', 'kB a frame', 'code'),
        ]
      })
    }),
}

// Times two worlds in turns, in one process.
import { pathToFileURL } from 'node:url'
import type { createWorld as CreateWorld } from '../../registry/gravity-stack/world'
import { aired } from '../../scenes/hard'
import { pourChips, pourStage } from '../../scenes/piles'
import { type Chip, frame } from '../../scenes/scene'
import { median } from '../accuracy/trajectory'
import type { Timing } from './time'

type Create = typeof CreateWorld

const frames = 240
/** Frames of a pour that count as landing, and from when on it counts as settled. */
const landing = 90
const settledFrom = 180
/** Rounds in which each world has a turn, by the number of chips. */
const rounds = new Map([
  [12, 60],
  [60, 32],
  [250, 13],
  [1000, 5],
])
/** ms that each world is warmed up for. */
const warm = 1500

/** µs of processor, as other programs may have it in between. */
function used(step: () => void) {
  const { user, system } = process.cpuUsage()
  step()
  const after = process.cpuUsage()
  return after.user + after.system - user - system
}

/** µs a frame, all awake. */
function pour(createWorld: Create, chips: Chip[]) {
  const world = createWorld({ ...pourStage(chips.length), ...aired, sleep: false })
  for (const chip of chips) world.add(chip)
  const play = (count: number) =>
    used(() => {
      for (let k = 0; k < count; k++) world.step(frame)
    })
  const first = play(landing)
  const between = play(settledFrom - landing)
  const last = play(frames - settledFrom)
  return {
    landing: first / landing,
    settled: last / (frames - settledFrom),
    'all four seconds': (first + between + last) / frames,
  }
}

/** Times the worlds of two scripts, the new one first, in landing, settled and whole pours. */
export async function timeWorlds(...files: string[]) {
  const worlds: Create[] = []
  for (const file of files) worlds.push((await import(pathToFileURL(file).href)).createWorld)
  const rows: Timing[] = []
  const few = pourChips('pills', 60, 101)
  for (const createWorld of worlds) {
    const begin = process.cpuUsage()
    while (process.cpuUsage(begin).user / 1000 < warm) pour(createWorld, few)
  }

  for (const [count, times] of rounds) {
    // What is learnt from a few chips is learnt again where there are many.
    for (const createWorld of worlds) pour(createWorld, pourChips('pills', count, 101))
    const measured = worlds.map((): ReturnType<typeof pour>[] => [])
    for (let round = 0; round < times; round++) {
      const chips = pourChips('pills', count, 1 + round)
      // Who goes first changes from round to round.
      for (const i of round % 2 ? [1, 0] : [0, 1]) measured[i].push(pour(worlds[i], chips))
    }
    for (const phase of ['landing', 'settled', 'all four seconds'] as const) {
      const [now, before] = measured.map((runs) => runs.map((run) => run[phase]))
      const ratios = now.map((value, round) => value / before[round]).sort((a, b) => a - b)
      const quartile = (q: number) => ratios[Math.round(q * (ratios.length - 1))]
      const ratio = { low: quartile(0.25), median: median(ratios), high: quartile(0.75) }
      rows.push({ count, phase, now: median(now), before: median(before), ratio })
    }
  }
  return rows
}

// Scenes with one right answer, stacks and masses, and random scenes.
import { exactScenes } from '../../scenes/exact'
import { type Check, checks } from '../../scenes/fuzzed'
import { hardScenes } from '../../scenes/hard'
import { pileScenes } from '../../scenes/piles'
import type { Scene } from '../../scenes/scene'
import { simulateScene } from '../accuracy/trajectory'
import { ours } from '../engines/ours'
import { block, survey } from '../fuzz/search'
import { playHardScene } from '../stability/play'
import { figureOf, type Group, over, type Run, type Subject } from './row'

function measured(scene: Scene): Run {
  const { trajectory } = simulateScene(ours, scene, {})
  const values = scene.measure(trajectory)
  return Object.fromEntries(scene.measures.map(({ name }, i) => [name, values[i]]))
}

const sceneSubject = (scene: Scene): Subject => ({
  name: scene.name,
  title: scene.title,
  seeds: 1,
  weight: 2 * scene.seconds,
  play: () => measured(scene),
})

/** Rows of a scene, each measure beside its target, or beside what `bounds` says instead. */
function sceneRows(scene: Scene, runs: Run[] | undefined, bounds: Record<string, number> = {}) {
  if (!runs) return []
  return scene.measures.map(({ name, unit, target }) => {
    const bound = bounds[name] ?? target
    return figureOf(scene.name, name, unit, runs, over.worst, name, bound === undefined ? {} : { bound })
  })
}

export const exact: Group = {
  name: 'exact',
  title: 'Single bodies, beside closed forms and ODEs',
  subjects: exactScenes.map(sceneSubject),
  rows: (runs) => exactScenes.flatMap((scene) => sceneRows(scene, runs.get(scene.name))),
}

const stackBounds: Record<string, Record<string, number>> = {
  'stack-10': { drift: 0.05 },
  'stack-20': { drift: 0.2 },
  pyramid: { drift: 0.05 },
  'mass-ratio': { overlap: 0.2 },
}
const stacked = pileScenes.filter(({ name }) => name in stackBounds)

const landing = hardScenes.find(({ name }) => name === 'heavy-on-light')!
const heavy: Subject = {
  name: landing.name,
  title: landing.title,
  seeds: 100,
  weight: 4,
  play: (seed) => ({ ...playHardScene(landing, seed) }),
}

export const stacks: Group = {
  name: 'stacks',
  title: 'Stacks stand, unequal masses stand and land',
  subjects: [...stacked.map(sceneSubject), heavy],
  rows(runs) {
    const of = runs.get(heavy.name)
    return [
      ...stacked.flatMap((scene) => sceneRows(scene, runs.get(scene.name), stackBounds[scene.name])),
      ...(of
        ? [
            figureOf(heavy.name, 'overlap at any time', 'px', of, over.worst, 'overlap during', { bound: 1 }),
            figureOf(heavy.name, 'overlap at the end', 'px', of, over.worst, 'overlap', { bound: 0.05 }),
            figureOf(heavy.name, 'asleep, latest', 's', of, over.worst, 'asleep'),
          ]
        : []),
    ]
  },
}

/** Of how many random scenes how many may go wrong. */
const wrongOf = { scenes: 100_000, allowed: 15 }

const fuzz: Subject = {
  name: 'random',
  title: `Random scenes, ${block} a seed: the same that npm run fuzz plays`,
  seeds: 3,
  weight: 16_000,
  play(seed) {
    const { misses } = survey(1, seed - 1)
    return Object.fromEntries(
      (Object.keys(checks) as Check[]).map((check) => [check, misses[check]?.count ?? 0]),
    )
  },
}

export const random: Group = {
  name: 'random',
  title: 'Random scenes',
  subjects: [fuzz],
  rows(runs) {
    const of = runs.get(fuzz.name)
    if (!of) return []
    const total = of.map((run) => ({ wrong: over.sum(Object.values(run)) }))
    const count = block * of.length
    const counted = (scenes: number) => `${scenes.toLocaleString('en')} random scenes`
    const never: Check[] = ['finite', 'outside', 'energy']
    const wrong = (what: string, runs: Run[], bound: number) =>
      figureOf(what, 'gone wrong', 'scenes', runs, over.sum, 'wrong', { bound })
    return [
      wrong(`the first ${counted(block)}`, total.slice(0, 1), 0),
      wrong(counted(count), total, Math.ceil((wrongOf.allowed * count) / wrongOf.scenes)),
      ...(Object.keys(checks) as Check[]).map((check) => {
        const bound = never.includes(check) ? { bound: 0 } : {}
        return figureOf(counted(count), `not so: ${checks[check]}`, 'scenes', of, over.sum, check, bound)
      }),
    ]
  },
}

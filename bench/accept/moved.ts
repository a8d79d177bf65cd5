// Stages and chips that change under a pile, chips that start in one another, chips that are thrown and held.
import { createWorld } from '../../registry/gravity-stack/world'
import { worstOverlap } from '../../scenes/exact-distance'
import { type HardFigures, type HardScene, hardScenes, hardUnits, hardWords } from '../../scenes/hard'
import { moves } from '../../scenes/moves'
import { frame } from '../../scenes/scene'
import { standing } from '../../scenes/standing'
import { knocks, type Throw, tossedAlone } from '../../scenes/throws'
import { playHard } from '../stability/play'
import { restBound } from './pours'
import { figureOf, type Group, over, type Row, type Run, type Subject } from './row'

const hardNamed = (name: string) => {
  const scene = hardScenes.find((one) => one.name === name)
  if (!scene) throw new Error(`There is no hard scene ${name}`)
  return scene
}

type Bounds = Partial<HardFigures>

/** A hard scene with bounds of its own. */
const hardSubject = (scene: HardScene, seeds: number, bounds: Bounds): Subject & { bounds: Bounds } => ({
  name: scene.name,
  title: scene.title,
  seeds,
  bounds,
  weight: 120,
  play: (seed) => ({ ...playHard({ ...scene, bounds }, seed).figures }),
})

/** The worst of each bounded figure, and how many runs sleep later than `bounds.asleep` or never. */
function hardRows({ name, bounds }: { name: string; bounds: Bounds }, runs: Run[] | undefined) {
  if (!runs) return []
  return (Object.entries(bounds) as [keyof HardFigures, number][]).map(([figure, bound]) => {
    // A figure without a finite bound is shown and not judged.
    const judged = Number.isFinite(bound) ? { bound } : {}
    return figureOf(name, hardWords[figure], hardUnits[figure], runs, over.worst, figure, judged)
  })
}

const shown = Number.POSITIVE_INFINITY
const afterwards = { lost: 0, overlap: restBound, asleep: 10, hanging: 0 }

const jammed = [
  hardSubject(hardNamed('crammed'), 480, { ...afterwards, outside: 1, speed: shown }),
  hardSubject(hardNamed('collapsed-and-back'), 40, afterwards),
  ...moves.map((scene) => hardSubject(scene, scene.seeds, { ...afterwards, 'overlap during': 1 })),
  hardSubject(hardNamed('pressed-by-a-wall'), 40, { ...afterwards, 'overlap during': 1 }),
  hardSubject(hardNamed('resized-every-frame'), 20, { ...afterwards, 'overlap during': shown }),
]

export const stages: Group = {
  name: 'stages',
  title: 'Crammed, narrowed, turned and collapsed stages, grown chips',
  subjects: jammed,
  rows: (runs) => jammed.flatMap((one) => hardRows(one, runs.get(one.name))),
}

/** Overlap at any time in the first second after the throw. */
function playThrow(scene: Throw, seed: number): Run {
  const chips = scene.build(seed)
  const world = createWorld({ width: scene.width, height: scene.height, ...scene.conditions })
  const ids = chips.map((chip) => world.add(chip))
  let deep = 0
  for (let k = 0; k < 60; k++) {
    world.step(frame)
    deep = worstOverlap(
      chips,
      ids.map((id) => world.read(id)),
      scene,
      deep,
    )
  }
  return { deep }
}

const thrownAt: Subject[] = knocks.map((scene) => ({
  name: scene.name,
  title: scene.title,
  seeds: scene.seeds,
  weight: 3,
  play: (seed) => playThrow(scene, seed),
}))

export const knocked: Group = {
  name: 'knocks',
  title: 'Chips struck at 1,200 to 3,000 px/s',
  subjects: thrownAt,
  rows: (runs) =>
    thrownAt.flatMap(({ name }) => {
      const of = runs.get(name)
      if (!of) return []
      return [
        figureOf(name, 'no deeper than 1 px', 'share', of, over.shareUpTo(1), 'deep', {
          bound: 0.99,
          atLeast: true,
        }),
        figureOf(name, 'overlap at any time, worst', 'px', of, over.worst, 'deep'),
      ]
    }),
}

/** Until it sleeps, or for 15 s. */
function playAlone(seed: number): Run {
  const chips = tossedAlone.build(seed)
  const world = createWorld({
    width: tossedAlone.width,
    height: tossedAlone.height,
    ...tossedAlone.conditions,
  })
  const ids = chips.map((chip) => world.add(chip))
  let frames = 0
  for (; frames < 900 && !world.resting; frames++) world.step(frame)
  const poses = ids.map((id) => world.read(id))
  return {
    standing: standing(chips, poses, tossedAlone),
    asleep: world.resting ? frames * frame : Number.POSITIVE_INFINITY,
    rest: worstOverlap(chips, poses, tossedAlone),
  }
}

const bullets = [
  hardSubject(hardNamed('bullets-at-a-plate'), 96, { lost: 0, through: 0, outside: 1, gain: 0.001 }),
  hardSubject(hardNamed('bullets-at-walls'), 60, { lost: 0, outside: 1, gain: 0.001 }),
]
const alone: Subject = {
  name: tossedAlone.name,
  title: tossedAlone.title,
  seeds: tossedAlone.seeds,
  weight: 1,
  play: playAlone,
}

export const tossed: Group = {
  name: 'tossed',
  title: 'Chips at 3,600 px/s, and chips tossed alone',
  subjects: [...bullets, alone],
  rows(runs) {
    const of = runs.get(alone.name)
    return [
      ...bullets.flatMap((one) => hardRows(one, runs.get(one.name))),
      ...(of
        ? [
            figureOf(alone.name, 'standing on one point', 'chips', of, over.sum, 'standing', { bound: 0 }),
            figureOf(alone.name, 'asleep, latest', 's', of, over.worst, 'asleep', { bound: 8 }),
            figureOf(alone.name, 'overlap at rest, worst', 'px', of, over.worst, 'rest', {
              bound: restBound,
            }),
          ]
        : []),
    ]
  },
}

const speeds = [200, 400, 800, 1200, 1600]
const rates = [30, 60, 120, 240]

/** Share of the pointer's speed that a thrown chip leaves with, at so many pointer events a second. */
function playToss(): Run {
  let least = Number.POSITIVE_INFINITY
  let most = 0
  for (const speed of speeds) {
    for (const rate of rates) {
      const world = createWorld({ width: 4000, height: 2000, gravity: 0 })
      const id = world.add({ width: 80, height: 30, radius: 15, x: 200, y: 100 })
      const grab = world.grab(id, 200, 100)
      for (let k = 1, event = 0; k <= 30; k++) {
        for (; event < k * frame * rate; event++) grab.moveTo(200 + (speed * event) / rate, 100, event / rate)
        world.step(frame)
      }
      grab.release()
      const share = world.read(id).vx / speed
      least = Math.min(least, share)
      most = Math.max(most, share)
    }
  }
  return { least, most }
}

const pressed = [
  hardSubject(hardNamed('dragged-through-everything'), 20, {
    ...afterwards,
    outside: 3,
    'overlap during': 3,
  }),
  hardSubject(hardNamed('pressed-into-the-pile'), 20, { ...afterwards, outside: 3, 'overlap during': 3 }),
]
const toss: Subject = {
  name: 'throw',
  title:
    'Share of the pointer’s speed that a chip leaves with, at 200 to 1,600 px/s and 30 to 240 events a second',
  seeds: 1,
  weight: 10,
  play: playToss,
}

export const held: Group = {
  name: 'held',
  title: 'Chips in a hand',
  subjects: [...pressed, toss],
  rows(runs) {
    const of = runs.get(toss.name)
    const shares: Omit<Row, 'group'>[] = of
      ? [
          figureOf(toss.name, 'of the pointer’s speed, least', 'share', of, over.least, 'least', {
            bound: 0.97,
            atLeast: true,
          }),
          figureOf(toss.name, 'of the pointer’s speed, most', 'share', of, over.worst, 'most', {
            bound: 1.03,
          }),
        ]
      : []
    return [...pressed.flatMap((one) => hardRows(one, runs.get(one.name))), ...shares]
  },
}

const elastic = hardNamed('elastic-crowd')

const crowd: Subject = {
  name: elastic.name,
  title: elastic.title,
  seeds: 20,
  weight: 500,
  play(seed) {
    const scene = { ...elastic, bounds: { lost: 0, gain: 0.001, loss: 1 } }
    const usual = playHard(scene, seed).figures
    const converged = playHard(scene, seed, undefined, 64).figures
    return { kept: (1 - usual.loss) / (1 - converged.loss), gain: usual.gain, lost: usual.lost }
  },
}

/** Hard scenes in which nothing puts energy in after the start. */
const closed = hardScenes.filter(({ bounds }) => bounds.gain !== undefined)
const energetic = closed.map((scene) =>
  hardSubject(scene, Math.min(scene.seeds, 10), { lost: 0, gain: 0.001, outside: 1 }),
)

export const energy: Group = {
  name: 'energy',
  title: 'Energy kept and never gained',
  subjects: [crowd, ...energetic.map((one) => ({ ...one, name: `energy-${one.name}` }))],
  rows(runs) {
    const of = runs.get(crowd.name)
    const all = energetic.flatMap(({ name }) => runs.get(`energy-${name}`) ?? [])
    const what = 'hard scenes that nothing disturbs'
    return [
      ...(of
        ? [
            figureOf(crowd.name, 'energy kept, of a converged run, least', 'share', of, over.least, 'kept', {
              bound: 0.7,
              atLeast: true,
            }),
            figureOf(crowd.name, 'energy kept, of a converged run, median', 'share', of, over.median, 'kept'),
            figureOf(crowd.name, 'energy gained', 'share', of, over.worst, 'gain', { bound: 0.001 }),
          ]
        : []),
      ...(all.length > 0
        ? [
            figureOf(what, 'energy gained', 'share', all, over.worst, 'gain', { bound: 0.001 }),
            figureOf(what, 'outside the stage', 'px', all, over.worst, 'outside', { bound: 1 }),
            figureOf(what, 'lost to NaN', 'chips', all, over.sum, 'lost', { bound: 0 }),
          ]
        : []),
    ]
  },
}

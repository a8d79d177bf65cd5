// Pours over three turned planks, as the example Shelves has them: obstacles are static bodies of the world.
import { createWorld } from '../../registry/gravity-stack/world'
import { chipDistance, worstOverlap } from '../../scenes/exact-distance'
import { aired } from '../../scenes/hard'
import { pourChips, pourStage } from '../../scenes/piles'
import { frame } from '../../scenes/scene'
import { restBound } from './pours'
import { figureOf, type Group, over, type Run } from './row'

/** s after which a pour counts as awake for ever. */
const forEver = 30
const counts = [12, 60]

function playShelves(count: number, seed: number): Run {
  const stage = pourStage(count)
  const { width, height } = stage
  const planks = [0.3, 0.55, 0.8].map((high, i) => ({
    width: 0.4 * width,
    height: 12,
    radius: 6,
    x: (i % 2 ? 0.72 : 0.28) * width,
    y: high * height,
    angle: i % 2 ? -0.2 : 0.2,
  }))
  const world = createWorld({ ...stage, ...aired })
  for (const plank of planks) world.add({ ...plank, density: Number.POSITIVE_INFINITY })
  const chips = pourChips('mixed', count, seed)
  const ids = chips.map((chip) => world.add(chip))
  const overlap = () => {
    const poses = ids.map((id) => world.read(id))
    const gaps = chips.flatMap((chip, i) => planks.map((plank) => chipDistance(chip, poses[i], plank, plank)))
    return Math.max(worstOverlap(chips, poses, stage), ...gaps.map((gap) => -gap))
  }
  let peak = 0
  let frames = 0
  for (; !world.resting && frames < forEver / frame; frames++) {
    world.step(frame)
    peak = Math.max(peak, overlap())
  }
  return { peak, rest: overlap(), asleep: world.resting ? frames * frame : Number.POSITIVE_INFINITY }
}

export const shelves: Group = {
  name: 'shelves',
  title: 'All chips released at once over three turned planks',
  subjects: counts.map((count) => ({
    name: `shelves-mixed-${count}`,
    title: `${count} mixed chips over shelves`,
    seeds: 40,
    weight: count ** 1.15,
    play: (seed) => playShelves(count, seed),
  })),
  rows: (runsOf) =>
    counts.flatMap((count) => {
      const name = `shelves-mixed-${count}`
      const runs = runsOf.get(name)
      if (!runs) return []
      return [
        figureOf(name, 'peak overlap, median', 'px', runs, over.median, 'peak', { bound: 1 }),
        figureOf(name, 'peak overlap, worst', 'px', runs, over.worst, 'peak', { bound: 2 }),
        figureOf(name, 'overlap at rest, worst', 'px', runs, over.worst, 'rest', { bound: restBound }),
        figureOf(name, 'asleep, latest', 's', runs, over.worst, 'asleep', { bound: 8 }),
      ]
    }),
}

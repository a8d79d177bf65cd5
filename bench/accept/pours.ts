// Pours with the drag and sleep of a page: all chips at once, or one by one as the stage releases them.
import type { Box } from '../../registry/gravity-stack/solver/input'
import { reach, releasePose, releaseTime } from '../../registry/gravity-stack/stage/release'
import { createWorld } from '../../registry/gravity-stack/world'
import { worstOverlap } from '../../scenes/exact-distance'
import { aired } from '../../scenes/hard'
import { type Kind, kinds, pourChips, pourStage } from '../../scenes/piles'
import { type Chip, frame } from '../../scenes/scene'
import { standing } from '../../scenes/standing'
import { figureOf, type Group, over, type Run, type Subject } from './row'

/** s after which a pour counts as awake for ever. */
const forEver = 30
/** s between two releases, the component's default. */
const stagger = 0.15

type World = ReturnType<typeof createWorld>
type Stage = { width: number; height: number }

/** Plays until all sleep. `release` adds what is due before a frame and tells whether more is to come. */
function play(
  world: World,
  stage: Stage,
  shapes: Chip[],
  ids: number[],
  release: (frame: number) => boolean,
): Run {
  let peak = 0
  let last = 0
  let frames = 0
  const poses = () => ids.map((id) => world.read(id))
  for (let waiting = true; waiting || (!world.resting && frames - last < forEver / frame); ) {
    waiting = release(frames)
    if (waiting) last = frames + 1
    world.step(frame)
    frames++
    peak = worstOverlap(shapes.slice(0, ids.length), poses(), stage, peak)
    if (peak === Number.POSITIVE_INFINITY) break
  }
  return {
    peak,
    rest: worstOverlap(shapes, poses(), stage),
    asleep: world.resting ? (frames - last) * frame : Number.POSITIVE_INFINITY,
    standing: standing(shapes, poses(), stage),
  }
}

function playPour(kind: Kind, count: number, seed: number): Run {
  const stage = pourStage(count)
  const world = createWorld({ ...stage, ...aired })
  const chips = pourChips(kind, count, seed)
  const ids = chips.map((chip) => world.add(chip))
  return play(world, stage, chips, ids, () => false)
}

/** The stage's own schedule: `release.ts` says when and where each chip starts. The seed makes the shapes. */
function playDrop(kind: Kind, count: number, seed: number): Run {
  const stage = pourStage(count)
  const world = createWorld({ ...stage, ...aired })
  const shapes = pourChips(kind, count, seed)
  const ids: number[] = []
  return play(world, stage, shapes, ids, (frames) => {
    while (ids.length < count && releaseTime(ids.length, ids.length * stagger) <= frames * frame) {
      const { width, height, radius } = shapes[ids.length]
      const taken = ids.flatMap((id, i): Box[] => {
        const { x, y } = world.read(id)
        const far = reach(shapes[i].width, shapes[i].height)
        return y < far ? [[x - far, y - far, x + far, y + far]] : []
      })
      const pose = releasePose(ids.length, width, height, stage.width, aired.gravity, taken)
      ids.push(world.add({ width, height, radius, ...pose }))
    }
    return ids.length < count
  })
}

/** px: the worst overlap while so many chips land, in the median and at worst. */
function peaks(count: number) {
  if (count <= 60) return { median: 1, worst: 2 }
  return count <= 300 ? { median: 2, worst: 4 } : { median: 3, worst: 6 }
}
/** px of overlap at rest. */
export const restBound = 0.05
/** s until all sleep, in so large a share of the pours of up to so many chips, and at worst. */
const sleep = { seconds: 4, share: 0.995, latest: 8, upTo: 300 }

const seedsOf: Record<number, number> = { 12: 100, 60: 100, 250: 12, 300: 40, 1000: 4 }
const sizes = Object.keys(seedsOf).map(Number)

const subject = (
  name: string,
  title: string,
  count: number,
  seeds: number,
  playOne: (seed: number) => Run,
): Subject => ({
  name,
  title,
  seeds,
  weight: count ** 1.15,
  play: playOne,
})

const namesOf = (prefix: string, counts: number[]) =>
  counts.flatMap((count) => kinds.map((kind) => ({ kind, count, name: `${prefix}-${kind}-${count}` })))

function rowsOf(named: { name: string; count: number }[], runsOf: Map<string, Run[]>, all: string) {
  const rows = named.flatMap(({ name, count }) => {
    const runs = runsOf.get(name)
    if (!runs) return []
    const peak = peaks(count)
    return [
      figureOf(name, 'peak overlap, median', 'px', runs, over.median, 'peak', { bound: peak.median }),
      figureOf(name, 'peak overlap, worst', 'px', runs, over.worst, 'peak', { bound: peak.worst }),
      figureOf(name, 'overlap at rest, worst', 'px', runs, over.worst, 'rest', { bound: restBound }),
      figureOf(name, 'asleep, median', 's', runs, over.median, 'asleep'),
      figureOf(
        name,
        'asleep, latest',
        's',
        runs,
        over.worst,
        'asleep',
        count <= sleep.upTo ? { bound: sleep.latest } : {},
      ),
      figureOf(name, 'standing on one point', 'chips', runs, over.sum, 'standing', { bound: 0 }),
    ]
  })
  const pooled = named.flatMap(({ name, count }) => (count <= sleep.upTo ? (runsOf.get(name) ?? []) : []))
  const every = named.flatMap(({ name }) => runsOf.get(name) ?? [])
  if (every.length === 0) return []
  const share = { bound: sleep.share, atLeast: true as const }
  return [
    ...rows,
    ...(pooled.length > 0
      ? [
          figureOf(
            all,
            `asleep within ${sleep.seconds} s, of up to ${sleep.upTo} chips`,
            'share',
            pooled,
            over.shareUpTo(sleep.seconds),
            'asleep',
            share,
          ),
          figureOf(
            all,
            `asleep within ${sleep.latest} s, of up to ${sleep.upTo} chips`,
            'share',
            pooled,
            over.shareUpTo(sleep.latest),
            'asleep',
            { bound: 1, atLeast: true },
          ),
        ]
      : []),
    figureOf(all, 'never asleep', 'pours', every, over.countOver(forEver), 'asleep', { bound: 0 }),
  ]
}

const poured = namesOf('pour', sizes)
const dropped = namesOf('drop', [12, 60])

export const pours: Group = {
  name: 'pours',
  title: 'All chips released at once',
  subjects: poured.map(({ kind, count, name }) =>
    subject(name, `${count} ${kind} poured`, count, seedsOf[count], (seed) => playPour(kind, count, seed)),
  ),
  rows: (runs) => rowsOf(poured, runs, 'all pours'),
}

export const drops: Group = {
  name: 'drops',
  title: 'Chips released one after another, as the stage does; asleep after the last release',
  subjects: dropped.map(({ kind, count, name }) =>
    subject(name, `${count} ${kind} dropped`, count, count === 12 ? 200 : 20, (seed) =>
      playDrop(kind, count, seed),
    ),
  ),
  rows: (runs) => rowsOf(dropped, runs, 'all drops'),
}

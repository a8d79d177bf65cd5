// Scenes without one right answer: piles are chaotic, so they are judged by what any right answer has.
import { chipDistance, halfExtent } from './exact-distance'
import { contactResidual } from './residual'
import { type Chip, conditions, type Scene, type Trajectory } from './scene'
import { seeded } from './seeded'

function stack(count: number, target: number): Scene {
  const tall = 40
  const height = Math.max(340, count * tall + 60)
  return {
    name: `stack-${count}`,
    title: `${count} boxes stand on each other for 30 s`,
    width: 640,
    height,
    seconds: 30,
    conditions,
    seeds: 1,
    build: () =>
      Array.from({ length: count }, (_, i) => ({
        width: 2 * tall,
        height: tall,
        x: 320,
        y: height - tall * (i + 0.5),
        angle: 0,
      })),
    measures: [{ name: 'drift', unit: 'px', target }],
    measure: (trajectory) => [trajectory.drift()],
  }
}

const pyramid: Scene = {
  name: 'pyramid',
  title: 'A pyramid of ten rows stands for 10 s',
  width: 640,
  height: 460,
  seconds: 10,
  conditions,
  seeds: 1,
  build() {
    const chips: Chip[] = []
    for (let row = 0; row < 10; row++) {
      for (let i = 0; i < 10 - row; i++) {
        const x = 320 + (i - (9 - row) / 2) * 48
        chips.push({ width: 40, height: 40, x, y: 460 - 40 * (row + 0.5), angle: 0 })
      }
    }
    return chips
  },
  measures: [{ name: 'drift', unit: 'px', target: 0.05 }],
  measure: (trajectory) => [trajectory.drift()],
}

const massRatio: Scene = {
  name: 'mass-ratio',
  title: 'A chip rests on two that weigh a four-hundredth of it',
  width: 640,
  height: 340,
  seconds: 5,
  conditions,
  seeds: 1,
  build: () => [
    { width: 30, height: 30, x: 260, y: 325, angle: 0 },
    { width: 30, height: 30, x: 380, y: 325, angle: 0 },
    { width: 200, height: 100, x: 320, y: 260, angle: 0, density: 18 },
  ],
  measures: [
    { name: 'overlap', unit: 'px', target: 0.2 },
    { name: 'drift', unit: 'px', target: 0.5 },
  ],
  measure: (trajectory) => [trajectory.worstOverlap(), trajectory.drift()],
}

export const kinds = ['pills', 'badges', 'mixed', 'discs', 'words'] as const
export type Kind = (typeof kinds)[number]

/**
 * One chip of a pour: a label pill 28 px high, a badge with rounded corners, a disc, a bare word, which is a
 * box with square corners, or one of many shapes.
 */
function pourChip(kind: Kind, random: () => number): { width: number; height: number; radius: number } {
  const size = random()
  const pill = { width: 56 + 56 * size, height: 28, radius: 14 }
  const badge = { width: 36 + 60 * size, height: 30 + 14 * random(), radius: 8 }
  if (kind === 'pills') return pill
  if (kind === 'badges') return badge
  if (kind === 'discs') return { width: 28 + 24 * size, height: 28 + 24 * size, radius: 14 + 12 * size }
  if (kind === 'words') return { width: 54 + 56 * size, height: 24, radius: 0 }
  const pick = random()
  if (pick < 0.3) return pill
  if (pick < 0.55) return badge
  if (pick < 0.75) return { width: 28 + 24 * size, height: 28 + 24 * size, radius: 14 + 12 * size }
  if (pick < 0.9) return { width: 30 + 50 * size, height: 28, radius: 0 }
  return { width: 28, height: 40 + 40 * size, radius: 6 }
}

/** The stage that `count` chips fill as 60 of them fill 640 × 340 px. */
export function pourStage(count: number) {
  const scale = Math.sqrt(count / 60)
  return { width: Math.round(640 * scale), height: Math.round(340 * scale) }
}

/** Spreads chips over the width by the golden ratio, each as low above the stage as the others allow. */
export function pourChips(kind: Kind, count: number, seed: number): Chip[] {
  const random = seeded(seed)
  const { width } = pourStage(count)
  const chips: Chip[] = []
  const columns: Chip[][] = []
  const start = random()
  for (let i = 0; i < count; i++) {
    const shape = pourChip(kind, random)
    const angle = 0.5 * (random() - 0.5)
    const [half, tall] = halfExtent(shape, angle)
    const golden = (start + i * 0.618033988749895 + 0.08 * (random() - 0.5) + 1) % 1
    const chip = {
      ...shape,
      x: half + 2 + golden * (width - 2 * half - 4),
      y: -24 - tall,
      angle,
      vx: 80 * (random() - 0.5),
      vy: 0,
      spin: 2.4 * (random() - 0.5),
    }
    const column = Math.floor(chip.x / 160)
    const near = [column - 1, column, column + 1]
      .flatMap((k) => columns[k] ?? [])
      .filter((other) => Math.abs(other.x - chip.x) < (other.width + chip.width) / 2 + 8)
    const lacking = () => {
      for (const other of near) {
        if (Math.abs(other.y - chip.y) >= 160) continue
        const distance = chipDistance(chip, chip, other, other)
        if (distance < 3) return 3 - distance
      }
      return 0
    }
    // A climb lengthens no distance by more than itself: what lacks 20 px needs no look before 20 px.
    for (let gap = lacking(); gap > 0; gap = lacking()) for (; gap > 0; gap -= 4) chip.y -= 4
    columns[column] ??= []
    columns[column].push(chip)
    chips.push(chip)
  }
  return chips
}

export const pourTitles: Record<Kind, string> = {
  pills: 'pills',
  badges: 'rounded boxes',
  mixed: 'chips of every shape',
  discs: 'discs',
  words: 'words with square corners',
}

/** The measure that tells a run of one seed nothing: it is then the time to rest. */
export const slowest = 'slowest to rest'

type PourTargets = { rest: number; during: number; time?: number; slowest?: number }

function pour(kind: Kind, count: number, seconds: number, seeds: number, targets: PourTargets): Scene {
  return {
    name: `pour-${kind}-${count}`,
    title: `${count} ${pourTitles[kind]} poured, all released at once`,
    ...pourStage(count),
    seconds,
    conditions,
    seeds,
    build: (seed) => pourChips(kind, count, seed),
    measures: [
      { name: 'overlap at rest', unit: 'px', target: targets.rest, over: 'worst' },
      { name: 'overlap during', unit: 'px', target: targets.during, over: 'median' },
      { name: 'time to rest', unit: 's', target: targets.time, over: 'median', ranked: false },
      { name: slowest, unit: 's', target: targets.slowest, over: 'worst', ranked: false },
      ...(count === 60 ? [{ name: 'contact residual', unit: 'weights', over: 'median' as const }] : []),
    ],
    measure(trajectory: Trajectory) {
      const time = trajectory.timeToRest()
      const errors = [trajectory.overlap(trajectory.frames), trajectory.worstOverlap(), time, time]
      return count === 60 ? [...errors, contactResidual(trajectory, trajectory.frames)] : errors
    },
  }
}

const calm = { time: 1.9, slowest: 3 }

export const pileScenes: Scene[] = [
  stack(10, 0.05),
  stack(20, 0.15),
  pyramid,
  massRatio,
  pour('pills', 12, 5, 12, { rest: 0.03, during: 1, ...calm }),
  pour('pills', 60, 6, 12, { rest: 0.03, during: 1, ...calm }),
  pour('badges', 60, 6, 12, { rest: 0.05, during: 1.5, ...calm }),
  pour('mixed', 60, 6, 12, { rest: 0.05, during: 1.5, ...calm }),
  pour('pills', 250, 8, 3, { rest: 0.05, during: 1.5 }),
  pour('pills', 1000, 12, 1, { rest: 0.05, during: 2 }),
]

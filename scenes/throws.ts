// Chips thrown at other chips, and chips tossed alone: one short scene a seed.
import { chipDistance, halfExtent } from './exact-distance'
import { aired, onGrid } from './hard'
import { type Chip, type Conditions, conditions } from './scene'
import { seeded } from './seeded'

export type Throw = {
  name: string
  title: string
  width: number
  height: number
  conditions: Conditions
  seeds: number
  build(seed: number): Chip[]
}

const within = (random: () => number, least: number, most: number) => least + (most - least) * random()

/** A label pill, a card or a box. */
function anyChip(random: () => number) {
  const pick = random()
  if (pick < 0.4) return { width: within(random, 56, 112), height: 28, radius: 14 }
  if (pick < 0.7) return { width: within(random, 36, 96), height: within(random, 30, 44), radius: 8 }
  return { width: within(random, 30, 80), height: 28, radius: 0 }
}

/** px/s of what is thrown. */
const speed = (random: () => number) => within(random, 1200, 3000)

const inRow: Throw = {
  name: 'thrown-at-a-row',
  title: 'A chip is thrown along the floor at one that has others 1 to 59 px behind it',
  width: 1600,
  height: 340,
  conditions: aired,
  seeds: 480,
  build(seed) {
    const random = seeded(seed)
    const row: Chip[] = []
    let left = 800
    const count = 2 + Math.floor(3 * random())
    for (let i = 0; i < count; i++) {
      const shape = anyChip(random)
      row.push({ ...shape, x: left + shape.width / 2, y: 340 - shape.height / 2, angle: 0 })
      left += shape.width + within(random, 1, 59)
    }
    const shape = anyChip(random)
    const angle = within(random, -0.4, 0.4)
    const [half, tall] = halfExtent(shape, angle)
    const thrown = {
      ...shape,
      x: 800 - half - within(random, 2, 120),
      y: 340 - tall - within(random, 0.5, 12),
      angle,
      vx: speed(random),
      spin: within(random, -10, 10),
    }
    // Whoever was added first, the same has to come of it.
    return seed % 2 ? [thrown, ...row] : [...row, thrown]
  },
}

const fromAnySide: Throw = {
  name: 'thrown-at-a-group',
  title: 'A chip is thrown at four that float near each other, from any side',
  width: 1600,
  height: 1200,
  conditions: { ...conditions, gravity: 0 },
  seeds: 480,
  build(seed) {
    const random = seeded(seed)
    const chips: Chip[] = []
    while (chips.length < 4) {
      const chip = {
        ...anyChip(random),
        x: within(random, 700, 900),
        y: within(random, 500, 700),
        angle: within(random, -3, 3),
      }
      if (chips.every((other) => chipDistance(chip, chip, other, other) > 1)) chips.push(chip)
    }
    const way = within(random, 0, 2 * Math.PI)
    const fast = speed(random)
    const thrown: Chip = {
      ...anyChip(random),
      x: onGrid(800 - 320 * Math.cos(way)),
      y: onGrid(600 - 320 * Math.sin(way)),
      angle: within(random, -3, 3),
      vx: onGrid(fast * Math.cos(way)),
      vy: onGrid(fast * Math.sin(way)),
      spin: within(random, -10, 10),
    }
    return seed % 2 ? [thrown, ...chips] : [...chips, thrown]
  },
}

/** How deep what is struck goes into what lies behind it. */
export const knocks: Throw[] = [inRow, fromAnySide]

/** Where a chip comes to rest that nothing but the floor and the walls meet. */
export const tossedAlone: Throw = {
  name: 'tossed-alone',
  title: 'A badge or a box is tossed into an empty stage',
  width: 640,
  height: 340,
  conditions: aired,
  seeds: 1500,
  build(seed) {
    const random = seeded(seed)
    const radius = seed % 2 ? 8 : 0
    return [
      {
        width: within(random, 30, 110),
        height: within(random, 20, 44),
        radius,
        x: 320,
        y: 120,
        angle: within(random, -3, 3),
        vx: within(random, -800, 800),
        vy: within(random, -800, 200),
        spin: within(random, -15, 15),
      },
    ]
  },
}

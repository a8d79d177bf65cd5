// Scenes that break solvers: nothing may explode, sink, hang, leak out or stay awake. Run with sleep, as on a
// page. A bound left out is one that the scene makes senseless: work done by a hand or a wall is no energy
// gained, and chips that start in one another are lifted by what parts them.
import { halfExtent } from './exact-distance'
import { pourChips } from './piles'
import { type Chip, type Conditions, conditions } from './scene'
import { seeded } from './seeded'

/** What an act may do to a run; chips by their place in the scene's list. */
export type Actor = {
  remove(chip: number): void
  resize(width: number, height: number): void
  /** Gives a chip a new size in place. */
  reshape(chip: number, shape: { width: number; height: number; radius?: number }): void
  /** Takes hold of a chip at its centre, moves the hold, or with no place lets go. */
  hold(chip: number, to?: { x: number; y: number }): void
  pose(chip: number): { x: number; y: number; angle: number }
}

/** Figures of a run, each the worst over its frames; lower is better. */
export type HardFigures = {
  /** chips with a number that is not finite */
  lost: number
  /** px outside the stage */
  outside: number
  /** energy over what was put in, as a share of it */
  gain: number
  /** energy lost by the end, as a share of what a run with 64 sub-steps keeps */
  loss: number
  /** px of overlap at the end */
  overlap: number
  /** px of overlap at any time */
  'overlap during': number
  /** px/s, the fastest chip, less what it has gained by falling from its highest place */
  speed: number
  /** px, how far the furthest corner is from where it stood */
  drift: number
  /** s from the last disturbance until all sleep */
  asleep: number
  /** chips that nothing joins to the floor at the end */
  hanging: number
  /** chips that went through a plate */
  through: number
  /** px/s, how much slower the sliding chip is than friction alone makes it */
  slowed: number
}

export const hardUnits: Record<keyof HardFigures, string> = {
  lost: 'chips',
  outside: 'px',
  gain: 'of the energy',
  loss: 'of the energy',
  overlap: 'px',
  'overlap during': 'px',
  speed: 'px/s',
  drift: 'px',
  asleep: 's',
  hanging: 'chips',
  through: 'chips',
  slowed: 'px/s',
}

/** The figures in a reader's words. */
export const hardWords: Record<keyof HardFigures, string> = {
  lost: 'lost to NaN',
  outside: 'outside the stage',
  gain: 'energy gained',
  loss: 'energy lost',
  overlap: 'overlap in the end',
  'overlap during': 'overlap at any time',
  speed: 'fastest chip, less its fall',
  drift: 'moved from its place',
  asleep: 'asleep after',
  hanging: 'hanging in the air',
  through: 'went through',
  slowed: 'slower than friction makes it',
}

export type HardScene = {
  name: string
  title: string
  width: number
  height: number
  seconds: number
  conditions: Conditions
  seeds: number
  build(seed: number): Chip[]
  act?(frame: number, actor: Actor, seed: number): void
  /** s, the last disturbance: an act, or where the fall takes long the landing of the highest chip */
  calmFrom?: number | ((chips: Chip[]) => number)
  /** s, the start of 'overlap during'; the second frame if left out */
  overlapFrom?: number
  /** the chip whose sides are watched: what is on one may not get to the other through it */
  plate?: number
  /** the chip that slides along a level surface from its start to its end */
  slider?: number
  bounds: Partial<HardFigures>
}

/** Air as in the component: a scene that asks for sleep has it, as a disc in a vacuum rolls on for ever. */
export const aired: Conditions = { ...conditions, linearDamping: 0.35, angularDamping: 1.4 }

/** Sines are not the same in every engine: with what comes of them put on a grid of 1/1024, a scene is. */
export const onGrid = (value: number) => Math.round(value * 1024) / 1024

/** A pour that is the same in every engine. */
export const pour: typeof pourChips = (kind, count, seed) =>
  pourChips(kind, count, seed).map((chip) => ({ ...chip, x: onGrid(chip.x), y: onGrid(chip.y) }))

export const settles = { lost: 0, outside: 1, overlap: 0.05, asleep: 6, hanging: 0 }

function scatter(
  count: number,
  width: number,
  height: number,
  random: () => number,
  shape: () => { width: number; height: number; radius: number },
): Chip[] {
  return Array.from({ length: count }, () => {
    const size = shape()
    const angle = 7 * random()
    const [hx, hy] = halfExtent(size, angle)
    return {
      ...size,
      angle,
      x: onGrid(hx + random() * Math.max(0, width - 2 * hx)),
      y: onGrid(hy + random() * Math.max(0, height - 2 * hy)),
    }
  })
}

const anyShape = (random: () => number) => () => {
  const width = 20 + 70 * random()
  const height = 20 + 30 * random()
  const pick = random()
  return { width, height, radius: pick < 0.4 ? Math.min(width, height) / 2 : pick < 0.7 ? 6 : 0 }
}

/** A seeded pour of `count` chips of one size. */
function pourOf(count: number, shape: { width: number; height: number; radius: number }) {
  return (seed: number): Chip[] => {
    const random = seeded(seed)
    const chips: Chip[] = []
    const across = Math.floor(620 / (Math.max(shape.width, shape.height) + 8))
    for (let i = 0; i < count; i++) {
      const cell = Math.max(shape.width, shape.height) + 8
      chips.push({
        ...shape,
        x: 10 + cell * ((i % across) + 0.5),
        y: -30 - cell * Math.floor(i / across),
        angle: 0.5 * (random() - 0.5),
        vx: 80 * (random() - 0.5),
        spin: 2.4 * (random() - 0.5),
      })
    }
    return chips
  }
}

const stage = { width: 640, height: 340 }

function tower(count: number, width: number, height: number, floor: number): Chip[] {
  return Array.from({ length: count }, (_, i) => ({
    width,
    height,
    x: 320,
    y: floor - height * (i + 0.5),
    angle: 0,
  }))
}

/** Two posts and a lintel on them, again and again. */
function portals(storeys: number, floor: number): Chip[] {
  return Array.from({ length: storeys }, (_, i) => {
    const base = floor - i * 80
    return [
      { width: 20, height: 60, x: 240, y: base - 30, angle: 0 },
      { width: 20, height: 60, x: 400, y: base - 30, angle: 0 },
      { width: 200, height: 20, x: 320, y: base - 70, angle: 0 },
    ]
  }).flat()
}

/** Pairs of cards that lean on each other, a card laid over each storey. */
function cardHouse(floor: number): Chip[] {
  const long = 80
  const thick = 4
  const lean = 0.3
  const c = Math.cos(lean)
  const s = Math.sin(lean)
  // Leaning cards touch at their upper inner corners and stand on their lower outer ones.
  const half = (long * s + thick * c) / 2
  const tall = long * c + thick * s
  const chips: Chip[] = []
  let base = floor
  for (let pairs = 3; pairs > 0; pairs--) {
    for (let i = 0; i < pairs; i++) {
      const x = 320 + (i - (pairs - 1) / 2) * (4 * half + 2)
      chips.push({ width: thick, height: long, x: x - half, y: base - tall / 2, angle: lean })
      chips.push({ width: thick, height: long, x: x + half, y: base - tall / 2, angle: -lean })
    }
    base -= tall
    if (pairs > 1) {
      for (let i = 0; i < pairs - 1; i++) {
        const x = 320 + (i - (pairs - 2) / 2) * (4 * half + 2)
        chips.push({ width: 4 * half, height: thick, x, y: base - thick / 2, angle: 0 })
      }
      base -= thick
    }
  }
  return chips
}

/** Two towers whose stones reach further over from course to course until they meet under one. */
function corbels(floor: number): Chip[] {
  const chips: Chip[] = []
  for (let course = 0; course < 6; course++) {
    const y = floor - 30 * (course + 0.5)
    for (const side of [-1, 1]) {
      chips.push({ width: 100, height: 30, x: 320 + side * (150 - 10 * course), y, angle: 0 })
    }
  }
  chips.push({ width: 160, height: 30, x: 320, y: floor - 195, angle: 0 })
  return chips
}

/**
 * A box that slides over a level row of twelve, with joints closed, 3 and 10 px wide in turn from seed to
 * seed, at 150 to 1,290 px/s. It sets out with its leading corner 2 px before a joint, and stays on the row.
 */
function seams(name: string, title: string, friction: number, radius: number): HardScene {
  return {
    name,
    title,
    width: 1000,
    height: 340,
    seconds: 0.5,
    conditions: { ...conditions, friction },
    seeds: 20,
    build(seed) {
      const joint = [0, 3, 10][seed % 3]
      const row = Array.from({ length: 12 }, (_, i) => ({
        width: 60,
        height: 40,
        radius: 0,
        x: 30 + i * (60 + joint),
        y: 320,
        angle: 0,
      }))
      return [{ width: 50, height: 30, radius, x: 33, y: 285, angle: 0, vx: 90 + 60 * seed }, ...row]
    },
    slider: 0,
    bounds: { lost: 0, outside: 1, gain: 0.001, slowed: 8 },
  }
}

export const hardScenes: HardScene[] = [
  {
    name: 'weightless',
    title: 'Thirty chips fly about without gravity',
    ...stage,
    seconds: 10,
    conditions: { ...conditions, gravity: 0 },
    seeds: 20,
    build(seed) {
      const random = seeded(seed)
      return pour('mixed', 30, seed).map((chip, i) => ({
        ...chip,
        x: 60 + 105 * (i % 6),
        y: 40 + 65 * Math.floor(i / 6),
        angle: 0,
        vx: 600 * (random() - 0.5),
        vy: 600 * (random() - 0.5),
      }))
    },
    bounds: { lost: 0, outside: 1, gain: 0.001, 'overlap during': 1.5 },
  },
  {
    name: 'light-gravity',
    title: 'Forty chips drift down at 100 px/s²',
    ...stage,
    seconds: 50,
    conditions: { ...aired, gravity: 100 },
    seeds: 20,
    build: (seed) => pour('mixed', 40, seed),
    calmFrom: (chips) => Math.max(...chips.map(({ y }) => Math.sqrt((2 * (stage.height - y)) / 100))),
    bounds: { ...settles, gain: 0.001 },
  },
  {
    name: 'heavy-gravity',
    title: 'Forty chips crash down at 20,000 px/s²',
    ...stage,
    seconds: 8,
    conditions: { ...aired, gravity: 20_000 },
    seeds: 20,
    build: (seed) => pour('mixed', 40, seed),
    bounds: { ...settles, gain: 0.001 },
  },
  {
    name: 'elastic-crowd',
    title: 'Forty chips bounce without loss for 20 s',
    ...stage,
    seconds: 20,
    conditions: { ...conditions, bounce: 1, friction: 0, bounceThreshold: 0 },
    seeds: 20,
    build: (seed) => pour('pills', 40, seed),
    bounds: { lost: 0, outside: 1, gain: 0.001, loss: 0.1 },
  },
  {
    name: 'bullets-at-walls',
    title: 'Chips are thrown at walls and floor at 3,600 px/s',
    ...stage,
    seconds: 8,
    conditions: aired,
    seeds: 20,
    build(seed) {
      const random = seeded(seed)
      return Array.from({ length: 12 }, (_, i) => {
        const way = 2 * Math.PI * random()
        return {
          ...anyShape(random)(),
          x: 80 + 160 * (i % 4),
          y: 70 + 100 * Math.floor(i / 4),
          angle: 7 * random(),
          vx: onGrid(3600 * Math.cos(way)),
          vy: onGrid(3600 * Math.sin(way)),
          spin: 40 * (random() - 0.5),
        }
      })
    },
    bounds: { ...settles, gain: 0.001 },
  },
  {
    name: 'bullets-at-a-plate',
    title: 'Discs and boxes are shot at a plate of 4 px or more',
    width: 1200,
    height: 600,
    seconds: 1,
    conditions: { ...conditions, gravity: 0 },
    seeds: 20,
    build(seed) {
      const random = seeded(seed)
      // One that hardly gives way, and at every other seed one as light as the bullets.
      const thick = [4, 4, 5, 7, 12, 30][Math.floor((seed - 1) / 2) % 6]
      const plate = { width: thick, height: 400, x: 600, y: 300, angle: 0, density: seed % 2 ? 2000 : 1 }
      const bullets = Array.from({ length: 12 }, (_, i) => {
        const size = 8 + 24 * random()
        return {
          width: size,
          height: size,
          radius: random() < 0.5 ? size / 2 : 0,
          x: i % 2 ? 100 + 300 * random() : 800 + 300 * random(),
          y: 130 + 30 * i,
          angle: 7 * random(),
          vx: i % 2 ? 3600 : -3600,
        }
      })
      return [plate, ...bullets]
    },
    plate: 0,
    bounds: { lost: 0, outside: 1, through: 0, gain: 0.001 },
  },
  {
    name: 'column',
    title: 'A column of forty boxes stands',
    width: 640,
    height: 900,
    seconds: 10,
    conditions: aired,
    seeds: 1,
    build: () => tower(40, 60, 20, 900),
    bounds: { ...settles, gain: 0.001, drift: 1 },
  },
  {
    name: 'portals',
    title: 'Four storeys of posts and lintels stand',
    width: 640,
    height: 400,
    seconds: 10,
    conditions: aired,
    seeds: 1,
    build: () => portals(4, 400),
    bounds: { ...settles, gain: 0.001, drift: 1 },
  },
  {
    name: 'card-house',
    title: 'A house of cards stands',
    width: 640,
    height: 340,
    seconds: 10,
    conditions: { ...aired, friction: 0.7 },
    seeds: 1,
    build: () => cardHouse(340),
    bounds: { ...settles, gain: 0.001, drift: 2 },
  },
  {
    name: 'arch',
    title: 'A corbelled arch stands',
    ...stage,
    seconds: 10,
    conditions: aired,
    seeds: 1,
    build: () => corbels(340),
    bounds: { ...settles, gain: 0.001, drift: 1 },
  },
  seams('seams-smooth', 'A box slides over the joints of a row without friction', 0, 0),
  seams('seams-rough', 'A box slides over the joints of a row with friction', 0.4, 0),
  seams('seams-rounded', 'A box with corners of 1 px slides over the joints of a row', 0.4, 1),
  {
    name: 'heavy-on-light',
    title: 'A chip lands on two that weigh a four-hundredth of it',
    ...stage,
    seconds: 8,
    conditions: aired,
    seeds: 20,
    build(seed) {
      const random = seeded(seed)
      const radius = 15 * random()
      return [
        { width: 30, height: 30, x: 250 + 20 * random(), y: 325, angle: 0 },
        { width: 30, height: 30, x: 370 + 20 * random(), y: 325, angle: 0 },
        // Rounding the corners of the large chip off takes no more than a hundredth of its mass.
        { width: 200, height: 100, radius, x: 320, y: 260 - 3 * random(), angle: 0, density: 18 },
      ]
    },
    bounds: { ...settles, gain: 0.001, 'overlap during': 0.2 },
  },
  {
    name: 'crammed',
    title: 'Chips of twice the stage’s area appear in it at once',
    width: 300,
    height: 200,
    seconds: 10,
    conditions: aired,
    seeds: 20,
    build(seed) {
      const random = seeded(seed)
      return scatter(60, 300, 200, random, anyShape(random))
    },
    bounds: { ...settles, speed: 1000 },
  },
  {
    name: 'same-place',
    title: 'Twenty chips start at the very same place',
    ...stage,
    seconds: 10,
    conditions: aired,
    seeds: 20,
    build(seed) {
      const random = seeded(seed)
      const shape = anyShape(random)()
      return Array.from({ length: 20 }, () => ({ ...shape, x: 320, y: 250, angle: 0.4 }))
    },
    bounds: { ...settles, speed: 1000 },
  },
  {
    name: 'random-poses',
    title: 'Two hundred chips appear anywhere, in any turn',
    width: 1200,
    height: 700,
    seconds: 10,
    conditions: aired,
    seeds: 20,
    build(seed) {
      const random = seeded(seed)
      return scatter(200, 1200, 700, random, anyShape(random))
    },
    bounds: { ...settles, speed: 1000 },
  },
  {
    name: 'small-among-large',
    title: 'Discs of 4 px rain on boxes of 200 px',
    ...stage,
    seconds: 8,
    conditions: aired,
    seeds: 20,
    build(seed) {
      const random = seeded(seed)
      const large = [130, 460].map((x) => ({
        width: 200,
        height: 200,
        radius: 12,
        x: x + 30 * random(),
        y: 238,
        angle: 0,
      }))
      const small = Array.from({ length: 80 }, (_, i) => ({
        width: 4,
        height: 4,
        radius: 2,
        x: 10 + 7.7 * i + 2 * random(),
        y: -20 - 40 * random(),
        angle: 0,
      }))
      return [...large, ...small]
    },
    bounds: { ...settles, gain: 0.001 },
  },
  {
    name: 'slender',
    title: 'Thirty chips twelve times as long as high',
    ...stage,
    seconds: 8,
    conditions: aired,
    seeds: 20,
    build: pourOf(30, { width: 144, height: 12, radius: 6 }),
    bounds: { ...settles, gain: 0.001 },
  },
  {
    name: 'nearly-pills',
    title: 'Thirty chips a 64th of a pixel higher than their round ends',
    ...stage,
    seconds: 8,
    conditions: aired,
    seeds: 20,
    build: pourOf(30, { width: 96, height: 32 + 1 / 64, radius: 16 }),
    bounds: { ...settles, gain: 0.001 },
  },
  {
    name: 'tall',
    title: 'Thirty chips taller than wide',
    ...stage,
    seconds: 8,
    conditions: aired,
    seeds: 20,
    build: pourOf(30, { width: 24, height: 80, radius: 8 }),
    bounds: { ...settles, gain: 0.001 },
  },
  {
    name: 'support-pulled-out',
    title: 'The lowest box of a sleeping stack is taken away',
    ...stage,
    seconds: 10,
    conditions: aired,
    seeds: 1,
    build: () => tower(7, 70, 30, 340),
    act(frame, actor) {
      if (frame === 120) actor.remove(0)
    },
    calmFrom: 2,
    bounds: { ...settles, gain: 0.001 },
  },
  {
    name: 'dragged-through-everything',
    title: 'A chip is dragged through pile, floor and walls',
    ...stage,
    seconds: 14,
    conditions: aired,
    seeds: 20,
    build: (seed) => pour('mixed', 40, seed),
    act(frame, actor, seed) {
      if (frame < 180) return
      const random = seeded(1000 * seed + Math.floor((frame - 180) / 20))
      if (frame < 420) actor.hold(5, { x: 1400 * (random() - 0.25), y: 900 * (random() - 0.25) })
      if (frame === 420) actor.hold(5)
    },
    calmFrom: 7,
    bounds: { ...settles, 'overlap during': 4 },
  },
  {
    name: 'pressed-into-the-pile',
    title: 'A chip is pressed hard into the pile',
    ...stage,
    seconds: 12,
    conditions: aired,
    seeds: 20,
    build: (seed) => pour('pills', 60, seed),
    act(frame, actor) {
      if (frame < 180 || frame > 360) return
      if (frame === 360) actor.hold(59)
      else actor.hold(59, { x: 320, y: 2000 })
    },
    calmFrom: 6,
    bounds: { ...settles, 'overlap during': 4 },
  },
  {
    name: 'resized-every-frame',
    title: 'The stage changes its size in every frame for 10 s',
    ...stage,
    seconds: 18,
    conditions: aired,
    seeds: 20,
    build: (seed) => pour('mixed', 40, seed),
    act(frame, actor) {
      if (frame < 600)
        actor.resize(onGrid(480 + 160 * Math.cos(frame / 17)), onGrid(340 + 60 * Math.sin(frame / 11)))
      if (frame === 600) actor.resize(640, 340)
    },
    calmFrom: 10,
    bounds: settles,
  },
  {
    name: 'pressed-by-a-wall',
    title: 'A wall moves into the pile at 240 px/s, and takes a third of the stage',
    ...stage,
    seconds: 12,
    conditions: aired,
    seeds: 20,
    build: (seed) => pour('pills', 60, seed),
    act(frame, actor) {
      if (frame > 240 && frame <= 300) actor.resize(640 - 4 * (frame - 240), 340)
    },
    calmFrom: 5,
    bounds: { ...settles, 'overlap during': 4 },
  },
  {
    name: 'collapsed-and-back',
    title: 'The stage collapses to nothing and comes back',
    ...stage,
    seconds: 12,
    conditions: aired,
    seeds: 20,
    build: (seed) => pour('mixed', 40, seed),
    act(frame, actor) {
      if (frame === 150) actor.resize(0, 0)
      if (frame === 180) actor.resize(640, 340)
    },
    calmFrom: 3,
    bounds: settles,
  },
]

/** A figure's words and unit; a share has none. */
export function named(figure: keyof HardFigures) {
  const [measure, unit] = [hardWords[figure], hardUnits[figure]]
  return unit.startsWith('of ') ? { measure: `${measure}, share`, unit: '' } : { measure, unit }
}

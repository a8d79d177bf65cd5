// Scenes with one right answer: a closed form or an ODE.
import { bouncingDisc, flight, massOf, pillsImpact, strike, topple } from './references'
import { type Chip, conditions, frame, type Scene, type Trajectory } from './scene'

const pixels = (target: number, name = 'error') => [{ name, unit: 'px', target }]
const ended = (trajectory: Trajectory) => trajectory.state(trajectory.frames)
const disc = { width: 40, height: 40, radius: 20 }
const pill = { width: 80, height: 30, radius: 15 }

function fall(name: string, title: string, linearDamping: number): Scene {
  return {
    name,
    title,
    width: 640,
    height: 4000,
    seconds: 1,
    conditions: { ...conditions, linearDamping },
    seeds: 1,
    build: () => [{ ...pill, x: 320, y: 60, angle: 0 }],
    measures: pixels(1e-9),
    measure: (trajectory) => [Math.abs(ended(trajectory).y - 60 - flight(0, 2600, linearDamping, 1).moved)],
  }
}

const projectile: Scene = {
  name: 'projectile',
  title: 'A spinning pill thrown through air',
  width: 4000,
  height: 4000,
  seconds: 1,
  conditions: { ...conditions, linearDamping: 0.35, angularDamping: 1.4 },
  seeds: 1,
  build: () => [{ ...pill, x: 500, y: 1500, angle: 0.3, vx: 900, vy: -1100, spin: 9 }],
  measures: [...pixels(1e-9), { name: 'turn', unit: 'rad', target: 1e-8 }],
  measure(trajectory) {
    const end = ended(trajectory)
    const x = 500 + flight(900, 0, 0.35, 1).moved
    const y = 1500 + flight(-1100, 2600, 0.35, 1).moved
    const angle = 0.3 + flight(9, 0, 1.4, 1).moved
    return [Math.hypot(end.x - x, end.y - y), turnedBetween(end.angle, angle)]
  },
}

/** Engines count angles from −π to π or without end; only the pose counts here. */
function turnedBetween(a: number, b: number) {
  return 2 * Math.abs(Math.asin(Math.sin((a - b) / 2)))
}

const spin: Scene = {
  name: 'spin',
  title: 'A pill turns at 20 rad/s for a second',
  width: 640,
  height: 640,
  seconds: 1,
  conditions: { ...conditions, gravity: 0 },
  seeds: 1,
  build: () => [{ ...pill, x: 320, y: 320, angle: 0, spin: 20 }],
  measures: [{ name: 'turn', unit: 'rad', target: 1e-8 }],
  measure: (trajectory) => [turnedBetween(ended(trajectory).angle, 20)],
}

function bounces(name: string, bounce: number, count: number): Scene {
  const drop = 250
  return {
    name,
    title: `A disc bounces ${count} times at e = ${bounce}`,
    width: 640,
    height: 340,
    seconds: bounce < 0.6 ? 2 : 4,
    conditions: { ...conditions, bounce },
    seeds: 1,
    build: () => [{ ...disc, x: 320, y: 320 - drop, angle: 0 }],
    measures: pixels(1e-6, 'apex'),
    measure(trajectory) {
      const apexes = trajectory.apexes()
      let worst = 0
      for (let i = 0; i < count; i++) {
        const height = drop * bounce ** (2 * (i + 1))
        worst = Math.max(worst, Math.abs(320 - (apexes[i] ?? 320) - height))
      }
      return [worst]
    },
  }
}

const perpetual: Scene = {
  name: 'bounce-forever',
  title: 'A disc bounces for a minute at e = 1',
  width: 640,
  height: 340,
  seconds: 60,
  conditions: { ...conditions, bounce: 1 },
  seeds: 1,
  build: () => [{ ...disc, x: 320, y: 120, angle: 0 }],
  measures: [{ name: 'height', unit: 'relative', target: 1e-6 }],
  measure(trajectory) {
    const last = trajectory.apexes().at(-1) ?? 320
    return [Math.abs(320 - last - 200) / 200]
  },
}

const slide: Scene = {
  name: 'slide',
  title: 'A box slides to a stop',
  width: 1200,
  height: 340,
  seconds: 1.5,
  conditions,
  seeds: 1,
  build: () => [{ width: 60, height: 40, x: 200, y: 320, angle: 0, vx: 800 }],
  measures: pixels(0.005),
  measure: (trajectory) => [Math.abs(ended(trajectory).x - 200 - 800 ** 2 / (2 * 0.4 * 2600))],
}

const roll: Scene = {
  name: 'roll',
  title: 'A disc launched sliding ends rolling at two thirds of its speed',
  width: 1600,
  height: 340,
  seconds: 1,
  conditions,
  seeds: 1,
  build: () => [{ ...disc, x: 200, y: 320, angle: 0, vx: 600 }],
  measures: pixels(0.02),
  measure(trajectory) {
    const brake = 0.4 * 2600
    const grips = 600 / (3 * brake)
    const x = 200 + 600 * grips - (brake * grips ** 2) / 2 + 400 * (1 - grips)
    return [Math.abs(ended(trajectory).x - x)]
  },
}

/** Speeds of two pictures of the same body, spin counted at the reach of its end. */
function speedError(got: { vx: number; vy: number; spin: number }, want: typeof got, reach: number) {
  return Math.hypot(got.vx - want.vx, got.vy - want.vy, (got.spin - want.spin) * reach)
}

const impact: Scene = {
  name: 'pill-impact',
  title: 'A pill strikes another off its centre, both free',
  width: 2000,
  height: 2000,
  seconds: 0.2,
  conditions: { ...conditions, gravity: 0, friction: 0, bounce: 0.5 },
  seeds: 1,
  build: () => [
    { ...pill, x: 1000, y: 1000, angle: 0 },
    { width: 30, height: 80, radius: 15, x: 1023, y: 893.7, angle: 0, vy: 500 },
  ],
  measures: [{ name: 'velocity', unit: 'px/s', target: 1e-9 }],
  measure(trajectory) {
    const want = pillsImpact(500, 23, pill, pill, 0.5)
    const a = trajectory.state(trajectory.frames, 0)
    const b = trajectory.state(trajectory.frames, 1)
    return [
      Math.max(
        speedError(a, { vx: 0, vy: want.struck.speed, spin: want.struck.spin }, 40),
        speedError(b, { vx: 0, vy: want.striker.speed, spin: 0 }, 40),
      ),
    ]
  },
}

const obliqueThrows: Chip[] = [
  { ...disc, x: 300, y: 210, angle: 0, vx: 700, vy: 500 },
  { ...disc, x: 900, y: 210, angle: 0, vx: 100, vy: 500, spin: -3 },
  { ...pill, x: 1500, y: 170, angle: 0.9, vx: 300, vy: 600 },
  { ...pill, x: 2100, y: 160, angle: -1.1, vx: 60, vy: 700 },
]

const oblique: Scene = {
  name: 'oblique-impact',
  title: 'Discs and pills strike the floor at a slant, sliding and gripping',
  width: 2600,
  height: 340,
  seconds: 0.3,
  conditions: { ...conditions, gravity: 0, bounce: 0.5 },
  seeds: 1,
  build: () => obliqueThrows,
  measures: [{ name: 'velocity', unit: 'px/s', target: 1e-9 }],
  measure(trajectory) {
    let worst = 0
    obliqueThrows.forEach((chip, i) => {
      const r = chip.radius ?? 0
      const d = (chip.width / 2 - r) * Math.sign(Math.sin(chip.angle))
      const arm = { rx: d * Math.cos(chip.angle), ry: d * Math.sin(chip.angle) + r }
      const { mass, inertia } = massOf(chip)
      const velocity = { vx: chip.vx ?? 0, vy: chip.vy ?? 0, spin: chip.spin ?? 0 }
      const want = strike({ mass, inertia, ...arm, ...velocity }, 0, -1, 0.5, 0.4)
      worst = Math.max(worst, speedError(trajectory.state(trajectory.frames, i), want, chip.width / 2))
    })
    return [worst]
  },
}

const ricochetStart = { x: 320, y: 120, vx: 1100, vy: 300, spin: 5, radius: 20 }

const ricochet: Scene = {
  name: 'ricochet',
  title: 'A spinning disc ricochets off walls and floor',
  width: 640,
  height: 340,
  seconds: 1,
  conditions: { ...conditions, bounce: 0.8 },
  seeds: 1,
  build: () => [{ ...disc, ...ricochetStart, angle: 0 }],
  measures: pixels(1e-6),
  measure(trajectory) {
    let worst = 0
    for (let k = 1; k <= trajectory.frames; k++) {
      const want = bouncingDisc(
        ricochetStart,
        trajectory.scene,
        { gravity: 2600, bounce: 0.8, friction: 0.4 },
        k * frame,
      )
      const got = trajectory.state(k)
      worst = Math.max(worst, Math.hypot(got.x - want.x, got.y - want.y))
    }
    return [worst]
  },
}

const upright = { width: 30, height: 90, radius: 15 }
const lean = 0.2

const toppling: Scene = {
  name: 'topple',
  title: 'A pill stood on its end topples, rolling without slip',
  width: 640,
  height: 340,
  seconds: 28 * frame,
  conditions: { ...conditions, friction: 1 },
  seeds: 1,
  build: () => [{ ...upright, x: 320, y: 340 - topple(upright, lean, 2600, 0).height, angle: lean }],
  measures: pixels(0.02),
  measure(trajectory) {
    const start = topple(upright, lean, 2600, 0).x
    let worst = 0
    for (let k = 1; k <= trajectory.frames; k++) {
      const want = topple(upright, lean, 2600, k * frame, 6000)
      const got = trajectory.state(k)
      const away = Math.hypot(got.x - 320 - want.x + start, got.y - 340 + want.height)
      worst = Math.max(worst, away, 45 * turnedBetween(got.angle, want.angle))
    }
    return [worst]
  },
}

export const exactScenes: Scene[] = [
  fall('free-fall', 'A pill falls for a second', 0),
  fall('free-fall-drag', 'A pill falls through air for a second', 0.35),
  projectile,
  spin,
  bounces('bounce-0.5', 0.5, 3),
  bounces('bounce-0.8', 0.8, 6),
  perpetual,
  slide,
  roll,
  impact,
  oblique,
  ricochet,
  toppling,
]

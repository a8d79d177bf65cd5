import { createWorld } from '../../registry/gravity-stack/world'
import {
  chipDistance,
  halfExtent,
  type Pose,
  type Shape,
  type Stage,
  stageDistance,
  worstOverlap,
} from '../../scenes/exact-distance'
import { type Actor, type HardFigures, type HardScene, hardScenes } from '../../scenes/hard'
import { massOf } from '../../scenes/references'
import { type Chip, driftOf, frame } from '../../scenes/scene'

type State = Pose & { vx: number; vy: number; spin: number }
export type Watch = (frame: number, states: State[], alive: boolean[], stage: Stage) => void

/** Plays a hard scene with our solver, asleep when it may be, and reads off its figures. */
export function playHardScene(scene: HardScene, seed: number, watch?: Watch): HardFigures {
  return playHard(scene, seed, watch).figures
}

/** The same, with the digest of the last frame: two engines that agree on it agree on every bit. */
export function playHard(
  scene: HardScene,
  seed: number,
  watch?: Watch,
  substeps?: number,
): { figures: HardFigures; hash: string } {
  const chips = scene.build(seed)
  const world = createWorld({
    width: scene.width,
    height: scene.height,
    ...scene.conditions,
    ...(substeps ? { substeps } : {}),
  })
  const ids = chips.map((chip) => world.add(chip))
  const alive = chips.map(() => true)
  const stage = { width: scene.width, height: scene.height }
  const grabs = new Map<number, ReturnType<typeof world.grab>>()
  let clock = 0
  const actor: Actor = {
    remove(chip) {
      world.remove(ids[chip])
      alive[chip] = false
    },
    resize(width, height) {
      world.resize(width, height)
      // A stage of no size counts as one of 1 px.
      Object.assign(stage, { width: Math.max(1, width), height: Math.max(1, height) })
    },
    reshape(chip, shape) {
      world.reshape(ids[chip], shape)
      chips[chip] = { ...chips[chip], ...shape }
      masses[chip] = massOf(chips[chip])
    },
    hold(chip, to) {
      const held = grabs.get(chip)
      if (!to) {
        held?.release()
        grabs.delete(chip)
      } else if (held) held.moveTo(to.x, to.y, clock)
      else {
        const { x, y } = world.read(ids[chip])
        grabs.set(chip, world.grab(ids[chip], x, y))
      }
    },
    pose: (chip) => world.read(ids[chip]),
  }

  const masses = chips.map(massOf)
  const read = (): State[] => ids.map((id) => world.read(id))
  const energy = (states: State[]) =>
    states.reduce((sum, { y, vx, vy, spin }, i) => {
      if (!alive[i]) return sum
      const { mass, inertia } = masses[i]
      const height = scene.height - y
      return (
        sum +
        (mass * (vx * vx + vy * vy) + inertia * spin * spin) / 2 +
        mass * scene.conditions.gravity * height
      )
    }, 0)
  const put = energy(read())
  const figures: HardFigures = {
    lost: 0,
    outside: 0,
    gain: 0,
    loss: 0,
    overlap: 0,
    'overlap during': 0,
    speed: 0,
    drift: 0,
    asleep: Number.POSITIVE_INFINITY,
    hanging: 0,
    through: 0,
    slowed: 0,
  }
  const frames = Math.round(scene.seconds / frame)
  const { calmFrom = 0 } = scene
  const calm = Math.round((typeof calmFrom === 'number' ? calmFrom : calmFrom(chips)) / frame)
  const overlapFrom = Math.max(2, Math.round((scene.overlapFrom ?? 0) / frame))
  const highest = chips.map(({ y }) => y)
  let before = read()
  const watched = new Set<keyof HardFigures>(Object.keys(scene.bounds) as (keyof HardFigures)[])
  const living = () => chips.filter((_, i) => alive[i])
  const posesOf = (states: Pose[]) => states.filter((_, i) => alive[i])
  for (let k = 1; k <= frames; k++) {
    clock = k * frame
    scene.act?.(k, actor, seed)
    world.step(frame)
    const now = read()
    for (let i = 0; i < chips.length; i++) {
      if (!alive[i]) continue
      const { x, y, angle, vx, vy, spin } = now[i]
      if (!Number.isFinite(x + y + angle + vx + vy + spin)) {
        figures.lost++
        return { figures, hash: world.hash() }
      }
      highest[i] = Math.min(highest[i], y)
      const fallen = 2 * scene.conditions.gravity * (y - highest[i])
      figures.speed = Math.max(figures.speed, Math.sqrt(Math.max(0, vx * vx + vy * vy - fallen)))
    }
    if (watched.has('outside')) {
      for (let i = 0; i < chips.length; i++)
        if (alive[i]) figures.outside = Math.max(figures.outside, outsideOf(chips[i], now[i], stage))
    }
    if (watched.has('overlap during') && k >= overlapFrom) {
      const known = figures['overlap during']
      figures['overlap during'] = worstOverlap(living(), posesOf(now), stage, known)
    }
    if (watched.has('gain')) figures.gain = Math.max(figures.gain, (energy(now) - put) / put)
    if (scene.plate !== undefined) figures.through += crossings(scene.plate, chips, before, now)
    if (scene.slider !== undefined)
      figures.slowed = Math.max(figures.slowed, slowedBy(scene, chips[scene.slider], k, now[scene.slider].vx))
    if (k >= calm && world.resting && figures.asleep === Number.POSITIVE_INFINITY) {
      figures.asleep = Math.max(0, k - calm) * frame
    }
    if (!world.resting) figures.asleep = Number.POSITIVE_INFINITY
    watch?.(k, now, alive, stage)
    before = now
  }
  figures.overlap = worstOverlap(living(), posesOf(before), stage)
  figures.loss = Math.max(0, (put - energy(before)) / put)
  figures.hanging = hanging(living(), posesOf(before), stage, false)
  figures.drift = driftOf(chips, before)
  return { figures, hash: world.hash() }
}

/** px/s by which a chip that slides along a level surface is slower at a frame than friction explains. */
export function slowedBy({ conditions }: HardScene, chip: Chip, frames: number, vx: number) {
  return Math.max(0, chip.vx! - conditions.friction * conditions.gravity * frames * frame) - vx
}

/** px that a chip reaches out of the stage. The floor holds always, the walls what they have room for. */
export function outsideOf(shape: Shape, pose: Pose, stage: Stage) {
  const { floor, left, right } = stageDistance(shape, pose, stage)
  const fits = 2 * halfExtent(shape, pose.angle)[0] <= stage.width
  return Math.max(0, -floor, fits ? Math.max(-left, -right) : 0)
}

/** Chips that no chain of touching chips (0.1 px) joins to the floor, or, with `wedged`, to a wall. */
export function hanging(chips: Shape[], poses: Pose[], stage: Stage, wedged: boolean) {
  const near = 0.1
  const carried = new Set<number>()
  const queue = chips.flatMap((chip, i) => {
    const { floor, left, right } = stageDistance(chip, poses[i], stage)
    return (wedged ? Math.min(floor, left, right) : floor) < near ? [i] : []
  })
  for (let i = queue.pop(); i !== undefined; i = queue.pop()) {
    if (carried.has(i)) continue
    carried.add(i)
    for (let j = 0; j < chips.length; j++) {
      if (!carried.has(j) && chipDistance(chips[i], poses[i], chips[j], poses[j]) < near) queue.push(j)
    }
  }
  return chips.length - carried.size
}

/** Chips that changed sides of the plate within its height since the frame before. */
function crossings(plate: number, chips: Chip[], before: Pose[], now: Pose[]) {
  const local = (poses: Pose[], i: number) => {
    const { x, y, angle } = poses[plate]
    const c = Math.cos(angle)
    const s = Math.sin(angle)
    const dx = poses[i].x - x
    const dy = poses[i].y - y
    return { across: c * dx + s * dy, along: c * dy - s * dx }
  }
  return chips.filter((_, i) => {
    if (i === plate) return false
    const was = local(before, i)
    const is = local(now, i)
    const within = Math.max(Math.abs(was.along), Math.abs(is.along)) < chips[plate].height / 2
    return within && was.across * is.across < 0
  }).length
}

/** A figure of a scene, the worst of its seeds; null is one without bound: never asleep. */
export type HardRow = { scene: string; figure: string; value: number | null; bound: number }

export function hardRows(scene: HardScene, seeds = scene.seeds): HardRow[] {
  const runs = Array.from({ length: Math.min(seeds, scene.seeds) }, (_, i) => playHardScene(scene, i + 1))
  return Object.entries(scene.bounds).map(([figure, bound]) => {
    const value = Math.max(...runs.map((run) => run[figure as keyof HardFigures]))
    return { scene: scene.name, figure, value: Number.isFinite(value) ? value : null, bound }
  })
}

/** The figures of every hard scene; for a worker. */
export const allHardRows = () => hardScenes.flatMap((scene) => hardRows(scene))

export const holds = ({ value, bound }: HardRow) => value !== null && value <= bound

/** The figures of a scene that are beyond their bounds. */
export const misses = (rows: HardRow[], scene: string) =>
  rows.filter((row) => row.scene === scene && !holds(row)).map(({ figure }) => figure)

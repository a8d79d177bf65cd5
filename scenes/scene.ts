import { type Pose, type Shape, worstOverlap } from './exact-distance'

/** A body as a scene starts it: px, seconds, radians; y down, angle and spin clockwise on screen. */
export type Chip = Shape &
  Pose & { vx?: number; vy?: number; spin?: number /** mass per px², 1 if left out */; density?: number }

export type Conditions = {
  /** px/s² downward */
  gravity: number
  /** Coulomb's coefficient */
  friction: number
  /** restitution, 0..1 */
  bounce: number
  /** approach in px/s below which nothing bounces */
  bounceThreshold: number
  /** air drag, 1/s */
  linearDamping: number
  angularDamping: number
}

/** The component's own defaults, without air drag. */
export const conditions: Conditions = {
  gravity: 2600,
  friction: 0.4,
  bounce: 0.18,
  bounceThreshold: 90,
  linearDamping: 0,
  angularDamping: 0,
}

/** Every engine is stepped by this frame, in seconds. */
export const frame = 1 / 60

/** A number read off a run. Lower is better; `target` is what this project asks of itself. */
export type Measure = {
  name: string
  unit: string
  target?: number
  /** how runs with several seeds become one number */
  over?: 'worst' | 'median'
  /** false where less is not more exact: a pile can also rest too soon */
  ranked?: false
}

export type Scene = {
  name: string
  /** what a person would see */
  title: string
  width: number
  height: number
  seconds: number
  conditions: Conditions
  /** seeds that a full run takes; 1 for scenes without chance */
  seeds: number
  build(seed: number): Chip[]
  measures: Measure[]
  /** One number for each entry of `measures`. */
  measure(trajectory: Trajectory): number[]
}

/** x, y, angle, vx, vy, spin */
export const numbersPerChip = 6

/** How far the furthest corner of any chip is from where it started, px; infinitely far from nowhere. */
export function driftOf(chips: Chip[], poses: Pose[]) {
  let worst = 0
  for (const [i, chip] of chips.entries()) {
    const { x, y, angle } = poses[i]
    if (Number.isNaN(x + y + angle)) return Number.POSITIVE_INFINITY
    const reach = Math.hypot(chip.width, chip.height) / 2
    const turned = 2 * reach * Math.abs(Math.sin((angle - chip.angle) / 2))
    worst = Math.max(worst, Math.hypot(x - chip.x, y - chip.y) + turned)
  }
  return worst
}

/** The state of every chip at every frame; frame 0 is the start. */
export class Trajectory {
  readonly frames: number
  readonly data: Float64Array
  constructor(
    readonly scene: Scene,
    readonly chips: Chip[],
    frames = Math.round(scene.seconds / frame),
  ) {
    this.frames = frames
    this.data = new Float64Array((frames + 1) * chips.length * numbersPerChip)
    chips.forEach((chip, i) => {
      const start = [chip.x, chip.y, chip.angle, chip.vx ?? 0, chip.vy ?? 0, chip.spin ?? 0]
      this.data.set(start, i * numbersPerChip)
    })
  }

  /** The part of `data` that holds one frame. */
  at(index: number) {
    const size = this.chips.length * numbersPerChip
    return this.data.subarray(index * size, (index + 1) * size)
  }

  state(index: number, chip = 0) {
    const [x, y, angle, vx, vy, spin] = this.at(index).subarray(chip * numbersPerChip)
    return { x, y, angle, vx, vy, spin }
  }

  poses(index: number): Pose[] {
    return this.chips.map((_, i) => this.state(index, i))
  }

  /** Worst overlap in px at one frame, by the exact distance; `known` if none is worse. */
  overlap(index: number, known = 0) {
    return worstOverlap(this.chips, this.poses(index), this.scene, known)
  }

  worstOverlap() {
    let worst = 0
    for (let k = 1; k <= this.frames; k++) worst = this.overlap(k, worst)
    return worst
  }

  /**
   * The last moment, s, at which any chip is faster than 7 px/s or 0.14 rad/s; the whole run if it never
   * calms.
   */
  timeToRest() {
    const { data, chips } = this
    for (let at = data.length - numbersPerChip; at >= 0; at -= numbersPerChip) {
      const speed = Math.hypot(data[at + 3], data[at + 4])
      if (speed <= 7 && Math.abs(data[at + 5]) <= 0.14) continue
      const last = Math.floor(at / numbersPerChip / chips.length)
      return last * frame
    }
    return 0
  }

  /** How far the furthest corner of any chip is from where it started, px. */
  drift(index = this.frames) {
    return driftOf(
      this.chips,
      this.chips.map((_, i) => this.state(index, i)),
    )
  }

  /**
   * Height of each bounce, px: the tops of the parabolas through the three frames round each highest point,
   * so that neither the frame's phase nor an engine's notion of velocity matters.
   */
  apexes(chip = 0) {
    const y = (k: number) => this.data[k * this.chips.length * numbersPerChip + chip * numbersPerChip + 1]
    const tops: number[] = []
    for (let k = 1; k < this.frames; k++) {
      const before = y(k - 1)
      const here = y(k)
      const after = y(k + 1)
      if (!(here < before && here <= after)) continue
      const bend = before - 2 * here + after
      tops.push(here - (after - before) ** 2 / (8 * bend))
    }
    return tops
  }
}

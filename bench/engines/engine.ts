import type { Chip, Scene } from '../../scenes/scene'

/** One choice of an engine's accuracy knobs. */
export type Setting = Record<string, number>

/** A scene under way in one engine. */
export type Run = {
  /** One frame of 1/60 s. */
  step(): void
  /** Writes x, y, angle, vx, vy, spin of every chip, px and radians, in the order they were added. */
  read(out: Float64Array): void
  free(): void
  /** What the last step did, for engines that count it. */
  work?(): Record<string, number>
}

export type Engine = {
  name: string
  /** the package measured, for its version and its bytes; none for ours and for methods written here */
  packages: string[]
  /** every setting of its natural knobs, the default first */
  settings: Setting[]
  /** the one of them beside the default that stands for all others where there is no time for them */
  accurate: Setting
  /**
   * is so slow, or has a faster build beside it, that its pours have fewer seeds and its largest piles come
   * last
   */
  brief?: true
  /** another build of the same engine, whose chips move by the same bits: its errors stand for both */
  sameBitsAs?: string
  load(): Promise<void>
  /** Without `sleep` everything stays awake, so that what is measured is the solver and not its sleep. */
  start(scene: Scene, chips: Chip[], setting: Setting, sleep: boolean): Run
}

/** px per metre for engines that think in metres: a label chip is then a third of a metre high. */
export const pixelsPerMetre = 100

/** Thickness of the boxes that stand for floor and walls, px. */
const wallThickness = 1000

/**
 * Floor and walls as boxes: centre and half size, px. They reach far past the stage, which has no ceiling.
 */
export function walls(scene: { width: number; height: number }) {
  const t = wallThickness / 2
  const tall = scene.height + 10_000
  return [
    { x: scene.width / 2, y: scene.height + t, halfWidth: scene.width / 2 + 2 * t, halfHeight: t },
    { x: -t, y: scene.height / 2 - 5000, halfWidth: t, halfHeight: tall / 2 },
    { x: scene.width + t, y: scene.height / 2 - 5000, halfWidth: t, halfHeight: tall / 2 },
  ]
}

export function settingName(setting: Setting) {
  const parts = Object.entries(setting).map(([key, value]) => `${key} ${value}`)
  return parts.join(', ') || 'default'
}

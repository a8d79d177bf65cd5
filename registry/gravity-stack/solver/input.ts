export interface Vector {
  x: number
  y: number
}

export interface WorldOptions {
  /** px, size of the stage: floor at y = height, walls at x = 0 and x = width. */
  width: number
  height: number
  /** px/s² downwards, or to the right and downwards. */
  gravity?: number | Vector | undefined
  /** Whether there is a ceiling at y = 0 as well, for what has once been wholly below it. */
  ceiling?: boolean | undefined
  /** Restitution, 0..1. */
  bounce?: number
  /** Coulomb coefficient, 0 or more. */
  friction?: number
}

export interface BodyOptions {
  /** px, outer size and corner radius. */
  width: number
  height: number
  radius?: number
  /** px, centre; radians clockwise on screen. */
  x: number
  y: number
  angle?: number
  /** px/s and rad/s. */
  vx?: number
  vy?: number
  spin?: number
  /** Mass a px². */
  density?: number
}

/** Pose and velocity of a body: px, radians, px/s, rad/s. */
export interface Reading {
  x: number
  y: number
  angle: number
  vx: number
  vy: number
  spin: number
  asleep: boolean
}

export type Motion = Partial<Pick<BodyOptions, 'x' | 'y' | 'angle' | 'vx' | 'vy' | 'spin'>>

export interface Grab {
  /** Where the pointer is, px, and when it was there, s on any clock. */
  moveTo(x: number, y: number, seconds: number): void
  /**
   * Lets go: the body leaves with the pointer's velocity if it kept up with one that moved just now, else, or
   * if that is slow, with its own; at most `MAX_TOSS`. A body that another grab still holds is not thrown.
   */
  release(): void
}

/** px (and rad), the farthest that anything lies from the stage's corner: beyond it poses lose precision. */
export const FAR = 1e6

/** `value`, or `otherwise` if it is no finite number. */
export function finite(value: unknown, otherwise = 0): number {
  return typeof value === 'number' && value - value === 0 ? value : otherwise
}

/** `value` brought between `least` and `most`; `otherwise` if it is not a finite number. */
export function within(value: unknown, least: number, most: number, otherwise: number): number {
  return Math.max(least, Math.min(most, finite(value, otherwise)))
}

/** px; a size below 1 px, or none, counts as 1 px. */
export function sizeOf(value: number): number {
  return within(value, 1, FAR, 0)
}

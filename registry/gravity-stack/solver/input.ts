export interface Vector {
  x: number
  y: number
}

/** px. */
export type Box = [left: number, top: number, right: number, bottom: number]

export interface BodyOptions {
  /** px, outer size and corner radius. */
  width: number
  height: number
  radius: number
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

export type Motion = Partial<Pick<BodyOptions, 'x' | 'y' | 'angle' | 'vx' | 'vy' | 'spin'>>

export interface Grab {
  /** Where the pointer is, px, and when it was there, s on any clock. */
  moveTo(x: number, y: number, seconds: number): void
  /**
   * Lets go. A body that kept up with a pointer still moving takes its velocity, of a slow one only a share.
   * Otherwise it keeps its own. It leaves at `MAX_TOSS` at most. A body that another grab still holds is not
   * thrown.
   */
  release(): void
}

/** px (and rad), the farthest that anything lies from the stage's corner: beyond it poses lose precision. */
export const FAR = 1e6

/** `value` brought between `least` and `most`; `otherwise` if it is not a finite number. */
export function within(value: unknown, least: number, most: number, otherwise: number): number {
  const number = typeof value === 'number' && value - value === 0 ? value : otherwise
  return Math.max(least, Math.min(most, number))
}

/** px; a size below 1 px, or none, counts as 1 px. */
export function sizeOf(value: number): number {
  return within(value, 1, FAR, 0)
}

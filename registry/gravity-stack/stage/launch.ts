import { ANGULAR_DAMPING } from '../solver/constants'
import type { Vector } from '../solver/input'
import { scatter } from './release'

/** px/s², the least gravity that launches are computed for (D-002). */
const LEAST_GRAVITY = 100
/**
 * Largest sideways share of a launch's speed. With twice as much, 5 of 15 shaken chips end upside down
 * (D-002).
 */
const SIDEWAYS = 0.15

/**
 * The launch with this number sends a chip about `height` px up, which is against gravity (px/s²), and a
 * little aside (px/s). Its spin (rad/s) brings a chip that is drawn at `angle` upright by the time it comes
 * down.
 */
export function launchMotion(number: number, height: number, { x, y }: Vector, angle: number) {
  const length = Math.sqrt(x * x + y * y)
  const either = (channel: number) => 2 * scatter(number, channel) - 1
  const pull = Math.max(length, LEAST_GRAVITY)
  const speed = Math.sqrt(2 * height * pull)
  const vx = SIDEWAYS * speed * either(1)
  const vy = speed * (0.1 * either(2) - 0.9)
  const flight = (-2 * vy) / pull
  // The share of the spin that drag leaves on average over the flight, (1 − e⁻ˣ) / x, to within a thousandth.
  const drag = ANGULAR_DAMPING * flight
  const turning = flight / (1 + drag / 2 + (drag * drag) / 12)
  const whole = 2 * Math.PI
  const downX = length && x / length
  const downY = length ? y / length : 1
  return {
    vx: vx * downY + vy * downX,
    vy: vy * downY - vx * downX,
    spin: (whole * Math.round(angle / whole) - angle) / turning,
  }
}

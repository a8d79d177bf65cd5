import { ANGULAR_DAMPING } from '../solver/constants'
import { scatter } from './release'

/** px/s² of the least gravity that kicks are made for. */
const KICK_GRAVITY = 100
/** Share of a kick's speed that goes aside at most. With twice as much every third of 15 shaken chips rolls onto its head as it lands. */
const KICK_ASIDE = 0.15

/**
 * The kick with this number: velocity (px/s) that sends a chip about `height` px up, a little aside, and the spin (rad/s) with which a
 * chip drawn at `angle` is upright again when it comes down.
 */
export function kickOf(number: number, height: number, gravity: number, angle: number) {
  const either = (channel: number) => 2 * scatter(number, channel) - 1
  const pull = Math.max(gravity, KICK_GRAVITY)
  const speed = Math.sqrt(2 * height * pull)
  const vy = speed * (0.1 * either(2) - 0.9)
  const flight = (-2 * vy) / pull
  // What the air leaves of the spin, over the flight: (1 − e⁻ˣ) / x to within a thousandth.
  const drag = ANGULAR_DAMPING * flight
  const turning = flight / (1 + drag / 2 + (drag * drag) / 12)
  const whole = 2 * Math.PI
  return {
    vx: KICK_ASIDE * speed * either(1),
    vy,
    spin: (whole * Math.round(angle / whole) - angle) / turning,
  }
}

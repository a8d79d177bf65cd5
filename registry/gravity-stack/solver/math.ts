import { ANGLE, type Bodies, COS, type Damping, MOTION, ROTATED_TO, SIN, STATE } from './state'

/** Makes every array of `owner` twice as long. */
export function grow(owner: object): void {
  const named = owner as Record<string, Int32Array>
  for (const name in named) {
    const from = named[name]
    if (!ArrayBuffer.isView(from)) continue
    named[name] = new (from.constructor as typeof Int32Array)(from.length * 2)
    named[name].set(from)
  }
}

/**
 * Brings the rotation of body `i` up to its angle by + − × ÷ alone: Math.sin is not the same in every engine.
 */
export function updateRotation({ state, motion }: Bodies, i: number): void {
  const m = i * MOTION
  const angle = state[i * STATE + ANGLE]
  if (angle === motion[m + ROTATED_TO]) return
  const quarter = Math.round(angle / (Math.PI / 2))
  // The rest is at most 0.79 rad, where the series is short.
  const a = angle - quarter * (Math.PI / 2)
  let sin = 1
  let cos = 1
  for (let k = 16; k > 1; k -= 2) {
    sin = 1 - ((a * a) / (k * (k + 1))) * sin
    cos = 1 - ((a * a) / (k * (k - 1))) * cos
  }
  sin *= a
  const odd = quarter & 1
  const turn = quarter & 3
  motion[m + COS] = (odd ? sin : cos) * (turn === 1 || turn === 2 ? -1 : 1)
  motion[m + SIN] = (odd ? cos : sin) * (turn > 1 ? -1 : 1)
  motion[m + ROTATED_TO] = angle
}

/**
 * Damping (1/s) over `h` seconds, by series: Math.exp is not the same in every engine. Exact for c·h ≤ 0.5.
 */
export function dampingOver(damping: number, h: number): Damping {
  const z = -damping * h
  let term = 1
  let fade = 0
  let reach = 0
  let fall = 0
  for (let k = 1; k < 19; k++) {
    fade += term
    reach += term / k
    fall += term / (k * (k + 1))
    term *= z / k
  }
  return { fade, reach: reach * h, fall: fall * h * h }
}

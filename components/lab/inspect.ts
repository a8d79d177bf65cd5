import {
  ARM_NB,
  ARM_TB,
  CONTACT,
  FIRST_CHIP,
  INV_MASS,
  NORMAL_IMPULSE,
  NORMAL_X,
  NORMAL_Y,
  SECOND,
  STATE,
  TANGENT_IMPULSE,
  X,
  Y,
} from '@/registry/gravity-stack/solver/state'
import type { World } from '@/registry/gravity-stack/world'

// Looks into a world for those who draw what the solver thinks: its contacts, as it holds them after a step.

/** Where two chips touch, or a chip and the stage. */
type Touch = {
  /** px of the stage. */
  x: number
  y: number
  /** Mean force on the chip over the last step, normal and friction together, in density · px³/s². */
  forceX: number
  forceY: number
}

type Inspection = {
  touches: Touch[]
  /** By id: the lowest id among all that touch each other, at any remove. */
  islands: Map<number, number>
  /** Pairs that the broad phase keeps, and those of them that touch. */
  pairs: number
  contacts: number
}

export function inspect({ scene }: World): Inspection {
  const { bodies, contacts } = scene
  const { data, pair, points } = contacts
  const islands = new Map<number, number>()
  for (let id = FIRST_CHIP; id < bodies.count; id++) if (bodies.alive[id]) islands.set(id, id)
  const find = (id: number): number => {
    const next = islands.get(id) ?? id
    return next === id ? id : find(next)
  }
  const touches: Touch[] = []
  let pairs = 0
  let count = 0
  for (let c = 0; c < contacts.count; c++) {
    const [a, b] = [pair[2 * c], pair[2 * c + 1]]
    if (b === 0) continue
    pairs++
    const k = c * CONTACT
    if (points[c] === 0) continue
    count++
    if (a >= FIRST_CHIP) {
      const [i, j] = [find(a), find(b)]
      islands.set(Math.max(i, j), Math.min(i, j))
    }
    const [nx, ny] = [data[k + NORMAL_X], data[k + NORMAL_Y]]
    const rate = 1 / scene.h
    const whole = data[k + NORMAL_IMPULSE] + data[k + NORMAL_IMPULSE + SECOND]
    for (let point = 0; point < points[c]; point++) {
      const record = k + point * SECOND
      // From its centre, the point of B lies `ARM_TB` along the normal and `ARM_NB` across it.
      const arm = data[record + ARM_NB]
      const load = data[record + NORMAL_IMPULSE] * rate
      const drag = whole > 0 ? (data[k + TANGENT_IMPULSE] * load) / whole : 0
      touches.push({
        x: bodies.state[b * STATE + X] + data[k + ARM_TB] * nx + arm * ny,
        y: bodies.state[b * STATE + Y] + data[k + ARM_TB] * ny - arm * nx,
        forceX: nx * load - ny * drag,
        forceY: ny * load + nx * drag,
      })
    }
  }
  for (const id of islands.keys()) islands.set(id, find(id))
  return { touches, islands, pairs, contacts: count }
}

/** Mean mass of the chips, in units of density · px². */
export function meanMass({ scene: { bodies } }: World): number {
  let sum = 0
  let count = 0
  for (let id = FIRST_CHIP; id < bodies.count; id++) {
    if (!bodies.alive[id]) continue
    sum += 1 / bodies.state[id * STATE + INV_MASS]
    count++
  }
  return count > 0 ? sum / count : 1
}

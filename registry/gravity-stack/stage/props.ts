import { BOUNCE, FRICTION, GRAVITY } from '../solver/constants'
import { type Vector, within } from '../solver/input'

/** Default and largest value of each number that a caller may give; the least is 0. The stagger is in ms. */
export const LIMITS = {
  gravity: [GRAVITY, 20000],
  bounce: [BOUNCE, 1],
  friction: [FRICTION, 10],
  stagger: [150, 60000],
  push: [0, 1000],
} as const

/** A ref, as React and callers make them. */
type Target = { readonly current: Element | null }

/** The props that a caller has given to the stage, unchecked. */
export interface StageProps {
  gravity?: number | Vector | undefined
  ceiling: boolean
  push?: number | undefined
  obstacles?: Target | Target[] | undefined
  bounce?: number | undefined
  friction?: number | undefined
  stagger?: number | undefined
  interactive: boolean
  upright: boolean
  /** False: the first chips lie in the stage from the start. */
  initial: boolean
  onSettle?: (() => void) | undefined
}

/** The props that hold: checked, and none left out. */
export type Settings = Omit<StageProps, 'gravity'> & {
  [name in keyof typeof LIMITS as Exclude<name, 'gravity'>]: number
} & {
  gravity: Vector
}

declare const process: { env: { NODE_ENV?: string } }

const warned = new Set<string>()

/** Tells a developer once what is wrong, why, and what to do. Bundlers drop the calls from production. */
export function warn(message: string) {
  if (warned.has(message)) return
  warned.add(message)
  console.warn(`GravityStack: ${message}`)
}

/** A value as a warning shows it. Some symbols and objects can't be turned into text. */
function written(value: unknown) {
  try {
    return typeof value === 'string' ? JSON.stringify(value) : String(value)
  } catch {
    return typeof value
  }
}

/** The number that holds for what a caller gave. */
function checkedNumber(name: keyof typeof LIMITS, value: unknown) {
  const [fallback, most] = LIMITS[name]
  const result = within(value, 0, most, fallback)
  if (process.env.NODE_ENV !== 'production' && value !== undefined && result !== value)
    warn(
      `${name} is ${written(value)}, which is not a number from 0 to ${most}, so ${result} stands in for it. Pass a number in that range${name === 'gravity' ? `, or { x, y }, each from -${most} to ${most}` : ''}, or leave ${name} out.`,
    )
  return result
}

/** px/s² to the right and downwards: a number is downwards. */
function checkedGravity(value: unknown): Vector {
  const { x, y } = Object(value) as Vector
  if (x === undefined && y === undefined) return { x: 0, y: checkedNumber('gravity', value) }
  const [, most] = LIMITS.gravity
  const vector = { x: within(x, -most, most, 0), y: within(y, -most, most, 0) }
  if (process.env.NODE_ENV !== 'production' && (vector.x !== x || vector.y !== y))
    warn(
      `gravity is { x: ${written(x)}, y: ${written(y)} }, which is not two numbers from -${most} to ${most}, so { x: ${vector.x}, y: ${vector.y} } stands in for it. Pass both, or one number from 0 to ${most}.`,
    )
  return vector
}

/** The settings that hold for what a caller gave. */
export function checkedProps(given: StageProps): Settings {
  const settings = { ...given } as Settings
  settings.interactive = !!given.interactive
  if (process.env.NODE_ENV !== 'production')
    for (const name of ['interactive', 'upright', 'initial', 'ceiling'] as const)
      if (typeof given[name] !== 'boolean')
        warn(
          `${name} is ${written(given[name])}, which is neither true nor false, so it counts as ${!!given[name]}. Pass true or false.`,
        )
  for (const name of ['bounce', 'friction', 'stagger', 'push'] as const)
    settings[name] = checkedNumber(name, given[name])
  settings.gravity = checkedGravity(given.gravity)
  const pointsUp = settings.gravity.y < 0
  // All that falls up would leave for good.
  if (process.env.NODE_ENV !== 'production' && pointsUp && !given.ceiling)
    warn(
      'gravity points up and ceiling is not set, so the top is closed. Set ceiling, or let gravity point down.',
    )
  settings.ceiling = !!given.ceiling || pointsUp
  if (typeof given.onSettle !== 'function') {
    settings.onSettle = undefined
    // `ready && save` is how people leave a callback out.
    if (process.env.NODE_ENV !== 'production' && given.onSettle)
      warn(
        `onSettle is ${written(given.onSettle)}, which can’t be called, so nothing is called. Pass a function, or leave onSettle out.`,
      )
  }
  return settings
}

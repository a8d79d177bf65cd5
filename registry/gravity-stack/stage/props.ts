import { BOUNCE, FRICTION, GRAVITY } from '../solver/constants'

/** Default and largest value of each number that a caller may give; the least is 0. The stagger is in ms. */
export const LIMITS = {
  gravity: [GRAVITY, 20000],
  bounce: [BOUNCE, 1],
  friction: [FRICTION, 10],
  stagger: [150, 60000],
} as const

/** The props that a caller has given to the stage, unchecked. */
export interface StageProps {
  gravity?: number | undefined
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
export type Settings = StageProps & { [name in keyof typeof LIMITS]: number }

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
  const result = Number.isFinite(value) ? Math.min(Math.max(value as number, 0), most) : fallback
  if (process.env.NODE_ENV !== 'production' && value !== undefined && result !== value)
    warn(
      `${name} is ${written(value)}, which is no number from 0 to ${most}, so ${result} stands in for it. Pass one that is, or leave ${name} out.`,
    )
  return result
}

/** The settings that hold for what a caller gave. */
export function checkedProps(given: StageProps): Settings {
  const settings = { ...given } as Settings
  for (const name of ['interactive', 'upright', 'initial'] as const) {
    settings[name] = !!given[name]
    if (process.env.NODE_ENV !== 'production' && typeof given[name] !== 'boolean')
      warn(
        `${name} is ${written(given[name])}, which is neither true nor false, so it counts as ${!!given[name]}. Pass true or false.`,
      )
  }
  for (const name of Object.keys(LIMITS) as (keyof typeof LIMITS)[])
    settings[name] = checkedNumber(name, given[name])
  if (typeof given.onSettle !== 'function') {
    settings.onSettle = undefined
    // `ready && save` is how people leave a callback out.
    if (process.env.NODE_ENV !== 'production' && given.onSettle)
      warn(
        `onSettle is ${written(given.onSettle)}, which can’t be called, so nothing is. Pass a function, or leave it out.`,
      )
  }
  return settings
}

import { BOUNCE, FRICTION, GRAVITY } from '../solver/constants'

/** Default and largest value of each number that a caller may give; none is below 0. The stagger is in ms. */
export const LIMITS = {
  gravity: [GRAVITY, 20000],
  bounce: [BOUNCE, 1],
  friction: [FRICTION, 10],
  stagger: [150, 60000],
} as const

declare const process: { env: { NODE_ENV?: string } }

const warned = new Set<string>()

/** Tells a developer once what is wrong, why, and what to do; bundlers drop it from production. */
export function warn(message: string) {
  if (warned.has(message)) return
  warned.add(message)
  console.warn(`GravityStack: ${message}`)
}

/** A value as a warning shows it. Symbols and objects of no kind can't be put in a text as they are. */
export function written(value: unknown) {
  try {
    return typeof value === 'string' ? JSON.stringify(value) : String(value)
  } catch {
    return typeof value
  }
}

/** The number that stands for what a caller wrote. */
export function sane(name: keyof typeof LIMITS, value: unknown) {
  const [fallback, most] = LIMITS[name]
  const result = Number.isFinite(value) ? Math.min(Math.max(value as number, 0), most) : fallback
  if (process.env.NODE_ENV !== 'production' && value !== undefined && result !== value)
    warn(
      `${name} is ${written(value)}, which is no number from 0 to ${most}, so ${result} stands in for it. Pass one that is, or leave ${name} out.`,
    )
  return result
}

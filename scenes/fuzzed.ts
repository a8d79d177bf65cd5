// Random scenes: what one is, what has to hold in it, and those that have failed once.
import { halfExtent } from './exact-distance'
import found from './found.json'
import type { Chip, Conditions } from './scene'

/** Something done to a running scene, before the step of its frame. */
export type Act = { frame: number } & (
  | { do: 'remove'; chip: number }
  | { do: 'resize'; width: number; height: number }
  | { do: 'reshape'; chip: number; width: number; height: number; radius: number }
  | { do: 'place'; chip: number; x: number; y: number }
  | { do: 'configure'; gravity: number }
  /** Takes hold of a chip at its centre and drags it there within 30 frames, then lets go. */
  | { do: 'drag'; chip: number; x: number; y: number }
)

/** Any number in it may be none, or out of all range. */
export type FuzzScene = { width: number; height: number; conditions: Conditions; chips: Chip[]; acts: Act[] }

/** Frames that a drag lasts. */
export const dragFrames = 30

/** What is checked; each holds in every scene that it is asked of. */
export const checks = {
  finite: 'every pose and velocity is a finite number',
  outside: 'no chip is outside the stage by more than 1 px at the end of a frame',
  energy: 'energy never rises above what was put in by more than 0.1 %',
  recovery:
    'chips that start in one another part at no more than 1,000 px/s, beyond twice what a fall gives by then',
  asleep: 'all sleep within 6 s of the last landing',
  overlap: 'chips at rest overlap by no more than 0.05 px',
  hanging: 'no chip hangs in the air at rest',
} as const

export type Check = keyof typeof checks

/** A scene that went wrong, as small as it could be made; `open` while it still does. */
export type Found = { name: string; check: Check; open?: true; scene: FuzzScene }

const reviver = (_: string, value: unknown) =>
  value === 'NaN' || value === 'Infinity' || value === '-Infinity' ? Number(value) : value

/** JSON with the numbers that JSON has no word for, as the formatter likes it. */
export const toJson = (value: unknown) =>
  JSON.stringify(
    value,
    (_, part) => (typeof part === 'number' && !Number.isFinite(part) ? String(part) : part),
    2,
  ).replaceAll('e+', 'e')
export const fromJson = (text: string) => JSON.parse(text, reviver)

export const foundScenes: Found[] = fromJson(JSON.stringify(found))

const finite = (value: number | undefined, otherwise: number) =>
  value !== undefined && Number.isFinite(value) ? value : otherwise
const within = (value: number | undefined, least: number, most: number, otherwise: number) =>
  Math.max(least, Math.min(most, finite(value, otherwise)))
const size = (value: number) => within(value, 1, 1e6, 1)

const shapeOf = (shape: { width: number; height: number; radius?: number }) => {
  const width = size(shape.width)
  const height = size(shape.height)
  return { width, height, radius: within(shape.radius, 0, Math.min(width, height) / 2, 0) }
}

/**
 * The scene as the world takes it, by what is documented: what is no number counts as left out (a size as 1
 * px), what is out of range as the nearest that is in it, and nothing is faster than 3600 px/s or 1000 rad/s.
 */
export function sane(scene: FuzzScene): FuzzScene {
  const given = scene.conditions
  return {
    width: size(scene.width),
    height: size(scene.height),
    conditions: {
      gravity: within(given.gravity, -1e5, 1e5, 2600),
      bounce: within(given.bounce, 0, 1, 0.18),
      friction: within(given.friction, 0, 100, 0.4),
      bounceThreshold: within(given.bounceThreshold, 0, 1e6, 90),
      linearDamping: within(given.linearDamping, 0, 30, 0.35),
      angularDamping: within(given.angularDamping, 0, 30, 1.4),
    },
    chips: scene.chips.map((chip) => {
      const [vx, vy] = [finite(chip.vx, 0), finite(chip.vy, 0)]
      const slower = Math.min(1, 3600 / Math.max(1, Math.hypot(vx, vy)))
      const density =
        chip.density !== undefined && chip.density > 0 && chip.density < 1e300 ? chip.density : 1
      return {
        ...shapeOf(chip),
        x: within(chip.x, -1e6, 1e6, 0),
        y: within(chip.y, -1e6, 1e6, 0),
        angle: within(chip.angle, -1e6, 1e6, 0),
        vx: vx * slower,
        vy: vy * slower,
        spin: within(chip.spin, -1000, 1000, 0),
        density: within(density, 1e-6, 1e6, 1),
      }
    }),
    acts: scene.acts.map((act) => {
      if (act.do === 'resize') return { ...act, width: size(act.width), height: size(act.height) }
      return act.do === 'reshape' ? { ...act, ...shapeOf(act) } : act
    }),
  }
}

/** Puts the chips apart: each at its place across, above all that come before it. */
export function apart(scene: FuzzScene): FuzzScene {
  let top = scene.height
  const chips = scene.chips.map((chip) => {
    const known = sane({ ...scene, chips: [chip] }).chips[0]
    const [hx, hy] = halfExtent(known, known.angle)
    const y = Math.floor(top - hy - 2)
    top = y - hy
    return { ...chip, x: Math.max(Math.ceil(hx) + 1, Math.min(Math.floor(scene.width - hx) - 1, known.x)), y }
  })
  return { ...scene, chips }
}

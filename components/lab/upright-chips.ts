import { cornerRadius, type Pose, type Shape } from '@/scenes/exact-distance'

const pill = (width: number) => ({ width, height: 30, radius: 15 })
const card = (width: number) => ({ width, height: 36, radius: 7 })
const square = { width: 42, height: 42, radius: 8 }
const disc = { width: 42, height: 42, radius: 21 }

/** The chips of the figures that show words upside down and the right way up. */
export const chips: [word: string, shape: Shape][] = [
  ['design', pill(76)],
  ['grid', card(60)],
  ['a', square],
  ['motion', pill(80)],
  ['type', pill(60)],
  ['e', disc],
  ['layout', card(76)],
  ['icons', pill(66)],
  ['tone', pill(62)],
  ['rhythm', pill(82)],
  ['g', square],
  ['depth', pill(68)],
]
export const shapes = chips.map(([, shape]) => ({ ...shape, radius: cornerRadius(shape) }))

export const isUpsideDown = ({ angle }: Pick<Pose, 'angle'>) => Math.cos(angle) < 0

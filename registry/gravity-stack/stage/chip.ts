import type { Release } from './release'

// From here on there is a DOM. Layout is read in observers and by pointers that are down, written in the frame loop as transforms.
// React renders the chips' wrappers and never touches their style or state again: those are the stage's.

/** A child of the stage, in the element that the component wraps it in. */
export interface Chip extends Release {
  element: HTMLElement
  state: 'waiting' | 'falling' | 'held' | 'resting'
  /** rad by which it is drawn turned on its body, and whether that stays. */
  turn: number
  turned: boolean
  /** Pose as drawn, its turn included, and what draws it smaller in a hand. */
  x: number
  y: number
  angle: number
  pinch: string
  /** Whether styles have been told its angle since it was last drawn. */
  told?: boolean
}

/** Reads the corner radius that a chip is drawn with, and has `changes` watch what it comes from. */
export function look(chip: Chip, changes: MutationObserver) {
  // Its face is its first child that takes up room: words for screen readers and styles stand beside what is drawn. Mere words have none.
  let face: CSSStyleDeclaration | undefined
  let next: Element | null
  for (
    let child = chip.element.matches('[data-words]') ? null : chip.element.firstElementChild;
    child;
    child = next
  ) {
    const style = getComputedStyle(child)
    // One without a box of its own is drawn as what is in it.
    next = style.display === 'contents' ? child.firstElementChild : child.nextElementSibling
    if (/none|contents|absolute|fixed/.test(style.display + style.position)) continue
    // The wrapper is not watched: its style changes with every frame, by the stage's own hand.
    changes.observe(child, { attributeFilter: ['class', 'style'] })
    face = style
    break
  }
  if (!face) chip.element.style.borderRadius = ''
  // The least of the four corners, so that nothing drawn reaches out of its body. A share means one of the shorter side.
  // WebKit tells Tailwind's `rounded-full` as it was written: infinity * 1px.
  const corners = (face ?? getComputedStyle(chip.element)).borderRadius
    .replace(/(calc.)?infinity . /g, '9e9')
    .split(/[ /]+/)
  const short = Math.min(chip.width, chip.height)
  chip.radius = Math.min(
    ...corners.map((corner) => (Number.parseFloat(corner) || 0) * (/%/.test(corner) ? short / 100 : 1)),
    short / 2,
  )
}

/** Where nothing is drawn nothing is pressed either: a click beside a round chip is that of the chip below. */
export function round({ element, radius }: Chip) {
  element.style.borderRadius = `${radius}px`
}

/** px, how far below its middle a chip reaches that is drawn at `angle`. */
export function halfHeight({ width, height, radius }: Chip, angle: number) {
  const sin = Math.abs(Math.sin(angle))
  const cos = Math.abs(Math.cos(angle))
  return (width / 2 - radius) * sin + (height / 2 - radius) * cos + radius
}

export function draw(chip: Chip) {
  const { element, x, y, angle } = chip
  const at = `translate(${(x - chip.width / 2).toFixed(2)}px,${(y - chip.height / 2).toFixed(2)}px)rotate(${angle.toFixed(4)}rad)`
  element.style.transform = at + chip.pinch
  // Chromium matches an element whose `style` holds a custom property against all rules each time that its `style` changes.
  if (chip.told) element.style.removeProperty('--chip-angle')
  chip.told = false
}

/** Gives styles the angle at which a chip lies: with it they can draw a shadow that falls down the screen. */
export function tellAngle(chip: Chip) {
  const turns = chip.angle / (2 * Math.PI)
  chip.element.style.setProperty('--chip-angle', `${Math.round(360 * (turns - Math.round(turns)))}deg`)
  chip.told = true
}

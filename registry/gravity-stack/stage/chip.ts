import type { Release } from './release'

// The modules from here on know the DOM. The layout is read in observers and pointer events. The frame loop
// writes transforms. React renders the wrappers of the chips and never touches their style and state again:
// those belong to the stage.

/** A child of the stage, in the element that the component wraps it in. */
export interface Chip extends Release {
  element: HTMLElement
  state: 'waiting' | 'falling' | 'held' | 'resting'
  /** rad by which the chip is drawn turned on its body. */
  turn: number
  /** Whether `turn` is final. */
  turned: boolean
  /** Pose in which the chip is drawn, `turn` included; x is not a number before the chip is first drawn. */
  x: number
  y: number
  angle: number
  /** CSS transforms that draw a held chip smaller. */
  pinch: string
  /** Whether the style of the chip holds `--chip-angle`. */
  hasAngle?: boolean
}

/**
 * Reads the corner radius that a chip is drawn with, and has `changes` watch the style that it comes from.
 */
export function measureRadius(chip: Chip, changes: MutationObserver) {
  const { element, width, height } = chip
  // The face of a chip is its first child that takes up room: not words for screen readers, not style
  // elements. Mere words have none and are drawn on the wrapper.
  let next: Element | null
  for (let child = element.matches('[data-words]') ? null : element.firstElementChild; child; child = next) {
    const style = getComputedStyle(child)
    // An element without a box of its own is drawn as its children.
    next = style.display === 'contents' ? child.firstElementChild : child.nextElementSibling
    if (/none|contents|absolute|fixed/.test(style.display + style.position)) continue
    // The wrapper is not watched: the stage itself changes its style in every frame.
    changes.observe(child, { attributeFilter: ['class', 'style'] })
    chip.radius = cornerRadius(style, width, height)
    return
  }
  element.style.borderRadius = ''
  chip.radius = cornerRadius(getComputedStyle(element), width, height)
}

/** px, the least of the four corner radii of a style, as nothing drawn may reach out of the body. */
export function cornerRadius({ borderRadius }: CSSStyleDeclaration, width: number, height: number) {
  const short = Math.min(width, height)
  // WebKit returns Tailwind's `rounded-full` as it was written: infinity * 1px.
  const corners = borderRadius.replace(/(calc.)?infinity . /g, '9e9').split(/[ /]+/)
  // A percentage is taken of the shorter side.
  const toPx = (corner: string) => (Number.parseFloat(corner) || 0) * (/%/.test(corner) ? short / 100 : 1)
  return Math.min(...corners.map(toPx), short / 2)
}

/** Rounds the wrapper like its chip, so that a click beside a round chip goes to the chip below. */
export function applyCornerRadius({ element, radius }: Chip) {
  element.style.borderRadius = `${radius}px`
}

export function draw(chip: Chip) {
  const { element, x, y, angle } = chip
  const at = `translate(${(x - chip.width / 2).toFixed(2)}px,${(y - chip.height / 2).toFixed(2)}px)rotate(${angle.toFixed(4)}rad)`
  element.style.transform = at + chip.pinch
  // While a style holds a custom property, Chromium matches its element against all rules each time the style
  // changes.
  if (chip.hasAngle) element.style.removeProperty('--chip-angle')
  chip.hasAngle = false
}

/** px², the square of 0.11 px. A chip is drawn again once a corner has moved so far (D-062). */
const VISIBLE = 0.0121

/** Draws a chip in this pose unless nobody would see the difference, and says whether it is at rest. */
export function drawAt(chip: Chip, x: number, y: number, angle: number, asleep: boolean) {
  const dx = x - chip.x
  const dy = y - chip.y
  const swung = (angle - chip.angle) * chip.reach
  // All radii of this frame have been read by now: a read after a write would compute the styles twice.
  if (Number.isNaN(chip.x)) applyCornerRadius(chip)
  // The comparison is false for a chip that was never drawn. A chip that has fallen asleep is drawn where it
  // lies, even if its last movement was too small to see.
  if (asleep || !(dx * dx + dy * dy + swung * swung < VISIBLE)) {
    chip.x = x
    chip.y = y
    chip.angle = angle
    draw(chip)
  }
  if (chip.state !== 'held') setState(chip, asleep ? 'resting' : 'falling')
}

/** Tells styles the angle of a chip at rest, so that they can draw a shadow that falls down the screen. */
export function exposeAngle(chip: Chip) {
  const turns = chip.angle / (2 * Math.PI)
  chip.element.style.setProperty('--chip-angle', `${Math.round(360 * (turns - Math.round(turns)))}deg`)
  chip.hasAngle = true
}

export function setState(chip: Chip, next: Chip['state']) {
  if (chip.state === next) return
  const { element } = chip
  chip.state = next
  element.setAttribute('data-state', next)
  if (next === 'waiting') {
    // The chip waits unseen at the top of the stage. Later it is no nearer to the front than others, unless
    // it has the focus.
    element.style.transform = ''
    if (!element.matches(':focus-within')) element.style.zIndex = ''
  }
}

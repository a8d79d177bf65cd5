import { chipAt } from './children'
import type { Chip } from './chip'

/** Elements that use presses themselves, so that no drag of their chip begins there (D-066). */
export const EDITABLE =
  'input, textarea, select, [controls], [contenteditable]:not([contenteditable=false]), [role=slider], [data-slot=slider], [data-no-grab]'
/** Elements that use clicks themselves, so that their chip does not hop (D-066). */
export const CONTROL = `${EDITABLE}, a, button, label, summary, [tabindex]`
/**
 * Elements inside a chip whose presses are not about it: the chips of a stage in it, and what the browser
 * draws over the page (D-066).
 */
const OVERLAY = 'dialog, [popover], :fullscreen, [data-slot=gravity-stack-chip]'

/** Whether an event is about an element of a kind inside the chip, in a shadow tree too. */
export function isInside({ element }: Chip, event: Event, kind: string) {
  const path = event.composedPath() as Element[]
  return path.slice(0, path.indexOf(element)).some((inner) => inner.matches?.(kind))
}

/** The chip in the world that an event is about. */
export function chipUnder(event: Event, chips: Map<Element, Chip>) {
  const chip = chipAt(chips, event.target)
  return chip && chip.id >= 0 && !isInside(chip, event, OVERLAY) ? chip : undefined
}

/** Whether a press is on a scroll bar, outside of the content that its target shows. */
export function isOnScrollBar({ target, offsetX, offsetY }: PointerEvent) {
  const { clientWidth, clientHeight } = target as Element
  const onContent = offsetX >= 0 && offsetY >= 0 && offsetX < clientWidth && offsetY < clientHeight
  return !onContent && /auto|scroll/.test(getComputedStyle(target as Element).overflow)
}

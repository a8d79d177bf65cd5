import type { Chip } from './chip'

/** The chip that an element is, or is in. */
export function chipAt(chips: Map<Element, Chip>, target: EventTarget | null) {
  let node = target as Element | null
  while (node && !chips.has(node)) node = node.parentElement
  return chips.get(node!)
}

/** Brings `chips` in line with the child elements, in their order; returns what `chips` held before. */
export function collectChips(root: HTMLElement, chips: Map<Element, Chip>) {
  // Chromium takes a waiting chip, clipped to nothing, for out of view: its images would never load.
  root.querySelectorAll<HTMLImageElement>('[loading=lazy]').forEach((lazy) => {
    lazy.loading = 'eager'
  })
  const before = new Map(chips)
  chips.clear()
  root.querySelectorAll<HTMLElement>(':scope>[data-slot=gravity-stack-chip]').forEach((element) => {
    const fresh = { element, state: 'waiting', width: 0, id: -1, turn: 0, angle: 0, pinch: '' }
    chips.set(element, before.get(element) ?? (fresh as Chip))
  })
  return before
}

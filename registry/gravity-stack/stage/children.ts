import type { Chip } from './chip'

/** The chip that an element is, or is in. */
export function chipAt(chips: Map<Element, Chip>, target: EventTarget | null) {
  let node = target as Element | null
  while (node && !chips.has(node)) node = node.parentElement
  return chips.get(node!)
}

/** Brings `chips` in line with the child elements, in their order; returns the chips that came and went. */
export function collectChips(root: HTMLElement, chips: Map<Element, Chip>) {
  // Chromium takes a waiting chip, clipped to nothing, for out of view: its images would never load.
  root.querySelectorAll('[loading=lazy]').forEach((lazy) => {
    lazy.setAttribute('loading', 'eager')
  })
  const added: Chip[] = []
  const gone = new Map(chips)
  chips.clear()
  root.querySelectorAll<HTMLElement>(':scope>[data-slot]:not([data-static])').forEach((element) => {
    let chip = gone.get(element)
    if (!chip) {
      chip = { element, state: 'waiting', width: 0, radius: Number.NaN, id: -1, angle: 0, pinch: '' } as Chip
      added.push(chip)
    }
    gone.delete(element)
    chips.set(element, chip)
  })
  return { added, gone: Array.from(gone.values()) }
}

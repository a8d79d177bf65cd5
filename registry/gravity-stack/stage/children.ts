import type { Chip } from './chip'

/** The chips of a stage: one for each child that React has rendered into it. */
export function createChildren(root: HTMLElement) {
  const chips = new Map<Element, Chip>()
  return {
    chips,

    /** The chip that an element is, or is in. */
    chipAt(target: EventTarget | null) {
      let node = target as Element | null
      while (node && !chips.has(node)) node = node.parentElement
      return chips.get(node!)
    },

    /** The chips in the order of the child elements. */
    inOrder: () => Array.from(root.children).flatMap((element) => chips.get(element) ?? []),

    /** Calls `add` with a chip for each new child element; returns the chips whose elements are gone. */
    collect(add: (chip: Chip) => void) {
      // Chromium takes a chip that waits, and is clipped to nothing, for out of view: what is in it would
      // never load.
      for (const lazy of Array.from(root.querySelectorAll('[loading=lazy]')))
        lazy.setAttribute('loading', 'eager')
      for (const element of Array.from(root.children) as HTMLElement[]) {
        if (chips.has(element) || !element.matches('[data-slot]:not([data-static])')) continue
        const chip = {
          element,
          state: 'waiting',
          width: 0,
          radius: Number.NaN,
          id: -1,
          angle: 0,
          pinch: '',
        } as Chip
        chips.set(element, chip)
        add(chip)
      }
      const gone = Array.from(chips.values()).filter(({ element }) => element.parentNode !== root)
      for (const { element } of gone) chips.delete(element)
      return gone
    },
  }
}

export type Children = ReturnType<typeof createChildren>

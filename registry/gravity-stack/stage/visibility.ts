export type View = typeof globalThis & Window

type Observers = { view: IntersectionObserver; near: IntersectionObserver }

const observers = new WeakMap<View, Observers>()
/** What is called with each entry of a stage, whether it is near the view or in it. */
export const watched = new WeakMap<Element, (entry: IntersectionObserverEntry, near: boolean) => void>()

/** Tell what of those that are in `watched` is in view, and what is within a screen of it; all stages of a window share them. */
export function observersOf(view: View): Observers {
  let both = observers.get(view)
  if (!both) {
    const observer = (near: boolean, options: object) =>
      new view.IntersectionObserver((entries) => {
        for (const entry of entries) watched.get(entry.target)?.(entry, near)
      }, options)
    both = {
      // Of a very tall stage even a hundredth may be all that fits.
      view: observer(false, { threshold: Array.from({ length: 101 }, (_, i) => i / 100) }),
      near: observer(true, { rootMargin: '100%' }),
    }
    observers.set(view, both)
  }
  return both
}

/** The element around another, outside of a shadow tree too. */
function above(node: Element): Element | null | undefined {
  return node.parentElement ?? (node.getRootNode() as Partial<ShadowRoot>).host
}

/** px², the most of the stage that can be seen at once: what it scrolls in shows no more, nor does the window. */
export function shownAtMost({
  target: root,
  rootBounds,
  boundingClientRect: whole,
}: IntersectionObserverEntry) {
  const { body, defaultView } = root.ownerDocument
  // A frame of another site is not told how large the window is, one of the same site that of the page around it.
  let wide = Math.min(rootBounds?.width ?? Infinity, defaultView!.innerWidth)
  let high = Math.min(rootBounds?.height ?? Infinity, defaultView!.innerHeight)
  for (let node = above(root); node; node = above(node)) {
    // What the body says of overflow counts for the window.
    if (node === body || !/auto|scroll|hidden|clip/.test(getComputedStyle(node).overflow)) continue
    wide = Math.min(wide, node.clientWidth)
    high = Math.min(high, node.clientHeight)
  }
  return Math.min(wide, whole.width) * Math.min(high, whole.height)
}

import type { Context } from './context'
import { warn } from './props'

/**
 * Share of the stage in view that starts the drop; or, if it is large, share of what fits into view (D-064).
 */
const IN_VIEW = 0.25
const FILLS_VIEW = 0.5
/** Thresholds at which an observer tells what share of an element is in view. */
export const EVERY_PERCENT: number[] = Array.from({ length: 101 }, (_, i) => i / 100)
/** ms until a stage that a transform has scaled to nothing is checked again (D-064). */
const CHECK_AGAIN = 200

/** The element around another, outside of a shadow tree too. */
function above(node: Element): Element | null | undefined {
  return node.parentElement ?? (node.getRootNode() as Partial<ShadowRoot>).host
}

/** px², the largest part of the stage that fits into the window and the elements that it scrolls in. */
function shownAtMost({ target: root, rootBounds, boundingClientRect: whole }: IntersectionObserverEntry) {
  const { body, defaultView } = root.ownerDocument
  // A frame of another site has no root bounds. To a frame of the same site they are those of the page around
  // it.
  let wide = Math.min(rootBounds?.width ?? Infinity, defaultView!.innerWidth)
  let high = Math.min(rootBounds?.height ?? Infinity, defaultView!.innerHeight)
  // The overflow of the body applies to the window.
  for (let node = above(root); node && node !== body; node = above(node)) {
    if (!/auto|scroll|hidden|clip/.test(getComputedStyle(node).overflow)) continue
    wide = Math.min(wide, node.clientWidth)
    high = Math.min(high, node.clientHeight)
  }
  return Math.min(wide, whole.width) * Math.min(high, whole.height)
}

/**
 * Knows whether a stage is in view; calls `approach` when the stage first comes within a screen of the view.
 */
export function createVisibility({ root, view, update }: Context, approach: () => void) {
  let timer: ReturnType<typeof setTimeout> | undefined
  const nearby = new view.IntersectionObserver(
    (entries) => {
      if (!entries.some(({ isIntersecting }) => isIntersecting)) return
      nearby.disconnect()
      observer.observe(root)
      approach()
    },
    { rootMargin: '100%' },
  )
  const observer = new view.IntersectionObserver((entries) => entries.forEach(inspect), {
    // Of a very tall stage even a hundredth may be all that fits into the window.
    threshold: EVERY_PERCENT,
  })

  function inspect(entry: IntersectionObserverEntry) {
    const { isIntersecting, intersectionRatio, intersectionRect: shown, boundingClientRect: whole } = entry
    visibility.inView = isIntersecting
    visibility.wasInView ||= isIntersecting
    const area = shown.width * shown.height
    // Without a size the ratio is 1 as soon as the stage is anywhere in view.
    visibility.started ||=
      area > 0 && (intersectionRatio >= IN_VIEW || area > FILLS_VIEW * shownAtMost(entry))
    clearTimeout(timer)
    if (isIntersecting && !(whole.width * whole.height)) {
      const { clientWidth, clientHeight } = root
      if (clientWidth * clientHeight)
        // A stage that a transform has scaled to nothing is as much in view as later, so no entry would tell
        // when it grows.
        timer = setTimeout(visibility.checkAgain, CHECK_AGAIN)
      else if (process.env.NODE_ENV !== 'production')
        warn(
          `a stage is ${clientWidth} px wide and ${clientHeight} px high, so nothing falls until it is larger. Give it a height such as h-80, and its container a width.`,
        )
    }
    update()
  }

  const visibility = {
    /** Whether the drop has started: enough of the stage has been in view. */
    started: false,
    inView: false,
    wasInView: false,

    start() {
      visibility.started = true
    },

    /** Has the browser tell anew what of the stage is in view. */
    checkAgain() {
      observer.disconnect()
      observer.observe(root)
    },

    observe: () => nearby.observe(root),

    disconnect() {
      visibility.inView = false
      nearby.disconnect()
      observer.disconnect()
      clearTimeout(timer)
    },
  }
  return visibility
}

export type Visibility = ReturnType<typeof createVisibility>

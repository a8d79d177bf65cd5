type Observed = {
  shift: number
  /** ms, the slowest of each interaction so far. */
  interactions: Record<string, number>
  writes: number
  frames: number
  /** Counts frames from now on, without a trace of it on the heap. */
  countFrames(): void
}

declare global {
  interface Window {
    observed: Observed
  }
}

/**
 * Runs in a measured page before anything else. Marks when the stage is seen, when it draws its
 * first chip and when it rests; with `counting`, counts frames and writes for good, which costs time itself.
 */
export function observe(counting: boolean) {
  const frame = window.requestAnimationFrame
  const observed: Observed = { shift: 0, interactions: {}, writes: 0, frames: 0, countFrames }
  function countFrames() {
    observed.frames++
    frame.call(window, countFrames)
  }
  window.observed = observed
  /**
   * In the trace, and told aloud: who measures a page asks it nothing meanwhile. It is told later, as a word
   * to the console costs a page that is slowed four times as much as a frame.
   */
  function mark(name: string) {
    performance.mark(name)
    setTimeout(() => console.debug(name), 300)
  }
  new PerformanceObserver((list) => {
    for (const entry of list.getEntries()) observed.shift += (entry as unknown as { value: number }).value
  }).observe({ type: 'layout-shift', buffered: true })
  new PerformanceObserver((list) => {
    for (const { interactionId, duration } of list.getEntries() as PerformanceEventTiming[]) {
      if (!interactionId) continue
      observed.interactions[interactionId] = Math.max(observed.interactions[interactionId] ?? 0, duration)
    }
  }).observe({ type: 'event', durationThreshold: 16 } as PerformanceObserverInit)

  if (counting) {
    window.requestAnimationFrame = (callback) =>
      frame.call(window, (time) => {
        observed.frames++
        callback(time)
      })
  }
  let drawn = false
  const isChip = (target: Node) => (target as Element).getAttribute('data-slot') === 'gravity-stack-chip'
  const drawing = new MutationObserver((records) => {
    const writes = records.filter(({ target }) => isChip(target)).length
    observed.writes += writes
    if (writes === 0 || drawn) return
    drawn = true
    mark('drawn')
    if (!counting) drawing.disconnect()
  })
  drawing.observe(document, { attributeFilter: ['style'], subtree: true })
  addEventListener('DOMContentLoaded', () => {
    // Each stage by itself: its chips come to rest in the same frame, and to hear of them all costs as much.
    for (const stage of document.querySelectorAll('[data-slot=gravity-stack]')) {
      const resting = () => stage.getAttribute('data-state') === 'resting' && mark('rest')
      new MutationObserver(resting).observe(stage, { attributeFilter: ['data-state'] })
    }
    const seen = new IntersectionObserver(
      ([entry]) => {
        if (!entry.isIntersecting) return
        performance.mark('seen')
        seen.disconnect()
      },
      { threshold: 0.25 },
    )
    seen.observe(document.getElementById('root')!)
  })
}

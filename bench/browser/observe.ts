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
  /** In the trace, and told aloud: who measures a page asks it nothing meanwhile. */
  function mark(name: string) {
    performance.mark(name)
    console.debug(name)
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
  new MutationObserver((records) => {
    for (const { target } of records) {
      const { slot, state } = (target as HTMLElement).dataset
      if (slot === 'gravity-stack' && state === 'resting') mark('rest')
    }
  }).observe(document, { attributeFilter: ['data-state'], subtree: true })
  addEventListener('DOMContentLoaded', () => {
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

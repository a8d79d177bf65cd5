declare global {
  interface Window {
    /** Writes what was written during the drop once more, frame by frame, and nothing else. */
    replay(): void
  }
}

const selector = '[data-slot=gravity-stack-chip]'

/**
 * Runs in a measured page before its stage and keeps what each of its frames writes to the chips: played
 * again, it is a drop as the browser would draw it if physics took no time at all. Marks the first frame of
 * that, and its end.
 */
export function record() {
  const frames: { chip: HTMLElement; state?: string; transform: string }[][] = []
  const recorder = new MutationObserver((records) => {
    // What one frame has written comes in one piece.
    const chips = new Set(records.map(({ target }) => target as HTMLElement))
    const written = [...chips].filter((chip) => chip.matches(selector))
    if (written.length === 0) return
    frames.push(written.map((chip) => ({ chip, state: chip.dataset.state, transform: chip.style.transform })))
  })
  recorder.observe(document, { attributeFilter: ['style', 'data-state'], subtree: true })

  window.replay = () => {
    recorder.disconnect()
    for (const chip of document.querySelectorAll<HTMLElement>(selector)) {
      chip.dataset.state = 'waiting'
      chip.style.transform = ''
    }
    let next = -1
    const play = () => {
      if (next === 0) performance.mark('replay')
      for (const { chip, state, transform } of frames[next] ?? []) {
        if (chip.dataset.state !== state) chip.dataset.state = state
        chip.style.transform = transform
      }
      next++
      if (next <= frames.length) return requestAnimationFrame(play)
      performance.mark('replayed')
      console.debug('replayed')
    }
    requestAnimationFrame(play)
  }
}

import { cancelFrame, frame } from 'motion'
import { within } from '../solver/input'
import type { View } from './context'

/** s, the longest time that one frame simulates: after a longer gap the pile goes on where it was (D-065). */
export const LONGEST_FRAME = 0.05

/** Calls `tick` in every frame of a window from `run` on, with the seconds since the frame before. */
export function createFrameLoop(view: View, tick: (seconds: number) => void) {
  /** Whether Motion has called nothing since the window's last frame. */
  let missed = false
  let request = 0
  /** ms, time of the frame before. */
  let last: number | undefined
  let timer: ReturnType<typeof setTimeout> | undefined

  /** Motion's loop calls this after all that animations of the page read. */
  function render() {
    missed = false
    // The frame's own time is smoother than the moment at which its callbacks run.
    const time = Number(view.document.timeline.currentTime)
    const seconds = (time - (last ?? time)) / 1000
    last = time
    tick(within(seconds, 0, LONGEST_FRAME, 0))
  }

  /**
   * Calls itself in the window's own frames, and `render` where Motion's loop stands still. An error in
   * anybody's callback ends Motion's loop for good. A window that the page has opened goes on while the page
   * is hidden.
   */
  function watch() {
    request = view.requestAnimationFrame(watch)
    if (missed) render()
    missed = true
  }

  function stop() {
    clearTimeout(timer)
    cancelFrame(render)
    view.cancelAnimationFrame(request)
    request = 0
    last = undefined
  }

  return {
    run() {
      clearTimeout(timer)
      if (request) return
      frame.render(render, true)
      missed = false
      watch()
    },
    /** Calls `arrive` once, after `seconds` without frames. */
    wait(arrive: () => void, seconds: number) {
      stop()
      timer = setTimeout(arrive, seconds * 1000)
    },
    stop,
  }
}

import { cancelFrame, frame } from 'motion'
import type { View } from './visibility'

/** Calls `tick` once in every frame of a window, from `start` to `stop`. */
export function createLoop(view: View, tick: () => void) {
  /** Whether Motion has called nothing since the window's last frame. */
  let missed = false
  let request = 0

  /** Motion's loop has it write after all that animations of the page read. */
  function run() {
    missed = false
    tick()
  }

  /**
   * The window's own frames, for when Motion's loop stands still. An error in anybody's callback ends that loop for good, and
   * a window opened by the page goes on while the page itself is hidden.
   */
  function watch() {
    request = view.requestAnimationFrame(watch)
    if (missed) tick()
    missed = true
  }

  return {
    start() {
      if (request) return
      frame.render(run, true)
      missed = false
      watch()
    },
    stop() {
      cancelFrame(run)
      view.cancelAnimationFrame(request)
      request = 0
    },
  }
}

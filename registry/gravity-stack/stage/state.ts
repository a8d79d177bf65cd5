/** `data-state` of a stage. */
export type StageState = 'static' | 'waiting' | 'running' | 'paused' | 'resting'

/** What the state of a stage depends on. */
export interface Facts {
  /** People prefer reduced motion, or the page is printed. */
  still: boolean
  /** The stage has come into view and its pile can be shown. */
  ready: boolean
  /** The caller has paused the stage. */
  paused: boolean
  /** No chip moves, and none waits for its release. */
  settled: boolean
  /** The stage is on screen, has a size, and its tab is visible. */
  shown: boolean
}

/** The state that follows from what is known of a stage. */
export function nextState({ still, ready, paused, settled, shown }: Facts): StageState {
  if (still) return 'static'
  if (!ready) return 'waiting'
  if (paused) return 'paused'
  if (settled) return 'resting'
  return shown ? 'running' : 'paused'
}

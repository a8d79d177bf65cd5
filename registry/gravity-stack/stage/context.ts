import type { Chip } from './chip'
import type { Settings } from './props'

export type View = typeof globalThis & Window

/** What the parts of a stage share. */
export interface Context {
  root: HTMLElement
  /**
   * The stage's own window: in one that the page has opened, observers of the page would not see the stage.
   */
  view: View
  /** Matches while the chips stand in a row. */
  still: MediaQueryList
  /** Whether the caller has paused the stage. */
  pausing: { current: boolean }
  settings: Settings
  /** The chips by their elements, in the order of these. */
  chips: Map<Element, Chip>
  /** px, size of the stage, written by `sizes`. The width is 0 while it has none. */
  width: number
  height: number
  /** Brings the state in line with all that is known. Every event ends in it. */
  update(): void
}

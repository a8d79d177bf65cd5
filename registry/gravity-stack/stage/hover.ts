import type { Context } from './context'
import type { Lifecycle } from './lifecycle'
import type { Listen } from './listeners'
import type { StagePile } from './pile'
import { pointerMap } from './pointer-map'

/**
 * s between two moves of a pointer, at least and at most, for its speed: a pointer that stood still sets out
 * at once (D-052).
 */
export const BRIEFEST = 1 / 240
export const LONGEST = 1 / 30

/** Pushes chips aside with the mouse or pen that moves over a stage while nothing is pressed. */
export function followHover(
  on: Listen,
  { root, view, settings, update }: Context,
  pile: StagePile,
  { isLive }: Lifecycle,
) {
  let toStage: DOMMatrix
  let known: DOMRect | undefined
  let last: { x: number; y: number; time: number } | undefined
  // The window listens: a stage that lies over a page may let pointers through.
  on(view, 'pointermove', ({ pointerType, buttons, clientX, clientY, timeStamp }: PointerEvent) => {
    const before = last
    last = undefined
    if (buttons || pointerType === 'touch' || !isLive()) return
    const box = root.getBoundingClientRect()
    if (clientX < box.left || clientX > box.right || clientY < box.top || clientY > box.bottom) return
    if (box.width !== known?.width || box.height !== known.height) toStage = pointerMap(root, box)
    known = box
    const { x, y } = toStage.transformPoint({ x: clientX - box.x, y: clientY - box.y })
    last = { x, y, time: timeStamp / 1000 }
    if (!before) return
    const seconds = Math.min(Math.max(last.time - before.time, BRIEFEST), LONGEST)
    pile.touch()
    pile.world!.push(settings.push, before.x, before.y, x - before.x, y - before.y, seconds)
    update()
  })
}

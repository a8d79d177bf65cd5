import { within } from '../solver/input'
import type { Context } from './context'
import type { Lifecycle } from './lifecycle'
import type { Listen } from './listeners'
import type { StagePile } from './pile'
import { type Place, placeOf } from './pointer-map'

/** s. Bounds of the time between two moves, for their speed: a pointer may have stood still (D-052). */
export const BRIEFEST = 1 / 240
export const LONGEST = 1 / 30

/** Pushes chips aside with the mouse or pen that moves over a stage while nothing is pressed. */
export function followHover(on: Listen, context: Context, pile: StagePile, { isLive }: Lifecycle) {
  const { root, view, settings } = context
  let place: Place | undefined
  let over = false
  // The window listens: a stage that lies over a page may let pointers through.
  on(view, 'pointermove', (event: PointerEvent) => {
    const before = over && place
    over = false
    if (event.buttons || event.pointerType === 'touch' || !isLive()) return
    place = placeOf(event, root, place)
    const { x, y, seconds } = place
    over = x >= 0 && y >= 0 && x <= context.width && y <= context.height
    if (!over || !before) return
    const time = within(seconds - before.seconds, BRIEFEST, LONGEST, LONGEST)
    pile.touch()
    pile.world!.push(settings.push, before.x, before.y, x - before.x, y - before.y, time)
    context.update()
  })
}

import type { PointerEvent } from 'react'
import { TOUCH_DRAG_START, TOUCH_HOLD } from '@/registry/gravity-stack/stage/pointers'
import type { Recorder } from '../lab/recorder'

/** A pointer that is down on a chip, in px and s of the stage. It holds the chip once there is a grab. */
type Press = {
  down: { x: number; y: number }
  at: [x: number, y: number, seconds: number]
  hold: () => void
  timer?: ReturnType<typeof setTimeout>
  grab?: ReturnType<Recorder['grab']>
}

export type Hands = ReturnType<typeof createHands>

/** The pointers that are down on the chips of a pile; `moved` is called when one takes a chip. */
export function createHands(stage: HTMLElement, recorder: Recorder, moved: () => void) {
  const { world, ids } = recorder.pile
  const presses = new Map<number, Press>()

  const point = (event: PointerEvent): [number, number, number] => {
    const box = stage.getBoundingClientRect()
    return [event.clientX - box.left, event.clientY - box.top, event.timeStamp / 1000]
  }

  function letGo(event: PointerEvent) {
    const press = presses.get(event.pointerId)
    clearTimeout(press?.timer)
    // Where the hand stands now: one that has stood still throws nothing.
    press?.grab?.moveTo(...point(event))
    press?.grab?.release()
    presses.delete(event.pointerId)
  }

  // A finger that holds a chip does not scroll. React's own listeners are passive, and can't prevent it.
  function scroll(event: TouchEvent) {
    const holds = [...presses.values()].some(({ grab }) => grab)
    if (holds && event.cancelable) event.preventDefault()
  }
  stage.addEventListener('touchmove', scroll, { passive: false })

  return {
    down(event: PointerEvent<HTMLElement>, chip: number) {
      const id = ids[chip]
      if (id === undefined || event.button !== 0) return
      event.currentTarget.setPointerCapture(event.pointerId)
      const [x, y, seconds] = point(event)
      const start = world.read(id)
      const press: Press = {
        down: { x, y },
        at: [x, y, seconds],
        hold() {
          clearTimeout(press.timer)
          // The chip may have moved on while a finger rested.
          const { x: chipX, y: chipY } = world.read(id)
          press.grab = recorder.grab(chip, chipX + x - start.x, chipY + y - start.y)
          press.grab.moveTo(...press.at)
          moved()
        },
      }
      presses.set(event.pointerId, press)
      if (event.pointerType === 'touch') press.timer = setTimeout(press.hold, TOUCH_HOLD)
      else press.hold()
    },
    move(event: PointerEvent) {
      const press = presses.get(event.pointerId)
      if (!press) return
      press.at = point(event)
      const [dx, dy] = [press.at[0] - press.down.x, press.at[1] - press.down.y]
      if (press.grab) press.grab.moveTo(...press.at)
      else if (Math.hypot(dx, dy) > TOUCH_DRAG_START) {
        // A finger that sets out up or down wants to scroll the page.
        if (Math.abs(dy) > Math.abs(dx)) letGo(event)
        else press.hold()
      }
    },
    letGo,
    /** The chips are gone, and will not hear of the end of what holds them. */
    end() {
      stage.removeEventListener('touchmove', scroll)
      for (const { timer } of presses.values()) clearTimeout(timer)
    },
  }
}

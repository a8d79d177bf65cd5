import type { PointerEvent } from 'react'
import { BRIEFEST, LONGEST } from '@/registry/gravity-stack/stage/hover'
import type { Recorder } from '../lab/recorder'

export type Hover = ReturnType<typeof createHover>

/** The mouse or pen over a pile while nothing is pressed; `pushed` is called when it has pushed a chip. */
export function createHover(stage: HTMLElement, recorder: Recorder, pushed: () => void) {
  let last: { x: number; y: number; seconds: number } | undefined

  return {
    /** The pointer, with its disc of `radius` px, has moved; a disc of 0 px pushes nothing. */
    move({ buttons, clientX, clientY, pointerType, timeStamp }: PointerEvent, radius: number) {
      const before = last
      last = undefined
      if (radius === 0 || buttons || pointerType === 'touch') return
      const box = stage.getBoundingClientRect()
      last = { x: clientX - box.left, y: clientY - box.top, seconds: timeStamp / 1000 }
      if (!before) return
      const { x, y } = before
      const seconds = Math.min(Math.max(last.seconds - before.seconds, BRIEFEST), LONGEST)
      if (recorder.push(radius, [x, y, last.x - x, last.y - y, seconds])) pushed()
    },
    leave() {
      last = undefined
    },
  }
}

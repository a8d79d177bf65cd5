import { type KeyboardEvent, type PointerEvent, useRef } from 'react'
import { classes } from '@/lib/classes'
import { obstacleClass, onSlider, type Settings } from '@/lib/playground'

/** px by which an arrow key moves the obstacle, and by which it does with Shift. */
const keyStep = 16
const fineStep = 2
const arrows: Record<string, [x: number, y: number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
}

/** What chips land on: a pointer drags it, and the arrow keys move it. */
export function Obstacle({
  settings: { obstacleX, obstacleY },
  change,
}: {
  settings: Settings
  change: (next: Partial<Settings>) => void
}) {
  /** px, where the pointer holds it, from its centre. */
  const held = useRef<{ x: number; y: number }>(null)

  const stageOf = (element: HTMLElement) => element.parentElement!.getBoundingClientRect()

  /** Moves its centre to a point of the stage, px. */
  function moveTo(element: HTMLElement, x: number, y: number) {
    const { width, height } = stageOf(element)
    change({
      obstacleX: onSlider('obstacleX', (100 * x) / width),
      obstacleY: onSlider('obstacleY', (100 * y) / height),
    })
  }

  function centreIn({ width, height }: DOMRect) {
    return { x: (width * obstacleX) / 100, y: (height * obstacleY) / 100 }
  }

  function down(event: PointerEvent<HTMLElement>) {
    if (event.button !== 0) return
    event.currentTarget.setPointerCapture(event.pointerId)
    const box = stageOf(event.currentTarget)
    const { x, y } = centreIn(box)
    held.current = { x: event.clientX - box.left - x, y: event.clientY - box.top - y }
  }

  function move(event: PointerEvent<HTMLElement>) {
    if (!held.current) return
    const { left, top } = stageOf(event.currentTarget)
    moveTo(event.currentTarget, event.clientX - left - held.current.x, event.clientY - top - held.current.y)
  }

  function press(event: KeyboardEvent<HTMLElement>) {
    const way = arrows[event.key]
    if (!way || event.altKey || event.ctrlKey || event.metaKey) return
    event.preventDefault()
    const { x, y } = centreIn(stageOf(event.currentTarget))
    const step = event.shiftKey ? fineStep : keyStep
    moveTo(event.currentTarget, x + step * way[0], y + step * way[1])
  }

  const letGo = () => {
    held.current = null
  }
  return (
    <button
      type="button"
      data-static
      aria-label="Obstacle: arrow keys move it"
      onPointerDown={down}
      onPointerMove={move}
      onPointerUp={letGo}
      onPointerCancel={letGo}
      onLostPointerCapture={letGo}
      onKeyDown={press}
      style={{ left: `${obstacleX}%`, top: `${obstacleY}%` }}
      className={classes('absolute cursor-move touch-none forced-colors:border', obstacleClass)}
    />
  )
}

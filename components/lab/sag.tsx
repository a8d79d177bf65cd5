'use client'

import { useState } from 'react'
import { Slider } from '../slider'
import { chipColours, drawChip, drawLine, drawText } from './draw'
import { Figure, Value } from './figure'
import { record } from './record'
import { softStack } from './soft-stack'
import { useLazy } from './use-lazy'

const shape = { width: 150, height: 26, radius: 5 }
const stage = { width: 640, height: 350 }
const frames = 121

export function SagFigure() {
  const [count, setCount] = useState(10)
  const [hertz, setHertz] = useState(30)
  const soft = useLazy(() => softStack(count, hertz, frames), [count, hertz])
  const hard = useLazy(() => {
    const chips = Array.from({ length: count }, (_, i) => ({
      ...shape,
      x: 460,
      y: stage.height - (i + 0.5) * shape.height,
      angle: 0,
    }))
    return record({ ...stage, sleep: false }, chips, frames / 60).frames
  }, [count])

  const top = stage.height - count * shape.height
  const sagOfOurs = (at: number) => hard()[at][count - 1].y - (top + shape.height / 2)

  return (
    <Figure
      label="Two equal columns of chips. The one on soft contacts sinks into itself, the solver’s stays as high as it was built."
      {...stage}
      frames={frames}
      draw={(context, at, palette) => {
        for (let i = 0; i < count; i++) {
          const y = stage.height - (i + 0.5) * shape.height
          const fill = chipColours[i % chipColours.length]
          context.globalAlpha = 0.85
          drawChip(
            context,
            shape,
            { x: 180, y: y + soft()[at][i], angle: 0 },
            { fill, stroke: palette.stage },
          )
          context.globalAlpha = 1
          drawChip(context, shape, hard()[at][i], { fill, stroke: palette.stage })
        }
        for (const [x, sag] of [
          [180, soft()[at][count - 1]],
          [460, sagOfOurs(at)],
        ]) {
          context.fillStyle = palette.alarm
          context.fillRect(x - shape.width / 2, top, shape.width, Math.max(0, sag))
        }
        drawLine(context, [60, top], [580, top], palette.foreground, [4, 4])
        drawText(context, 'soft contacts', 180, top - 10, palette.muted, 'center')
        drawText(context, 'this solver', 460, top - 10, palette.muted, 'center')
      }}
      readoutHeight="min-h-11 sm:min-h-5"
      readout={(at) => (
        <>
          <Value of="Sunk by: soft">{soft()[at][count - 1].toFixed(2)} px</Value>
          <Value of="this solver">{Math.max(0, sagOfOurs(at)).toFixed(3)} px</Value>
        </>
      )}
    >
      <Slider label="Chips" value={count} min={2} max={12} onChange={setCount} />
      <Slider
        label="Contact stiffness"
        value={hertz}
        min={15}
        max={120}
        step={15}
        unit="Hz"
        onChange={setHertz}
      />
    </Figure>
  )
}

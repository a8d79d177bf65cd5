'use client'

import { useState } from 'react'
import { Slider } from '../slider'
import { chipColours, drawChip, drawLine, drawText, type Palette } from './draw'
import { Figure, Value } from './figure'
import { record, type State } from './record'
import { useLazy } from './use-lazy'

const gravity = 2600
const box = { width: 72, height: 48, radius: 6 }
const disc = { width: 56, height: 56, radius: 28 }
const lane = { width: 1000, height: 150 }
const frames = 91

function slide(shape: typeof box, friction: number, speed: number) {
  const start = { ...shape, x: 60, y: lane.height - shape.height / 2, angle: 0, vx: speed }
  const options = { ...lane, gravity, friction, linearDamping: 0, angularDamping: 0, sleep: false }
  return record(options, [start], frames / 60).frames.map(([chip]) => chip)
}

/**
 * The force of friction between two frames as a share of its limit: −1 at one end of the interval, 1 at the
 * other.
 */
function share(recording: State[], at: number, friction: number) {
  if (at === 0) return -1
  return ((recording[at].vx - recording[at - 1].vx) * 60) / (friction * gravity)
}

export function FrictionFigure() {
  const [friction, setFriction] = useState(0.4)
  const [speed, setSpeed] = useState(800)
  const boxRun = useLazy(() => slide(box, friction, speed), [friction, speed])
  const discRun = useLazy(() => slide(disc, friction, speed), [friction, speed])
  const distance = speed ** 2 / (2 * friction * gravity)

  function drawInterval(context: CanvasRenderingContext2D, y: number, value: number, palette: Palette) {
    const [left, right] = [700, 940]
    const middle = (left + right) / 2
    drawLine(context, [left, y], [right, y], palette.muted)
    for (const x of [left, middle, right]) drawLine(context, [x, y - 7], [x, y + 7], palette.muted)
    drawText(context, '−μN', left, y - 16, palette.muted, 'center')
    drawText(context, '0', middle, y - 16, palette.muted, 'center')
    drawText(context, '+μN', right, y - 16, palette.muted, 'center')
    context.beginPath()
    context.arc(middle + (value * (right - left)) / 2, y, 8, 0, 7)
    context.fillStyle = Math.abs(value) > 0.99 ? palette.alarm : palette.foreground
    context.fill()
  }

  return (
    <Figure
      label="A box and a disc are launched along the floor. Friction stands at the end of its interval while they slide, and falls to nothing when the box stops and the disc rolls."
      width={1000}
      height={lane.height * 2 + 20}
      frames={frames}
      speed={0.6}
      draw={(context, at, palette) => {
        drawLine(context, [0, lane.height], [1000, lane.height], palette.border)
        const end = 60 + distance
        drawLine(context, [end, lane.height - 60], [end, lane.height], palette.muted, [4, 4])
        drawText(context, 'v²/(2μg)', end, lane.height - 68, palette.muted, 'center')
        drawChip(context, box, boxRun()[at], { fill: chipColours[0] })
        drawInterval(context, 50, share(boxRun(), at, friction), palette)
        context.translate(0, lane.height + 20)
        drawLine(context, [0, lane.height], [1000, lane.height], palette.border)
        drawChip(context, disc, discRun()[at], { fill: chipColours[2], mark: true })
        drawInterval(context, 50, share(discRun(), at, friction), palette)
      }}
      readout={(at) => (
        <>
          <Value of="Box: gone">{(boxRun()[at].x - 60).toFixed(2)} px</Value>
          <Value of="of">{distance.toFixed(2)}</Value>
          <Value of="Disc: speed">{discRun()[at].vx.toFixed(1)} px/s</Value>
          <Value of="rolls at ⅔ v =">{((speed * 2) / 3).toFixed(1)}</Value>
        </>
      )}
    >
      <Slider label="Friction μ" value={friction} min={0.2} max={0.8} step={0.1} onChange={setFriction} />
      <Slider label="Speed v" value={speed} min={300} max={900} step={50} unit="px/s" onChange={setSpeed} />
    </Figure>
  )
}

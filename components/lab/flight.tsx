'use client'

import { useState } from 'react'
import { shortFigure } from '@/lib/figure'
import { flight } from '@/scenes/references'
import { Slider } from '../slider'
import { chipColours, drawChip, drawText } from './draw'
import { Figure, Value } from './figure'
import { record } from './record'
import { useLazy } from './use-lazy'

const gravity = 2600
/** 1/s */
const drag = 0.35
const chip = { width: 84, height: 34, radius: 17, x: 70, y: 270, angle: 0, vx: 560, vy: -1150, spin: 2.5 }
const frames = 52

/** Semi-implicit Euler, the step most engines take: first the velocity, then the place. */
function eulerStates(rate: number) {
  let { x, y, vx, vy } = chip
  const states = [{ x, y }]
  for (let n = 1; n < frames; n++) {
    for (let k = 0; k < rate / 60; k++) {
      vx *= 1 - drag / rate
      vy = vy * (1 - drag / rate) + gravity / rate
      x += vx / rate
      y += vy / rate
    }
    states.push({ x, y })
  }
  return states
}

function exactAt(at: number) {
  const t = at / 60
  return {
    x: chip.x + flight(chip.vx, 0, drag, t).moved,
    y: chip.y + flight(chip.vy, gravity, drag, t).moved,
  }
}

const apart = (a: { x: number; y: number }, b: { x: number; y: number }) => Math.hypot(a.x - b.x, a.y - b.y)

export function FlightFigure() {
  const [rate, setRate] = useState(60)
  const ours = useLazy(
    () => record({ width: 640, height: 1000, gravity, linearDamping: drag }, [chip], 0.9).frames,
    [],
  )
  const euler = useLazy(() => eulerStates(rate), [rate])

  return (
    <Figure
      label="A chip flies in an arc. The solver’s chip stays on the exact curve; Euler’s chip drifts below it."
      width={640}
      height={360}
      frames={frames}
      speed={0.4}
      draw={(context, at, palette) => {
        context.beginPath()
        for (let n = 0; n < frames; n++) context.lineTo(exactAt(n).x, exactAt(n).y)
        context.strokeStyle = palette.border
        context.lineWidth = 2
        context.stroke()
        const [one] = ours()[at]
        for (let n = 0; n < at; n += 8) {
          const [then] = ours()[n]
          context.globalAlpha = 0.25
          drawChip(context, chip, then, { fill: chipColours[0] })
          context.globalAlpha = 1
        }
        drawChip(context, chip, { ...euler()[at], angle: one.angle }, { stroke: palette.muted, dash: [5, 4] })
        drawChip(context, chip, one, { fill: chipColours[0], label: 'exact' })
        if (at > 20) {
          drawText(context, 'Euler', euler()[at].x - 34, euler()[at].y + 8, palette.muted, 'right')
        }
      }}
      readoutHeight="min-h-17 min-[22.5rem]:min-h-11 sm:min-h-5"
      readout={(at) => (
        <>
          <Value of="Off the exact curve: this solver">
            {shortFigure(apart(ours()[at][0], exactAt(at)), 'px')}
          </Value>
          <Value of="Euler">{apart(euler()[at], exactAt(at)).toFixed(2)} px</Value>
        </>
      )}
    >
      <Slider label="Euler’s steps a second" value={rate} min={60} max={960} step={60} onChange={setRate} />
    </Figure>
  )
}

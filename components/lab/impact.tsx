'use client'

import { useState } from 'react'
import { pillsImpact } from '@/scenes/references'
import { Slider } from '../slider'
import { chipColours, drawChip, drawLine } from './draw'
import { Figure, Value } from './figure'
import { record } from './record'
import { useLazy } from './use-lazy'

const speed = 500
const struckShape = { width: 260, height: 44, radius: 22 }
const strikerShape = { width: 90, height: 40, radius: 20 }
const conditions = {
  width: 640,
  height: 460,
  gravity: 0,
  friction: 0,
  linearDamping: 0,
  angularDamping: 0,
  bounceThreshold: 0,
}
const frames = 66

export function ImpactFigure() {
  const [arm, setArm] = useState(70)
  const [bounce, setBounce] = useState(0.5)
  const recording = useLazy(
    () =>
      record(
        { ...conditions, bounce },
        [
          { ...struckShape, x: 320, y: 240, angle: 0 },
          { ...strikerShape, x: 320 + arm, y: 400, angle: -Math.PI / 2, vy: -speed },
        ],
        frames / 60,
      ),
    [arm, bounce],
  )
  const theory = pillsImpact(speed, Math.abs(arm), struckShape, strikerShape, bounce).struck

  return (
    <Figure
      label="One chip strikes the side of another, away from its centre: it moves off and turns."
      width={640}
      height={460}
      frames={frames}
      speed={0.5}
      draw={(context, at, palette) => {
        const [struck, striker] = recording().frames[at]
        drawLine(context, [320, 0], [320, 460], palette.border)
        drawLine(context, [320 + arm, 0], [320 + arm, 460], palette.border, [4, 4])
        drawChip(context, struckShape, struck, { fill: chipColours[3], mark: true })
        drawChip(context, strikerShape, striker, { fill: chipColours[0], mark: true })
      }}
      readoutHeight="min-h-23 min-[22.5rem]:min-h-11 md:min-h-5"
      readout={(at) => {
        const [struck] = recording().frames[at]
        const hit = Math.abs(struck.vy) > 0
        return (
          <>
            <Value of="Speed">{hit ? `${(-struck.vy).toFixed(3)} px/s` : '–'}</Value>
            <Value of="by formula">{theory.speed.toFixed(3)}</Value>
            <Value of="Spin">{hit ? `${Math.abs(struck.spin).toFixed(4)} rad/s` : '–'}</Value>
            <Value of="by formula">{theory.spin.toFixed(4)}</Value>
          </>
        )
      }}
    >
      <Slider
        label="Distance from the centre"
        value={arm}
        min={-105}
        max={105}
        step={5}
        unit="px"
        onChange={setArm}
      />
      <Slider label="Bounce" value={bounce} min={0} max={1} step={0.1} onChange={setBounce} />
    </Figure>
  )
}

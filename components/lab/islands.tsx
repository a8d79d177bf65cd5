'use client'

import { pourChips, pourStage } from '@/scenes/piles'
import { chipColours, drawChip, drawLine, drawText } from './draw'
import { Figure, Value } from './figure'
import { islandsOf } from './islands-of'
import { record, type State } from './record'
import { useLazy } from './use-lazy'

const count = 13
const stage = { width: 640, height: pourStage(30).height }
const frames = 321
const graphHeight = 56

const poured = pourChips('mixed', count, 6).map((chip) => ({
  ...chip,
  x: (chip.x / pourStage(count).width) * 600 + 20,
}))
const late = { chip: { width: 92, height: 34, radius: 17, x: 130, y: -40, angle: 0.4, spin: 1 }, at: 190 }

const awake = (states: State[]) => states.filter((state) => !state.asleep).length

export function IslandsFigure() {
  const recording = useLazy(() => record(stage, poured, (frames - 1) / 60, late), [])

  return (
    <Figure
      label="Chips pour onto the floor. Each island of touching chips has a colour, and turns grey when it falls asleep. A late chip wakes only the island that it lands on."
      width={stage.width}
      height={stage.height + graphHeight}
      frames={frames}
      draw={(context, at, palette) => {
        const { chips, frames: states } = recording()
        const islands = islandsOf(chips, states[at])
        states[at].forEach((state, i) => {
          drawChip(context, chips[i], state, {
            fill: state.asleep ? palette.border : chipColours[islands[i] % chipColours.length],
            stroke: state.asleep ? palette.muted : palette.stage,
          })
        })
        const floor = stage.height + graphHeight
        drawLine(context, [0, stage.height], [stage.width, stage.height], palette.border)
        context.beginPath()
        context.moveTo(0, floor)
        const x = (n: number) => (n / (frames - 1)) * stage.width
        states.forEach((now, n) => {
          context.lineTo(x(n), floor - (awake(now) / (count + 1)) * (graphHeight - 8))
        })
        context.lineTo(stage.width, floor)
        context.fillStyle = chipColours[3]
        context.fill()
        drawLine(context, [x(at), stage.height], [x(at), floor], palette.foreground)
        drawText(context, 'chips awake', stage.width - 8, stage.height + 6, palette.muted, 'right', 'top')
      }}
      readoutHeight="min-h-11 sm:min-h-5"
      readout={(at) => {
        const states = recording().frames[at]
        const islands = islandsOf(recording().chips, states).filter((_, i) => !states[i].asleep)
        return (
          <>
            <Value of="Awake">
              {awake(states)} of {states.length}
            </Value>
            <Value of="in islands">{new Set(islands).size}</Value>
            <Value of="Frame callbacks">{awake(states) > 0 ? '60 a second' : 'none'}</Value>
          </>
        )
      }}
    />
  )
}

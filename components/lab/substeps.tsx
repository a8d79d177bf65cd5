'use client'

import { useId, useState } from 'react'
import { chipDistance, stageDistance, worstOverlap } from '@/scenes/exact-distance'
import { pourChips, pourStage } from '@/scenes/piles'
import { chipColours, drawChip, drawLine, drawText } from './draw'
import { Figure, Value } from './figure'
import { record, type State } from './record'
import { useLazy } from './use-lazy'

const count = 30
const stage = pourStage(count)
const chips = pourChips('pills', count, 7)
const frames = 151
const choices = [1, 2, 3, 6, 12]
/** px of overlap from which a chip is drawn in alarm, and px at the top of the graph. */
const visible = 0.5
const graphTop = 6
const graphHeight = 64
/** px above the graph, for what it shows. */
const labelHeight = 18

/** The chips that overlap another or the stage by more than `visible`. */
function overlapping(states: State[]) {
  const found = new Set<number>()
  for (let i = 0; i < count; i++) {
    const { floor, left, right } = stageDistance(chips[i], states[i], stage)
    if (Math.min(floor, left, right) < -visible) found.add(i)
    for (let j = 0; j < i; j++) {
      if (Math.hypot(states[i].x - states[j].x, states[i].y - states[j].y) > 130) continue
      if (chipDistance(chips[i], states[i], chips[j], states[j]) < -visible) found.add(i).add(j)
    }
  }
  return found
}

export function SubstepsFigure() {
  const id = useId()
  const [substeps, setSubsteps] = useState(6)
  const recording = useLazy(() => record({ ...stage, substeps }, chips, (frames - 1) / 60), [substeps])
  const overlaps = useLazy(
    () => recording().frames.map((states) => worstOverlap(chips, states, stage)),
    [substeps],
  )
  const worst = useLazy(() => Math.max(...overlaps()), [substeps])

  return (
    <Figure
      label="Thirty pills are poured. With one sub-step they overlap as they land, with six they hardly do."
      width={stage.width}
      height={stage.height + graphHeight}
      frames={frames}
      speed={0.6}
      draw={(context, at, palette) => {
        const states = recording().frames[at]
        const bad = overlapping(states)
        states.forEach((state, i) => {
          drawChip(context, chips[i], state, {
            fill: bad.has(i) ? palette.alarm : chipColours[i % chipColours.length],
            stroke: palette.stage,
          })
        })
        const floor = stage.height + graphHeight
        drawLine(context, [0, stage.height], [stage.width, stage.height], palette.border)
        const x = (n: number) => (n / (frames - 1)) * stage.width
        context.beginPath()
        context.moveTo(0, floor)
        overlaps().forEach((overlap, n) => {
          context.lineTo(x(n), floor - Math.min(1, overlap / graphTop) * (graphHeight - labelHeight))
        })
        context.lineTo(stage.width, floor)
        context.fillStyle = palette.alarm
        context.fill()
        drawLine(context, [x(at), stage.height + labelHeight], [x(at), floor], palette.foreground)
        drawText(
          context,
          `worst overlap, 0 to ${graphTop} px`,
          stage.width - 8,
          stage.height + 5,
          palette.muted,
          'right',
          'top',
        )
      }}
      readout={(at) => (
        <>
          <Value of="Worst overlap now">{Math.max(0, overlaps()[at]).toFixed(2)} px</Value>
          <Value of="in the whole run">{worst().toFixed(2)} px</Value>
          <Value of="Iterations">{recording().iterations.toLocaleString('en')}</Value>
        </>
      )}
    >
      <fieldset className="flex flex-wrap items-center gap-1.5">
        <legend className="float-left mr-3 py-1 max-sm:w-full">Sub-steps a frame</legend>
        {choices.map((choice) => (
          <label
            key={choice}
            className="cursor-pointer rounded-md border px-3 py-1 tabular-nums has-checked:border-foreground has-checked:bg-foreground has-checked:text-background has-focus-visible:outline-2 has-focus-visible:outline-ring has-focus-visible:outline-offset-2"
          >
            <input
              type="radio"
              name={id}
              value={choice}
              checked={choice === substeps}
              onChange={() => setSubsteps(choice)}
              className="sr-only"
            />
            {choice}
          </label>
        ))}
      </fieldset>
    </Figure>
  )
}

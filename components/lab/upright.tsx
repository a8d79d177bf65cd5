'use client'

import { useState } from 'react'
import { shortFigure } from '@/lib/figure'
import { BOUNCE, FRICTION, GRAVITY } from '@/registry/gravity-stack/solver/constants'
import { uprightTurn } from '@/registry/gravity-stack/stage/look-ahead'
import type { Pose, Shape } from '@/scenes/exact-distance'
import { Slider } from '../slider'
import { chipColours, drawChip, drawLine, drawText } from './draw'
import { Figure, Value } from './figure'
import { createPile } from './pile'
import { chips, isUpsideDown, shapes } from './upright-chips'
import { useLazy } from './use-lazy'

/** Of each of the two drops. */
const stage = { width: 480, height: 170 }
const frames = 301

/** The component's drop of that number: frame by frame the poses of the chips that have been released. */
function drop(number: number) {
  // The first drops leave only a few words upside down.
  const seed = number + 4
  const pile = createPile(
    { ...stage, gravity: GRAVITY, bounce: BOUNCE, friction: FRICTION, stagger: 130, seed },
    shapes,
  )
  return Array.from({ length: frames }, (_, at) => {
    if (at > 0) pile.step()
    return pile.ids.map((id) => pile.world.read(id))
  })
}

/** px, how far the corners of a chip at two poses are apart at most, whatever the corners are called. */
function outlinesApart({ width, height, radius }: Shape, one: Pose, other: Pose) {
  // A disc has none.
  if (2 * (radius ?? 0) >= Math.max(width, height)) return Math.hypot(one.x - other.x, one.y - other.y)
  const corners = ({ x, y, angle }: Pose) =>
    [
      [1, 1],
      [-1, 1],
      [-1, -1],
      [1, -1],
    ].map(([right, down]) => [
      x + (right * width * Math.cos(angle) - down * height * Math.sin(angle)) / 2,
      y + (right * width * Math.sin(angle) + down * height * Math.cos(angle)) / 2,
    ])
  const others = corners(other)
  const nearest = ([x, y]: number[]) => Math.min(...others.map(([u, v]) => Math.hypot(x - u, y - v)))
  return Math.max(...corners(one).map(nearest))
}

export function UprightFigure() {
  const [number, setNumber] = useState(1)
  const recording = useLazy(() => drop(number), [number])
  /** rad that each chip is turned by from its start. */
  const turns = useLazy(
    () =>
      recording()
        .at(-1)!
        .map(({ angle }, i) => uprightTurn(shapes[i], angle)),
    [recording],
  )
  const planned = (at: number) =>
    recording()[at].map(({ x, y, angle }, i) => ({ x, y, angle: angle + turns()[i] }))

  return (
    <Figure
      label="The same drop twice. Above, chips fall as they are released, and many words end upside down. Below, each chip starts turned by what the plan says, and every word ends the right way up. Dashed lines show where the plan expects each chip."
      run={String(number)}
      width={stage.width}
      height={2 * stage.height}
      frames={frames}
      draw={(context, at, palette) => {
        const draw = (poses: Pose[], from: number, title: string, plan: Pose[]) => {
          context.save()
          context.beginPath()
          context.rect(0, from, stage.width, stage.height)
          context.clip()
          context.translate(0, from)
          context.globalAlpha = 0.5
          plan.forEach((pose, i) => {
            drawChip(context, shapes[i], pose, { stroke: palette.muted, dash: [3, 4] })
          })
          context.globalAlpha = 1
          poses.forEach((pose, i) => {
            const fill = chipColours[i % chipColours.length]
            drawChip(context, shapes[i], pose, { fill, stroke: palette.stage, label: chips[i][0] })
          })
          drawText(context, title, 8, 8, palette.muted, 'left', 'top')
          context.restore()
        }
        draw(recording()[at], 0, 'as released', [])
        draw(planned(at), stage.height, 'planned', planned(frames - 1))
        drawLine(context, [0, stage.height], [stage.width, stage.height], palette.border)
      }}
      readout={(at) => {
        const [fallen, turned] = [recording()[at], planned(at)]
        const apart = fallen.map((pose, i) => outlinesApart(shapes[i], pose, turned[i]))
        return (
          <>
            <Value of="Upside down: as released">
              {fallen.filter(isUpsideDown).length} of {fallen.length}
            </Value>
            <Value of="planned">
              {turned.filter(isUpsideDown).length} of {turned.length}
            </Value>
            <Value of="Outlines apart">{shortFigure(Math.max(0, ...apart), 'px')}</Value>
          </>
        )
      }}
    >
      <Slider label="Drop" value={number} min={1} max={9} onChange={setNumber} />
    </Figure>
  )
}

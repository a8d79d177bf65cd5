'use client'

import { useId, useState } from 'react'
import { scenes } from '@/scenes'
import type { Scene } from '@/scenes/scene'
import { chipColours, drawChip } from './draw'
import { Figure } from './figure'
import { filmOf } from './film'
import { shortFigure } from './short-figure'
import { useLazy } from './use-lazy'

/** Scenes of more chips are for the benchmark; here they would keep a phone busy for a minute. */
const shown = scenes.filter((scene) => scene.build(1).length <= 60)

export function ScenesFigure() {
  const id = useId()
  const [name, setName] = useState('pour-mixed-60')
  const [seed, setSeed] = useState(1)
  const scene: Scene = shown.find((candidate) => candidate.name === name) ?? shown[0]
  const film = useLazy(() => filmOf(scene, seed), [scene, seed])
  const measured = useLazy(() => scene.measure(film()), [scene, seed])

  return (
    <Figure
      label={`The scene “${scene.title}”, computed in this browser.`}
      film={`${name} ${seed}`}
      width={scene.width}
      height={scene.height}
      frames={Math.round(scene.seconds * 60) + 1}
      draw={(context, at, palette) => {
        const { chips } = film()
        chips.forEach((chip, i) => {
          drawChip(context, chip, film().state(at, i), {
            fill: chipColours[i % chipColours.length],
            stroke: palette.stage,
            mark: chip.width === chip.height,
          })
        })
      }}
      readout={() =>
        scene.measures.map((measure, i) => (
          <span key={measure.name}>
            {measure.name}{' '}
            <strong className="font-medium text-foreground">
              {shortFigure(measured()[i], measure.unit)}
            </strong>
            {measure.target !== undefined && `, target ${shortFigure(measure.target)}`}
          </span>
        ))
      }
    >
      <div className="flex min-w-0 flex-1 basis-64 flex-col gap-1.5">
        <label htmlFor={`${id}-scene`}>Scene</label>
        <select
          id={`${id}-scene`}
          value={name}
          onChange={(event) => {
            setName(event.target.value)
            setSeed(1)
          }}
          className="w-full rounded-md border bg-background px-3 py-2"
        >
          {shown.map((candidate) => (
            <option key={candidate.name} value={candidate.name}>
              {candidate.title}
            </option>
          ))}
        </select>
      </div>
      {scene.seeds > 1 && (
        <button
          type="button"
          onClick={() => setSeed((seed % scene.seeds) + 1)}
          className="rounded-md border px-3 py-2 tabular-nums hover:bg-muted"
        >
          Seed {seed} of {scene.seeds}: next
        </button>
      )}
    </Figure>
  )
}

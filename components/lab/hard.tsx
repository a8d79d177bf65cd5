'use client'

import { useId, useState } from 'react'
import { playHardScene, type Watch } from '@/bench/hard-run'
import { type HardFigures, hardScenes } from '@/scenes/hard'
import { chipColours, drawChip, drawLine } from './draw'
import { Figure } from './figure'
import { named } from './named'
import { shortFigure } from './short-figure'
import { useLazy } from './use-lazy'

/** The scenes that break solvers, played by the component's solver in this browser, each figure beside its bound. */
export function HardScenesFigure() {
  const id = useId()
  const [name, setName] = useState('dragged-through-everything')
  const [seed, setSeed] = useState(1)
  const scene = hardScenes.find((candidate) => candidate.name === name)!
  const run = useLazy(() => {
    const frames: { states: Parameters<Watch>[1]; alive: boolean[]; width: number; height: number }[] = []
    const figures = playHardScene(scene, seed, (_, states, alive, { width, height }) => {
      frames.push({ states, alive: [...alive], width, height })
    })
    return { frames, figures, chips: scene.build(seed) }
  }, [scene, seed])

  return (
    <Figure
      label={`${scene.title}, computed in this browser.`}
      film={`${name} ${seed}`}
      width={scene.width}
      height={scene.height}
      frames={Math.round(scene.seconds * 60)}
      draw={(context, at, palette) => {
        const { frames, chips } = run()
        const frame = frames[Math.min(at, frames.length - 1)]
        frame.states.forEach((state, i) => {
          if (!frame.alive[i]) return
          drawChip(context, chips[i], state, {
            fill: chipColours[i % chipColours.length],
            stroke: palette.stage,
          })
        })
        const { width, height } = frame
        drawLine(context, [0, height], [width, height], palette.muted)
        drawLine(context, [width, 0], [width, height], palette.muted)
      }}
      readout={() =>
        (Object.entries(scene.bounds) as [keyof HardFigures, number][]).map(([key, bound]) => {
          const { measure, unit } = named(key)
          const value = run().figures[key]
          return (
            <span key={key}>
              {measure} <strong className="font-medium text-foreground">{shortFigure(value, unit)}</strong>,
              bound {shortFigure(bound)}
              {!(value <= bound) && <strong className="ml-2 font-medium text-foreground">missed</strong>}
            </span>
          )
        })
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
          {hardScenes.map((candidate) => (
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

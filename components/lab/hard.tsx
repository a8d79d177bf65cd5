'use client'

import { playHardScene, type Watch } from '@/bench/stability/play'
import { shortFigure } from '@/lib/figure'
import { type HardFigures, hardScenes, named } from '@/scenes/hard'
import { chipColours, drawChip, drawLine } from './draw'
import { Figure } from './figure'
import { ScenePicker, usePick } from './scene-picker'
import { useLazy } from './use-lazy'

/** The hard scenes, played by the component's solver in this browser, with each figure beside its bound. */
export function HardScenesFigure() {
  const { picked, pick, scene, seed } = usePick(hardScenes, 'dragged-through-everything')
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
      run={`${scene.name} ${seed}`}
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
        for (const wall of [0, width]) drawLine(context, [wall, 0], [wall, height], palette.muted)
      }}
      readoutHeight="min-h-40 sm:min-h-17"
      readout={() =>
        (Object.entries(scene.bounds) as [keyof HardFigures, number][]).map(([key, bound]) => {
          const { measure, unit } = named(key)
          const value = run().figures[key]
          return (
            <span key={key}>
              {measure} <strong className="font-medium text-foreground">{shortFigure(value, unit)}</strong>,
              bound{'\u00a0'}
              {shortFigure(bound)}
              {!(value <= bound) && <strong className="ml-2 font-medium text-foreground">missed</strong>}
            </span>
          )
        })
      }
    >
      <ScenePicker scenes={hardScenes} picked={picked} onPick={pick} />
    </Figure>
  )
}

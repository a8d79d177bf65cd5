'use client'

import { shortFigure } from '@/lib/figure'
import { scenes } from '@/scenes'
import { slowest } from '@/scenes/piles'
import { chipColours, drawChip } from './draw'
import { Figure } from './figure'
import { ScenePicker, usePick } from './scene-picker'
import { trajectoryOf } from './trajectory'
import { useLazy } from './use-lazy'

/** Scenes of more chips are for the benchmark; here they would keep a phone busy for a minute. */
const shown = scenes.filter((scene) => scene.build(1).length <= 60)

export function ScenesFigure() {
  const { picked, pick, scene, seed } = usePick(shown, 'pour-mixed-60')
  const trajectory = useLazy(() => trajectoryOf(scene, seed), [scene, seed])
  const measured = useLazy(() => scene.measure(trajectory()), [scene, seed])

  return (
    <Figure
      label={`The scene “${scene.title}”, computed in this browser.`}
      run={`${scene.name} ${seed}`}
      width={scene.width}
      height={scene.height}
      frames={Math.round(scene.seconds * 60) + 1}
      draw={(context, at, palette) => {
        const { chips } = trajectory()
        chips.forEach((chip, i) => {
          drawChip(context, chip, trajectory().state(at, i), {
            fill: chipColours[i % chipColours.length],
            stroke: palette.stage,
            mark: chip.width === chip.height,
          })
        })
      }}
      readoutHeight="min-h-29 sm:min-h-17 lg:min-h-11"
      readout={() =>
        scene.measures.map(({ name, unit, target }, i) =>
          name === slowest ? null : (
            <span key={name}>
              {name}{' '}
              <strong className="font-medium text-foreground">{shortFigure(measured()[i], unit)}</strong>
              {target !== undefined && `, target\u00a0${shortFigure(target)}`}
            </span>
          ),
        )
      }
    >
      <ScenePicker scenes={shown} picked={picked} onPick={pick} />
    </Figure>
  )
}

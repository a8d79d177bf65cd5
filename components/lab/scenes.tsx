'use client'

import { shortFigure } from '@/lib/figure'
import { scenes } from '@/scenes'
import { slowest } from '@/scenes/piles'
import { chipColours, drawChip } from './draw'
import { Figure } from './figure'
import { filmOf } from './film'
import { ScenePicker, usePick } from './scene-picker'
import { useLazy } from './use-lazy'

/** Scenes of more chips are for the benchmark; here they would keep a phone busy for a minute. */
const shown = scenes.filter((scene) => scene.build(1).length <= 60)

export function ScenesFigure() {
  const { picked, pick, scene, seed } = usePick(shown, 'pour-mixed-60')
  const film = useLazy(() => filmOf(scene, seed), [scene, seed])
  const measured = useLazy(() => scene.measure(film()), [scene, seed])

  return (
    <Figure
      label={`The scene “${scene.title}”, computed in this browser.`}
      film={`${scene.name} ${seed}`}
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

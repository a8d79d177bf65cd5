import { scenes } from '@/scenes'
import { filmOf } from './lab/film'
import { ScrollTable } from './scroll-table'

const figureOf = (value: number) =>
  value === 0 ? '0' : Math.abs(value) < 1e-3 ? value.toExponential(0) : String(Number(value.toPrecision(3)))

/** Every scene that a build can run in a moment, with what the solver makes of it. */
export function ScenesTable() {
  const rows = scenes
    .filter((scene) => scene.build(1).length <= 60)
    .flatMap((scene) => {
      const values = scene.measure(filmOf(scene))
      return scene.measures.map((measure, i) => ({ scene, measure, value: values[i], first: i === 0 }))
    })
  return (
    <ScrollTable label="Scenes">
      <thead>
        <tr className="border-b text-muted-foreground">
          {['Scene', 'Measure', 'Figure', 'Target'].map((head) => (
            <th key={head} scope="col" className="px-4 py-2.5 font-medium">
              {head}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {rows.map(({ scene, measure, value, first }) => {
          const missed = measure.target !== undefined && !(value <= measure.target)
          return (
            <tr key={`${scene.name} ${measure.name}`} className="border-b align-baseline last:border-0">
              <th scope="row" className="min-w-44 px-4 py-2 font-normal">
                {first ? scene.title : <span className="sr-only">{scene.title}</span>}
              </th>
              <td className="px-4 py-2 text-muted-foreground">{measure.name}</td>
              <td className="whitespace-nowrap px-4 py-2 tabular-nums">
                {figureOf(value)} {measure.unit}
              </td>
              <td className="whitespace-nowrap px-4 py-2 text-muted-foreground tabular-nums">
                {measure.target === undefined ? '–' : figureOf(measure.target)}
                {missed && <strong className="ml-2 font-medium text-foreground">missed</strong>}
              </td>
            </tr>
          )
        })}
      </tbody>
    </ScrollTable>
  )
}

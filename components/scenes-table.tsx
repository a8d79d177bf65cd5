import { Fragment } from 'react'
import fuzzMisses from '@/bench/fuzz-misses.json'
import hardRows from '@/bench/results/stability.json'
import { scenes } from '@/scenes'
import { checks } from '@/scenes/fuzzed'
import { type HardFigures, hardScenes, hardUnits, hardWords } from '@/scenes/hard'
import { filmOf } from './lab/film'
import { shortFigure } from './lab/short-figure'
import { ScrollTable } from './scroll-table'

type Row = { measure: string; value: number; unit: string; bound?: number }

function Rows({
  label,
  bound,
  scenes,
}: {
  label: string
  bound: string
  scenes: { title: string; rows: Row[] }[]
}) {
  return (
    <ScrollTable label={label}>
      <thead>
        <tr className="border-b text-muted-foreground">
          {['Scene', 'Measure', 'Figure', bound].map((head) => (
            <th key={head} scope="col" className="px-4 py-2.5 font-medium">
              {head}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {scenes.map(({ title, rows }) => (
          <Fragment key={title}>
            {rows.map(({ measure, value, unit, bound }, i) => (
              <tr
                key={measure}
                className={i === rows.length - 1 ? 'border-b align-baseline' : 'align-baseline'}
              >
                <th scope="row" className="min-w-44 px-4 py-1.5 font-normal">
                  {i === 0 ? title : <span className="sr-only">{title}</span>}
                </th>
                <td className="whitespace-nowrap px-4 py-1.5 text-muted-foreground">{measure}</td>
                <td className="whitespace-nowrap px-4 py-1.5 tabular-nums">{shortFigure(value, unit)}</td>
                <td className="whitespace-nowrap px-4 py-1.5 text-muted-foreground tabular-nums">
                  {bound === undefined ? '–' : shortFigure(bound)}
                  {bound !== undefined && !(value <= bound) && (
                    <strong className="ml-2 font-medium text-foreground">missed</strong>
                  )}
                </td>
              </tr>
            ))}
          </Fragment>
        ))}
      </tbody>
    </ScrollTable>
  )
}

/** The scenes whose answer is known, as the solver plays them: the first seed, run when the site is built. */
export function ScenesTable() {
  const list = scenes
    .filter((scene) => scene.build(1).length <= 60)
    .map((scene) => {
      const values = scene.measure(filmOf(scene))
      const rows = scene.measures.map(({ name, unit, target }, i) => ({
        measure: name,
        value: values[i],
        unit,
        bound: target,
      }))
      return { title: scene.title, rows }
    })
  return <Rows label="Scenes with a known answer" bound="Target" scenes={list} />
}

/** The scenes that break solvers: the worst of all seeds, as measured and held to by the tests. */
export function HardScenesTable() {
  const list = hardScenes.map(({ name, title }) => {
    const rows = hardRows
      .filter(({ scene }) => scene === name)
      .map(({ figure, value, bound }) => ({
        measure: hardWords[figure as keyof HardFigures],
        value: value ?? Number.POSITIVE_INFINITY,
        unit: hardUnits[figure as keyof HardFigures],
        bound,
      }))
    return { title, rows }
  })
  return <Rows label="Scenes that break solvers" bound="Bound" scenes={list} />
}

/** What holds in every random scene, and in how many of the first 2,000 it does not yet. */
export function FuzzTable() {
  const misses: Partial<Record<string, number>> = fuzzMisses
  return (
    <ScrollTable label="Random scenes">
      <thead>
        <tr className="border-b text-muted-foreground">
          {['What has to hold', 'Misses in 2,000 scenes'].map((head) => (
            <th key={head} scope="col" className="px-4 py-2.5 font-medium">
              {head}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {Object.entries(checks).map(([check, says]) => (
          <tr key={check} className="border-b align-baseline">
            <th scope="row" className="min-w-56 px-4 py-1.5 font-normal">
              {says}
            </th>
            <td className="px-4 py-1.5 tabular-nums">{misses[check] ?? 0}</td>
          </tr>
        ))}
      </tbody>
    </ScrollTable>
  )
}

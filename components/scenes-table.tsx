import { results } from '@/app/benchmarks/data'
import fuzzMisses from '@/bench/fuzz-misses.json'
import { ours } from '@/bench/report'
import measured from '@/bench/results/stability.json'
import { typeset } from '@/lib/typeset'
import { scenes } from '@/scenes'
import { checks } from '@/scenes/fuzzed'
import { type HardFigures, hardScenes } from '@/scenes/hard'
import { named } from './lab/named'
import { shortFigure } from './lab/short-figure'
import { ScrollTable } from './scroll-table'

type Row = { measure: string; value: number; unit: string; bound?: number; late?: number }
type SceneRows = { title: string; rows: Row[] }

/** What must be none and is none, in one row. */
function folded(rows: Row[]): Row[] {
  const none = rows.filter(({ value, bound }) => value === 0 && bound === 0)
  if (none.length < 2) return rows
  const measure = none.map((row) => row.measure).join(', ')
  return [...rows.filter((row) => !none.includes(row)), { ...none[0], measure }]
}

function Rows({ label, bound, scenes }: { label: string; bound: string; scenes: SceneRows[] }) {
  return (
    <ScrollTable label={label}>
      <thead>
        <tr className="border-b text-muted-foreground">
          {['Measure', 'Figure', bound].map((head) => (
            <th key={head} scope="col" className="px-2.5 py-2.5 sm:px-4 font-medium">
              {head}
            </th>
          ))}
        </tr>
      </thead>
      {scenes.map(({ title, rows }) => (
        <tbody key={title} className="border-b last:border-0">
          <tr>
            <th scope="rowgroup" colSpan={3} className="px-2.5 pt-3 sm:px-4 pb-1 font-medium">
              {typeset(title)}
            </th>
          </tr>
          {folded(rows).map((row) => {
            const { figure, bound, missed } = cellsOf(row)
            return (
              <tr key={row.measure} className="align-baseline last:*:pb-3">
                <th scope="row" className="px-2.5 py-1 sm:px-4 font-normal text-muted-foreground">
                  {row.measure}
                </th>
                <td className="whitespace-nowrap px-2.5 py-1 sm:px-4 tabular-nums">{figure}</td>
                <td className="px-2.5 py-1 sm:px-4 text-muted-foreground tabular-nums">
                  {/* On a narrow phone a unit may go on the next line. */}
                  {bound.replaceAll('\u00a0', ' ')}
                  {missed && <strong className="font-medium text-foreground"> missed</strong>}
                </td>
              </tr>
            )
          })}
        </tbody>
      ))}
    </ScrollTable>
  )
}

/** The scenes whose answer is known, as the benchmark has measured them: the worst of a pour's seeds, or their median, as the target asks. */
export const knownRows = (): SceneRows[] =>
  scenes
    .filter((scene) => scene.build(1).length <= 60)
    .map(({ name, title, seconds, measures }) => {
      const { errors } = results.errors.find(
        (row) => row.engine === ours && row.scene === name && Object.keys(row.setting).length === 0,
      )!
      const rows = measures.map(({ name, unit, target }, i) => {
        // A film ends before what does not come to rest.
        const late = unit === 's' && errors[i]! > seconds - 0.1 ? seconds : undefined
        const value = late ? Number.POSITIVE_INFINITY : (errors[i] ?? Number.POSITIVE_INFINITY)
        return { measure: name, value, unit, bound: target, late }
      })
      return { title, rows }
    })

export const ScenesTable = () => (
  <Rows label="Scenes with a known answer" bound="Target" scenes={knownRows()} />
)

/** The scenes that break solvers: the worst of all seeds, as measured and held to by the tests. */
export const hardRows = (): SceneRows[] =>
  hardScenes.map(({ name, title }) => {
    const rows = measured
      .filter(({ scene }) => scene === name)
      .map(({ figure, value, bound }) => ({
        ...named(figure as keyof HardFigures),
        value: value ?? Number.POSITIVE_INFINITY,
        bound,
      }))
    return { title, rows }
  })

export const HardScenesTable = () => (
  <Rows label="Scenes that break solvers" bound="Bound" scenes={hardRows()} />
)

/** What a cell says, for the page and its Markdown alike. */
export function cellsOf({ value, unit, bound, late }: Row) {
  const missed = bound !== undefined && !(value <= bound)
  return {
    figure: late ? `not in ${late} s` : shortFigure(value, unit),
    bound: bound === undefined ? '–' : shortFigure(bound, unit),
    missed,
  }
}

/** Misses in 100,000 scenes, from a run that takes too long to repeat with each change. */
const longRun: Partial<Record<string, number>> = { asleep: 6, recovery: 2, hanging: 1 }

/** What holds in random scenes, and in how many it does not: of the first 2,000, which each change plays, and of 100,000. */
export function fuzzRows() {
  const misses: Partial<Record<string, number>> = fuzzMisses
  return Object.entries(checks).map(
    ([check, says]) => [says, misses[check] ?? 0, longRun[check] ?? 0] as const,
  )
}

export const fuzzHead = ['What has to hold', 'Misses in 2,000', 'Misses in 100,000']

export function FuzzTable() {
  return (
    <ScrollTable label="Random scenes">
      <thead>
        <tr className="border-b text-muted-foreground">
          {fuzzHead.map((head) => (
            <th key={head} scope="col" className="px-3 py-2.5 sm:px-4 font-medium">
              {head}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {fuzzRows().map(([says, some, all]) => (
          <tr key={says} className="border-b align-baseline last:border-0">
            <th scope="row" className="px-3 py-1.5 sm:px-4 font-normal">
              {says}
            </th>
            <td className="px-3 py-1.5 sm:px-4 tabular-nums">{some}</td>
            <td className="px-3 py-1.5 sm:px-4 tabular-nums">{all}</td>
          </tr>
        ))}
      </tbody>
    </ScrollTable>
  )
}

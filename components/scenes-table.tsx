import { chipCounts, chipCountsHead } from '@/lib/evidence/browser'
import {
  cellsOf,
  fuzzHead,
  fuzzRows,
  hardRows,
  knownRows,
  type Row,
  type SceneRows,
  slideWords,
} from '@/lib/evidence/scenes'
import { typeset } from '@/lib/typeset'
import { ScrollTable } from './scroll-table'

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

export const ScenesTable = () => (
  <Rows label="Scenes with a known answer" bound="Target" scenes={knownRows()} />
)

export const HardScenesTable = () => (
  <Rows label="Scenes that break solvers" bound="Bound" scenes={hardRows()} />
)

export const SlideWords = () => <p>{typeset(slideWords())}</p>

/** Rows that have their name in the first cell and words or figures in the others. */
function NamedRows({
  label,
  head,
  rows,
}: {
  label: string
  head: string[]
  rows: readonly (readonly [string, ...string[]])[]
}) {
  return (
    <ScrollTable label={label}>
      <thead>
        <tr className="border-b text-muted-foreground">
          {head.map((text) => (
            <th key={text} scope="col" className="px-3 py-2.5 sm:px-4 font-medium">
              {text}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {rows.map(([name, ...cells]) => (
          <tr key={name} className="border-b align-baseline last:border-0">
            <th scope="row" className="px-3 py-1.5 sm:px-4 font-normal">
              {typeset(name)}
            </th>
            {cells.map((cell, i) => (
              <td key={head[i + 1]} className="px-3 py-1.5 sm:px-4 tabular-nums">
                {typeset(cell)}
              </td>
            ))}
          </tr>
        ))}
      </tbody>
    </ScrollTable>
  )
}

export const ChipCounts = () => <NamedRows label="How many chips" head={chipCountsHead} rows={chipCounts()} />

export const FuzzTable = () => <NamedRows label="Random scenes" head={fuzzHead} rows={fuzzRows()} />

// The table, as text for a terminal and as a page of Markdown beside the figures.
import type { Group, Row } from './row'
import { holds } from './row'
import { isDearer, type Timing } from './time'

export type Titled = Pick<Group, 'name' | 'title'>

const shown = (value: number | null | undefined) =>
  value === undefined ? '' : value === null ? 'never' : String(value)
const boundOf = (row: Row) => (row.bound === undefined ? '' : `${row.atLeast ? '≥' : '≤'} ${row.bound}`)
const mark = (row: Row) => (row.bound === undefined ? '' : holds(row) ? '✓' : '✗')

/** Two rows of two tables that say the same. */
export const sameRow = (a: Row) => (b: Row) =>
  a.group === b.group && a.what === b.what && a.figure === b.figure

type Cells = [
  what: string,
  figure: string,
  value: string,
  unit: string,
  bound: string,
  held: string,
  before: string,
]

function cellsOf(rows: Row[], before: Row[]): Cells[] {
  return rows.map((row) => [
    row.what,
    row.figure,
    shown(row.value),
    row.unit,
    boundOf(row),
    mark(row),
    shown(before.find(sameRow(row))?.value),
  ])
}

export function printTable(groups: Titled[], rows: Row[], before: Row[]) {
  for (const { name, title } of groups) {
    const own = rows.filter(({ group }) => group === name)
    if (own.length === 0) continue
    console.log(`\n${name}: ${title}`)
    let last = ''
    for (const [what, figure, value, unit, bound, held, was] of cellsOf(own, before)) {
      const label = what === last ? '' : what
      last = what
      const line = `${label.padEnd(34)}${figure.padEnd(44)}${value.padStart(11)} ${unit.padEnd(13)}${bound.padEnd(10)}${held.padEnd(3)}`
      console.log(`${line}${was && `before ${was}`}`.trimEnd())
    }
  }
}

export function printTimings(timings: Timing[]) {
  console.log('\ntime: µs a frame, all awake, in turns with the solver before')
  for (const timing of timings) {
    const { count, phase, now, before, ratio } = timing
    const held = isDearer(timing) ? '✗' : '✓'
    const spread = `${ratio.low.toFixed(2)} to ${ratio.high.toFixed(2)}`
    console.log(
      `${`${count} pills`.padEnd(12)}${phase.padEnd(20)}${now.toFixed(1).padStart(9)}${before.toFixed(1).padStart(9)}   ratio ${ratio.median.toFixed(2)} (${spread})  ≤ 1 ${held}`,
    )
  }
}

export function markdown(groups: Titled[], rows: Row[], before: Row[]) {
  const judged = rows.filter(({ bound }) => bound !== undefined)
  const missed = judged.filter((row) => !holds(row))
  const lines = [
    '<!-- Written by `npm run accept`. -->',
    '',
    '# What the solver is held to',
    '',
    `${judged.length - missed.length} of ${judged.length} bounds hold.`,
  ]
  for (const { name, title } of groups) {
    const own = rows.filter(({ group }) => group === name)
    if (own.length === 0) continue
    const header = [
      'what',
      'figure',
      'value',
      'unit',
      'bound',
      'holds',
      ...(before.length > 0 ? ['before'] : []),
    ]
    lines.push('', `## ${title}`, '', `| ${header.join(' | ')} |`, `|${header.map(() => ' --- |').join('')}`)
    for (const cells of cellsOf(own, before)) lines.push(`| ${cells.slice(0, header.length).join(' | ')} |`)
  }
  return `${lines.join('\n')}\n`
}

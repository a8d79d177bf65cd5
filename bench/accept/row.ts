import { median } from '../accuracy/trajectory'

/** What one run of a subject gives; each figure by its name. Infinity stands for what never came. */
export type Run = Record<string, number>

/** One line of the table: a figure over all runs of a subject, beside its bound where it has one. */
export type Row = {
  group: string
  what: string
  figure: string
  /** null is without bound: never asleep, or not a number */
  value: number | null
  unit: string
  /** runs that the figure is read from */
  runs: number
  bound?: number
  /** true where the value has to reach the bound instead of keeping below it */
  atLeast?: true
}

/** Something that is played from a seed. Its group makes rows of its runs. */
export type Subject = {
  name: string
  title: string
  /** seeds of a full run; 1 where nothing is left to chance */
  seeds: number
  /** ms that one run takes, more or less: the longest are begun first */
  weight: number
  play(seed: number): Run | Promise<Run>
}

export type Group = {
  name: string
  title: string
  subjects: Subject[]
  /** Rows of the runs of each subject, by seed. A subject that was not played has none. */
  rows(runs: Map<string, Run[]>): Omit<Row, 'group'>[]
}

export const holds = ({ value, bound, atLeast }: Row) =>
  bound === undefined || (value !== null && (atLeast ? value >= bound : value <= bound))

/** One figure over all runs. Figures that are not finite become null. */
export function figureOf(
  what: string,
  figure: string,
  unit: string,
  runs: Run[],
  over: (values: number[]) => number,
  key: string,
  bound: Pick<Row, 'bound' | 'atLeast'> = {},
): Omit<Row, 'group'> {
  const value = over(runs.map((run) => run[key]))
  return { what, figure, value: tidy(value), unit, runs: runs.length, ...bound }
}

/** The last digits of what is measured need not be the same on every machine. */
const tidy = (value: number) => (Number.isFinite(value) ? Number(value.toPrecision(4)) : null)

const worst = (values: number[]) => values.reduce((a, b) => (b > a || Number.isNaN(b) ? b : a))
const sum = (values: number[]) => values.reduce((a, b) => a + b, 0)
/** The share of values up to a limit. */
const shareUpTo = (limit: number) => (values: number[]) =>
  values.filter((value) => value <= limit).length / values.length
const countOver = (limit: number) => (values: number[]) => values.filter((value) => !(value <= limit)).length

const mean = (values: number[]) => sum(values) / values.length

export const over = {
  worst,
  sum,
  mean,
  median,
  shareUpTo,
  countOver,
  least: (values: number[]) => Math.min(...values),
}

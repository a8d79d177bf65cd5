import type { ReactNode } from 'react'
import { noise, ours, type Verdict } from '@/bench/publish/report'
import { engineOrder, settingTitle } from '@/lib/evidence/engines'
import { claim, costRow, dearer, defaultCosts, results, sizes } from '@/lib/evidence/results'
import { capital, settingsByEngine, verdictHead, verdictWords } from '@/lib/evidence/words'
import { figure } from '@/lib/figure'
import { typeset } from '@/lib/typeset'
import { EngineName } from './plot'

function claimRow(verdict: Verdict): ReactNode[] {
  const { scene, measure } = verdict
  const { error, cost, asCheap, asExact, frontier } = verdictWords(verdict)
  return [
    <span key="scene">
      {typeset(scene.title)}
      <span className="font-normal text-muted-foreground">
        {scene.measures.length > 1 ? `: ${scene.measures[measure].name}` : ''}
      </span>
    </span>,
    <span key="error" className="whitespace-nowrap">
      {error}
    </span>,
    cost,
    // On a phone, where the table scrolls anyway, narrow columns would only make high rows.
    <span key="cheap" className="block max-sm:min-w-44">
      {asCheap}
    </span>,
    <span key="exact" className="block max-sm:min-w-44">
      {asExact}
    </span>,
    frontier.startsWith('not') ? <strong key="lost">{frontier}</strong> : frontier,
  ]
}

export const claimTable = {
  label: 'The claim, scene by scene',
  head: verdictHead,
  numbers: [1, 2],
  rows: claim.map(claimRow),
}

/** `3`, or `1 to 3` where they differ. */
const span = (counts: number[]) => [...new Set([Math.min(...counts), Math.max(...counts)])].join(' to ')

export const seedsTable = {
  label: 'Seeds of the pours',
  head: ['Engine', 'Default setting', 'Other settings', 'Settings played', '250 pills, each setting'],
  numbers: [1, 2, 3, 4],
  rows: engineOrder.map((engine) => {
    const pours = results.scenes
      .filter(({ seeds }) => seeds > 1)
      .map(({ name }) => results.errors.filter((row) => row.engine === engine && row.scene === name))
    const seeds = pours.map((rows) => rows.map((row) => row.seeds))
    const [large, ...usual] = seeds.toReversed()
    return [
      <EngineName key="engine" engine={engine} />,
      span(usual.map(([first]) => first)),
      span(usual.flatMap(([, ...others]) => others)),
      span(pours.map((rows) => rows.length)),
      span(large),
    ]
  }),
}

export const unmarkedTable = {
  label: 'Settings without a mark',
  head: ['Scene', 'Settings'],
  rows: settingsByEngine(dearer),
}

const fixedSteps = [2, 4, 8, 16, 32]

export const orderTable = {
  label: 'Error of Gravity Stack by sub-steps',
  head: ['Scene', ...fixedSteps.map((steps) => `${steps} sub-steps`), 'Order'],
  numbers: [1, 2, 3, 4, 5, 6],
  rows: results.scenes.flatMap((scene) =>
    scene.measures.flatMap((measure, i) => {
      const errors = fixedSteps.map(
        (steps) =>
          results.errors.find(
            (row) => row.engine === ours && row.scene === scene.name && row.setting.substeps === steps,
          )?.errors[i] ?? Number.NaN,
      )
      const [first, last] = [errors[1], errors[errors.length - 1]]
      const order = Math.log2(first / last) / Math.log2(fixedSteps[fixedSteps.length - 1] / fixedSteps[1])
      // Three kinds of rows have no order: rounding errors, errors that do not depend on the sub-step, and
      // settings that were not simulated.
      if (!measure.ranked || !(first > 1e-6) || measure.unit === 'weights' || !(order >= 0.5)) return []
      const title = scene.measures.length > 1 ? `${scene.title}: ${measure.name}` : scene.title
      return [[title, ...errors.map((error) => `${figure(error)}\u00a0${measure.unit}`), order.toFixed(1)]]
    }),
  ),
}

const pourScene = results.scenes.find((scene) => scene.name === 'pour-pills-60')

export const pourTable = {
  label: 'Sixty pills, all properties',
  head: [
    'Engine',
    'Setting',
    'Seeds',
    ...(pourScene?.measures.map(({ name, unit }) => `${capital(name)}, ${unit}`) ?? []),
  ],
  numbers: [2, 3, 4, 5, 6, 7],
  // Each engine as it comes, and at the setting that overlaps least.
  rows: engineOrder.flatMap((engine) => {
    const own = results.errors.filter((row) => row.engine === engine && row.scene === pourScene?.name)
    const best = [...own].sort((a, b) => (a.errors[0] ?? 1e9) - (b.errors[0] ?? 1e9))[0]
    return own
      .filter((row) => row === own[0] || row === best)
      .map((row) => [
        <EngineName key="engine" engine={engine} />,
        settingTitle(row.setting),
        row.seeds,
        ...row.errors.map((value, i) => {
          const never = pourScene?.measures[i].unit === 's' && (value ?? 6) > 5.9
          return never ? 'not in 6 s' : figure(value ?? Number.POSITIVE_INFINITY)
        }),
      ])
  }),
}

export const sizeTable = {
  label: 'Cost by number of chips, µs a frame',
  head: ['µs a frame', ...sizes.map((size) => `${size.toLocaleString('en')} chips`)],
  numbers: sizes.map((_, i) => i + 1),
  rows: engineOrder
    .filter((engine) => defaultCosts.some((row) => row.engine === engine))
    .map((engine) => [
      <EngineName key="engine" engine={engine} />,
      ...sizes.map((size) => {
        const row = costRow(engine, size)
        if (!row?.cost) {
          return <span title={row?.reason}>{row?.atLeast ? `> ${figure(row.atLeast)}` : '–'}</span>
        }
        const own = costRow(ours, size)?.cost
        const ratio = own && engine !== ours ? ` (${figure(row.cost.mean / own.mean)} ×)` : ''
        return (
          <span
            key={size}
            className="whitespace-nowrap"
            title={`95th percentile: ${figure(row.cost.p95)} µs`}
          >
            {figure(row.cost.mean)}
            <span className="text-muted-foreground">{ratio}</span>
          </span>
        )
      }),
    ]),
}

const phases = [
  ['pour', 'Fall and landing, first 1.5 s'],
  ['settled', 'Lying, kept awake, fourth second'],
  ['mean', 'All four seconds'],
] as const
export const cheaperTable = {
  label: 'Who is cheaper, by number of chips',
  head: ['Chips', ...phases.map(([, title]) => title)],
  rows: sizes.map((size) => [
    size.toLocaleString('en'),
    ...phases.map(([phase]) => {
      const own = costRow(ours, size)?.cost
      if (!own) return '–'
      const shares = engineOrder
        .map((engine) => ({ engine, share: (costRow(engine, size)?.cost?.[phase] ?? Infinity) / own[phase] }))
        .filter(({ engine, share }) => engine !== ours && share * noise < 1)
        .toSorted((a, b) => a.share - b.share)
      return shares.length === 0
        ? 'none'
        : shares.map(({ engine, share }) => (
            <span key={engine} className="block min-w-44">
              <EngineName engine={engine}> {figure(share)}&nbsp;×</EngineName>
            </span>
          ))
    }),
  ]),
}

export const frameTable = {
  label: 'Sixty pills, frame by frame, µs',
  head: [
    'µs a frame',
    'Fall and landing',
    'Lying, kept awake',
    'Median',
    '95th percentile',
    'Worst',
    'Spread between rounds',
    'All asleep',
  ],
  numbers: [1, 2, 3, 4, 5, 6, 7],
  rows: engineOrder.flatMap((engine) => {
    const row = costRow(engine, 60)
    if (!row?.cost) return []
    const { pour, settled, p50, p95, worst } = row.cost
    return [
      [
        <EngineName key="engine" engine={engine} />,
        ...[pour, settled, p50, p95, worst].map((value) => figure(value)),
        row.rounds > 1 && row.spread ? `${(100 * (row.spread - 1)).toFixed(0)} %` : 'timed once',
        figure(results.asleep[engine]),
      ],
    ]
  }),
}

/** The most that any of them has to load. */
const heaviest = Math.max(...results.bytes.map((row) => row.gzip))

export const weightTable = {
  label: 'Bytes, allocation and sleep',
  head: ['Engine', 'kB, gzipped', 'Heap bytes a frame', 'µs a frame, all asleep'],
  numbers: [2, 3],
  rows: results.bytes.map((row) => {
    const engine = engineOrder.find((engine) => engine === row.name)
    return [
      <EngineName key="engine" engine={engine ?? ours}>
        {engine === ours && ', the solver alone'}
        {!engine && ', the whole component'}
      </EngineName>,
      <span key="bytes" className="flex items-center gap-3">
        <span className="w-14 text-right">
          {(row.gzip / 1000).toLocaleString('en', { minimumFractionDigits: 1, maximumFractionDigits: 1 })}
        </span>
        <span aria-hidden="true" className="block h-2.5 w-[min(24rem,30vw)]">
          <span
            className="block h-full min-w-0.5 rounded-sm"
            style={{ width: `${(100 * row.gzip) / heaviest}%`, background: `var(--${engine ?? ours})` }}
          />
        </span>
      </span>,
      engine ? figure(results.allocation[engine]) : '–',
      engine ? figure(results.asleep[engine]) : '0, not called',
    ]
  }),
}

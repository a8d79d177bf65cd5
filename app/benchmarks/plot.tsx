import { scaleLog } from 'd3-scale'
import { type ReactNode, useId } from 'react'
import { engineOrder, looks } from '@/lib/evidence/engines'
import { figure } from '@/lib/figure'

type PlotPoint = { x: number; y: number }
export type PlotLine = { engine: string; points: PlotPoint[] }

const width = 380
const height = 270
const left = 52
const right = 20
const top = 12
const bottom = 36

// Outlines drawn relative to their centre.
const shapes = {
  circle: 'm0-3.6a3.6 3.6 0 1 0 0 7.2a3.6 3.6 0 1 0 0-7.2z',
  square: 'm-3.2-3.2h6.4v6.4h-6.4z',
  triangle: 'm0-4.2 3.9 7h-7.8z',
  diamond: 'm0-4.4 3.8 4.4-3.8 4.4-3.8-4.4z',
  cross: 'm-3-3 6 6m-6 0 6-6',
  plus: 'm-4 0h8m-4-4v8',
}

/** An engine's mark, at the origin. */
export function Mark({ engine }: { engine: string }) {
  const { shape, hollow } = looks[engine]
  return (
    <path
      d={`M0 0${shapes[shape]}`}
      fill={hollow ? 'var(--color-panel)' : `var(--${engine})`}
      stroke={`var(--${engine})`}
      strokeWidth={engine === 'gravity-stack' ? 2.5 : 1.5}
    />
  )
}

/** An engine's name behind its mark, and what else is said of it. */
export function EngineName({ engine, children }: { engine: string; children?: ReactNode }) {
  return (
    // A long name goes on beside its mark, not below it.
    <span className="inline-flex items-baseline">
      <svg
        aria-hidden="true"
        viewBox="-7 -7 14 14"
        className="relative top-[0.15em] mr-2 inline size-3.5 shrink-0"
      >
        <Mark engine={engine} />
      </svg>
      <span>
        {looks[engine].title}
        {children}
      </span>
    </span>
  )
}

/** The marks of all engines, once a page: two thousand outlines in the plots would be most of its bytes. */
export function Markers() {
  return (
    <svg aria-hidden="true" className="absolute size-0">
      <defs>
        {engineOrder.map((engine) => (
          <marker key={engine} id={`mark-${engine}`} markerUnits="userSpaceOnUse" overflow="visible">
            <Mark engine={engine} />
          </marker>
        ))}
      </defs>
    </svg>
  )
}

/** Whole powers of ten round the values, at least one apart. */
function decades(values: number[]): [number, number] {
  const low = Math.floor(Math.log10(Math.min(...values)) + 1e-9)
  const high = Math.ceil(Math.log10(Math.max(...values)) - 1e-9)
  return [10 ** low, 10 ** Math.max(high, low + 1)]
}

function ticks([low, high]: [number, number], most: number) {
  const first = Math.round(Math.log10(low))
  const last = Math.round(Math.log10(high))
  const stride = Math.max(1, Math.ceil((last - first) / most))
  return Array.from({ length: Math.floor((last - first) / stride) + 1 }, (_, i) => 10 ** (first + i * stride))
}

/**
 * Both axes are logarithmic; lower and further left is better. Each mark is a setting. An engine's line joins
 * the settings that no other of its own beats. Values below `floor` are rounding, so they are drawn on it.
 */
export function Plot({
  title,
  lines,
  xLabel,
  yLabel,
  floor = 1e-9,
  frontier,
  joinAll = false,
}: {
  title: string
  lines: PlotLine[]
  xLabel: string
  yLabel: string
  floor?: number
  /** the corner points no other beats, from cheap to dear */
  frontier?: { x: number; y: number }[]
  /** joins every mark of an engine, for plots that are no trade */
  joinAll?: boolean
}) {
  const id = useId()
  const drawn = engineOrder
    .flatMap((engine) => lines.filter((line) => line.engine === engine))
    .map((line) => ({
      ...line,
      points: line.points.filter(({ x, y }) => Number.isFinite(x) && Number.isFinite(y)),
    }))
    .filter((line) => line.points.length > 0)
  const all = drawn.flatMap((line) => line.points)
  if (all.length === 0) return null
  const clamped = (y: number) => Math.max(y, floor)
  const xDomain = decades(all.map(({ x }) => x))
  const yDomain = decades(all.map(({ y }) => clamped(y)))
  const xScale = scaleLog(xDomain, [left, width - right])
  const yScale = scaleLog(yDomain, [height - bottom, top])
  const at = ({ x, y }: { x: number; y: number }): [number, number] => [xScale(x), yScale(clamped(y))]
  const path = (points: { x: number; y: number }[]) =>
    points
      .map(
        (point, i) =>
          `${i === 0 ? 'M' : 'L'}${at(point)
            .map((v) => v.toFixed(1))
            .join(' ')}`,
      )
      .join('')
  const stairs = frontier?.map((point) => at(point)) ?? []
  const edge =
    stairs.length > 0
      ? `M${stairs[0][0].toFixed(1)} ${top}${stairs
          .map(([x, y], i) => `${i > 0 ? `H${x.toFixed(1)}` : ''}V${y.toFixed(1)}`)
          .join('')}H${width - right}`
      : ''

  return (
    <svg viewBox={`0 0 ${width} ${height}`} role="img" aria-labelledby={id} className="block w-full">
      <title
        id={id}
      >{`${title}: ${yLabel} against ${xLabel}, both logarithmic. The table below has the figures.`}</title>
      {edge && (
        <path
          d={`${edge}V${height - bottom}H${left}V${top}Z`}
          fill="var(--color-foreground)"
          fillOpacity={0.045}
        />
      )}
      {ticks(xDomain, 6).map((tick) => (
        <g key={tick}>
          <line
            x1={xScale(tick)}
            x2={xScale(tick)}
            y1={top}
            y2={height - bottom}
            stroke="var(--color-border)"
          />
          <text x={xScale(tick)} y={height - bottom + 14} fontSize={10} textAnchor="middle">
            {figure(tick)}
          </text>
        </g>
      ))}
      {ticks(yDomain, 7).map((tick) => (
        <g key={tick}>
          <line
            x1={left}
            x2={width - right}
            y1={yScale(tick)}
            y2={yScale(tick)}
            stroke="var(--color-border)"
          />
          <text x={left - 6} y={yScale(tick) + 3.5} fontSize={10} textAnchor="end">
            {tick <= floor * 1.0001 ? `≤ ${figure(floor)}` : figure(tick)}
          </text>
        </g>
      ))}
      <text x={(left + width - right) / 2} y={height - 4} fontSize={10.5} textAnchor="middle">
        {xLabel}
      </text>
      <text
        transform={`translate(9 ${(top + height - bottom) / 2}) rotate(-90)`}
        fontSize={10.5}
        textAnchor="middle"
      >
        {yLabel}
      </text>
      {edge && (
        <path
          d={edge}
          fill="none"
          stroke="var(--color-muted-foreground)"
          strokeWidth={1}
          strokeDasharray="3 3"
        />
      )}
      {[...drawn].reverse().map(({ engine, points }) => {
        const sorted = [...points].sort((a, b) => a.x - b.x)
        const joined = joinAll
          ? sorted
          : sorted.filter((point, i) => sorted.slice(0, i).every((cheaper) => cheaper.y > point.y))
        return (
          <g key={engine} data-engine={engine}>
            <title>{looks[engine].title}</title>
            <path
              d={path(joined)}
              fill="none"
              stroke={`var(--${engine})`}
              strokeWidth={engine === 'gravity-stack' ? 2.25 : 1.25}
              strokeOpacity={engine === 'gravity-stack' ? 1 : 0.55}
            />
            <path
              d={`${path(sorted)}h0`}
              fill="none"
              markerStart={`url(#mark-${engine})`}
              markerMid={`url(#mark-${engine})`}
            />
          </g>
        )
      })}
    </svg>
  )
}

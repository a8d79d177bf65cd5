'use client'

import { useState } from 'react'
import { engineOrder, figure, looks } from './engines'
import { Table } from './table'

/** Engine's place in `engineOrder`, setting, error (null: without bound), µs a frame, 1 on the frontier. */
export type FigureRow = [engine: number, setting: string, error: number | null, cost: number, best: 0 | 1]

/** What a plot shows, in figures. Rows are made when they are asked for: thirty plots have two thousand. */
export function PlotTable({ label, unit, rows }: { label: string; unit: string; rows: FigureRow[] }) {
  const [open, setOpen] = useState(false)
  return (
    <details className="mt-1 text-sm" onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary className="w-fit cursor-pointer rounded-md px-1 py-1 text-muted-foreground hover:text-foreground">
        Figures<span className="sr-only">: {label}</span>
      </summary>
      {open && (
        <div className="mt-2 max-h-96 overflow-y-auto">
          <Table
            label={label}
            head={['Engine', 'Setting', `Error, ${unit}`, 'µs']}
            rows={rows.map(([engine, setting, error, cost, best]) => [
              `${looks[engineOrder[engine]].title}${best ? ' (frontier)' : ''}`,
              setting,
              figure(error ?? Number.POSITIVE_INFINITY),
              figure(cost),
            ])}
          />
        </div>
      )}
    </details>
  )
}

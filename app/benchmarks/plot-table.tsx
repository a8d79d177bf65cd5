'use client'

import { useState } from 'react'
import { at } from '@/lib/address'
import { engineOrder } from '@/lib/evidence/engines'
import type { FigureRow } from '@/lib/evidence/results'
import { figure } from '@/lib/figure'
import { EngineName } from './plot'
import { Table } from './table'

let figures: Promise<Record<string, FigureRow[]>> | undefined

async function fetchFigures(): Promise<Record<string, FigureRow[]>> {
  const response = await fetch(at('/benchmarks/figures.json'))
  if (!response.ok) throw new Error(response.statusText)
  return response.json()
}

/**
 * The figures of a plot. They are fetched when the first table is opened: thirty plots have two thousand
 * rows.
 */
export function PlotTable({ name, label, unit }: { name: string; label: string; unit: string }) {
  const [rows, setRows] = useState<FigureRow[] | 'failed'>()

  async function show() {
    figures ??= fetchFigures()
    try {
      setRows((await figures)[name])
    } catch {
      figures = undefined
      setRows('failed')
    }
  }

  return (
    <details
      className="mt-1 text-sm"
      onToggle={show}
      // It may have been opened before the script was there to hear of it.
      ref={(details) => void (details?.open && !rows && show())}
    >
      <summary className="w-fit cursor-pointer rounded-md px-1 py-1 text-muted-foreground hover:text-foreground">
        Figures<span className="sr-only">: {label}</span>
      </summary>
      {rows === 'failed' && <p role="alert">They could not be fetched; the raw data above has them.</p>}
      {!rows && (
        <p>
          <a href={at('/benchmarks/errors.csv')} download className="underline underline-offset-4">
            errors.csv
          </a>{' '}
          has them.
        </p>
      )}
      {Array.isArray(rows) && (
        <div className="mt-2 max-h-96 overflow-y-auto">
          <Table
            label={label}
            head={['Engine', 'Setting', `Error, ${unit}`, 'µs']}
            numbers={[2, 3]}
            rows={rows.map(([engine, setting, error, cost, best]) => [
              <EngineName key="engine" engine={engineOrder[engine]}>
                {best ? ' (frontier)' : ''}
              </EngineName>,
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

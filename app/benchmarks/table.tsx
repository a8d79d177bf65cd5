import type { ReactNode } from 'react'

/**
 * A table that scrolls by itself when the page is narrower. The first cell of a row names it; `numbers` are
 * the columns whose figures stand one below the other.
 */
export function Table({
  label,
  head,
  rows,
  numbers = [],
}: {
  label: string
  head: ReactNode[]
  rows: ReactNode[][]
  numbers?: number[]
}) {
  const aligned = (column: number) => (numbers.includes(column) ? 'text-right' : '')
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: a table that scrolls must be reachable
    // biome-ignore lint/a11y/useSemanticElements: a region of the page, not a section of the text
    <div role="region" aria-label={label} tabIndex={0} className="overflow-x-auto rounded-xl border bg-panel">
      <table className="w-full text-left text-sm">
        <thead>
          <tr className="border-b align-bottom text-muted-foreground">
            {head.map((cell, i) => (
              // biome-ignore lint/suspicious/noArrayIndexKey: columns keep their place
              <th key={i} scope="col" className={`px-3 py-2.5 font-medium ${aligned(i)}`}>
                {cell}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {rows.map((row, i) => (
            // biome-ignore lint/suspicious/noArrayIndexKey: rows keep their place
            <tr key={i} className="border-b align-baseline last:border-0">
              {row.map((cell, j) =>
                j === 0 ? (
                  // biome-ignore lint/suspicious/noArrayIndexKey: columns keep their place
                  <th key={j} scope="row" className="min-w-36 px-3 py-2 font-medium">
                    {cell}
                  </th>
                ) : (
                  // biome-ignore lint/suspicious/noArrayIndexKey: columns keep their place
                  <td key={j} className={`px-3 py-2 tabular-nums ${aligned(j)}`}>
                    {cell}
                  </td>
                ),
              )}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  )
}

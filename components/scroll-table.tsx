import type { ReactNode } from 'react'

/** A table that scrolls inside its box where it is wider than the column, with the keyboard too. */
export function ScrollTable({ label, children }: { label: string; children: ReactNode }) {
  return (
    // biome-ignore lint/a11y/useSemanticElements: a group without being a landmark or a fieldset
    // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must be reachable
    <div role="group" aria-label={label} tabIndex={0} className="overflow-x-auto rounded-xl border bg-panel">
      <table className="w-full text-left text-sm">{children}</table>
    </div>
  )
}

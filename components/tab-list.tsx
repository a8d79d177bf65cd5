'use client'

import type { KeyboardEvent } from 'react'

type Tab = { value: string; label: string }

/** Classes of the row, and of a tab. */
const looks = {
  segments: [
    'gap-0.5 rounded-lg bg-muted p-0.5',
    'px-3 py-1 aria-selected:bg-panel aria-selected:shadow-[0_1px_2px_rgb(0_0_0/0.12),0_0_0_1px_var(--border)]',
  ],
  quiet: ['gap-1', 'px-2 py-1 font-mono text-xs aria-selected:bg-muted'],
}

/**
 * The row of a tabs widget: one tab stop, arrow keys move and select. Panels have the id `${id}-${value}`.
 */
export function TabList({
  id,
  label,
  tabs,
  value,
  onSelect,
  look = 'segments',
}: {
  id: string
  label: string
  tabs: readonly Tab[]
  value: string
  onSelect: (value: string) => void
  look?: keyof typeof looks
}) {
  const [rowClasses, tabClasses] = looks[look]
  const move = (event: KeyboardEvent<HTMLDivElement>) => {
    const at = tabs.findIndex((tab) => tab.value === value)
    const to = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: tabs.length - 1 }[event.key]
    if (to === undefined) return
    event.preventDefault()
    const next = (to + tabs.length) % tabs.length
    onSelect(tabs[next].value)
    event.currentTarget.querySelectorAll<HTMLElement>('[role=tab]')[next].focus()
  }

  return (
    <div role="tablist" aria-label={label} onKeyDown={move} className={`flex ${rowClasses}`}>
      {tabs.map((tab) => (
        <button
          key={tab.value}
          type="button"
          role="tab"
          id={`${id}-tab-${tab.value}`}
          aria-controls={`${id}-${tab.value}`}
          aria-selected={tab.value === value}
          tabIndex={tab.value === value ? 0 : -1}
          onClick={() => onSelect(tab.value)}
          className={`rounded-md text-sm text-muted-foreground transition-colors hover:text-foreground aria-selected:text-foreground ${tabClasses}`}
        >
          {tab.label}
        </button>
      ))}
    </div>
  )
}

'use client'

import { type ReactNode, useId, useState } from 'react'
import { CopyButton } from './copy-button'
import { Demo } from './demo'
import { TabList } from './tab-list'

const tabs = [
  { value: 'preview', label: 'Preview' },
  { value: 'code', label: 'Code' },
]

/**
 * Preview and code share one grid cell, so the box keeps its height and the pile keeps its place behind the
 * code.
 */
export function PreviewTabs({ name, code, again }: { name: string; code: ReactNode; again: ReactNode }) {
  const id = useId()
  const [tab, setTab] = useState('preview')
  const [drop, setDrop] = useState(0)

  const panel = (value: string) => ({
    role: 'tabpanel',
    id: `${id}-${value}`,
    'aria-labelledby': `${id}-tab-${value}`,
    inert: tab !== value,
  })
  return (
    <div className="code overflow-hidden rounded-2xl border bg-panel">
      <div data-print="hide" className="flex items-center justify-between border-b p-1.5">
        <TabList id={id} label={name} tabs={tabs} value={tab} onSelect={setTab} />
        {tab === 'preview' ? (
          <button
            type="button"
            onClick={() => setDrop(drop + 1)}
            className="inline-flex h-8 items-center gap-2 rounded-md px-2 text-muted-foreground text-sm transition-colors hover:bg-muted hover:text-foreground motion-reduce:hidden"
          >
            {again}
          </button>
        ) : (
          <CopyButton />
        )}
      </div>
      <div className="grid min-w-0 grid-cols-[minmax(0,1fr)] *:col-start-1 *:row-start-1">
        <div
          {...panel('preview')}
          // What a footer stands on is the end of the page.
          className="not-has-[footer]:mb-3 not-has-[footer]:border-b bg-stage inert:invisible"
        >
          <Demo name={name} drop={drop} />
        </div>
        <div {...panel('code')} className="inert:invisible relative inert:[content-visibility:hidden]">
          {code}
        </div>
      </div>
    </div>
  )
}

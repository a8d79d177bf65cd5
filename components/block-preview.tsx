'use client'

import { type CSSProperties, type ReactNode, useId, useState } from 'react'
import { at } from '@/lib/address'
import { BlockFrame } from './block-frame'
import { CopyButton } from './copy-button'
import { TabList } from './tab-list'

const tabs = [
  { value: 'preview', label: 'Preview' },
  { value: 'phone', label: 'Phone' },
  { value: 'code', label: 'Code' },
]

/** A block live, as wide as the page or as a phone, and its code, all in one box that keeps its height. */
export function BlockPreview({
  name,
  title,
  heights,
  code,
}: {
  name: string
  title: string
  heights: { wide: number; narrow: number }
  code: ReactNode
}) {
  const id = useId()
  const [tab, setTab] = useState('preview')
  const live = tab !== 'code'
  // Both tabs of the live block have one panel.
  const shown = live ? tab : 'preview'
  return (
    <div
      className="code overflow-hidden rounded-2xl border bg-panel"
      style={{ '--wide': `${heights.wide}px`, '--narrow': `${heights.narrow}px` } as CSSProperties}
    >
      <div data-print="hide" className="flex items-center justify-between border-b p-1.5">
        <TabList id={id} label={title} tabs={tabs} value={tab} onSelect={setTab} />
        {live ? (
          <a
            href={at(`/blocks/${name}`)}
            className="rounded-md px-2 py-1.5 text-muted-foreground text-sm hover:bg-muted hover:text-foreground"
          >
            Full page
          </a>
        ) : (
          <CopyButton />
        )}
      </div>
      <div className="grid min-w-0 grid-cols-[minmax(0,1fr)] bg-stage *:col-start-1 *:row-start-1">
        <div
          role="tabpanel"
          id={`${id}-${shown}`}
          aria-labelledby={`${id}-tab-${shown}`}
          inert={!live}
          className={`inert:invisible mx-auto w-full ${tab === 'phone' ? 'max-w-[375px]' : ''}`}
        >
          <BlockFrame
            name={name}
            title={title}
            className={tab === 'phone' ? 'h-(--narrow)' : 'h-(--narrow) lg:h-(--wide)'}
          />
        </div>
        <div
          role="tabpanel"
          id={`${id}-code`}
          aria-labelledby={`${id}-tab-code`}
          inert={live}
          className="inert:invisible relative min-h-96 bg-panel inert:[content-visibility:hidden]"
        >
          {code}
        </div>
      </div>
    </div>
  )
}

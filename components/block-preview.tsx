'use client'

import { type CSSProperties, useId, useState } from 'react'
import { at } from '@/lib/address'
import { BlockFrame } from './block-frame'
import { CopyButton } from './copy-button'
import { TabList } from './tab-list'
import { useSource } from './use-source'

const tabs = [
  { value: 'preview', label: 'Preview' },
  { value: 'phone', label: 'Phone' },
  { value: 'code', label: 'Code' },
]

/**
 * A block live, as wide as the page or as a phone, and its code, all in one box that keeps its height. The
 * code is fetched when it is first shown: the code of twelve blocks would be two thirds of the page.
 */
export function BlockPreview({
  name,
  title,
  heights,
}: {
  name: string
  title: string
  heights: { wide: number; narrow: number }
}) {
  const id = useId()
  const [tab, setTab] = useState('preview')
  const source = useSource(name)
  const live = tab !== 'code'
  // Both tabs of the live block have one panel.
  const shown = live ? tab : 'preview'

  function select(next: string) {
    setTab(next)
    if (next === 'code') source.load()
  }

  return (
    <div
      className="code overflow-hidden rounded-2xl border bg-panel"
      style={{ '--wide': `${heights.wide}px`, '--narrow': `${heights.narrow}px` } as CSSProperties}
    >
      <div data-print="hide" className="flex items-center justify-between border-b p-1.5">
        <TabList id={id} label={title} tabs={tabs} value={tab} onSelect={select} />
        {live ? (
          <a
            href={at(`/blocks/${name}`)}
            className="rounded-md px-2 py-1.5 text-muted-foreground text-sm hover:bg-muted hover:text-foreground"
          >
            Full page
          </a>
        ) : (
          <CopyButton from={`/source/${name}.tsx.txt`} />
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
          {source.html ? (
            <div
              className="absolute inset-0 [&>pre]:h-full"
              // biome-ignore lint/security/noDangerouslySetInnerHtml: HTML of our own, made by the build
              dangerouslySetInnerHTML={{ __html: source.html }}
            />
          ) : (
            <p role="status" className="p-4 text-muted-foreground text-sm">
              {source.state === 'fetching' && 'Fetching…'}
              {source.state === 'failed' && 'The code could not be fetched. Choose Code again to retry.'}
            </p>
          )}
        </div>
      </div>
    </div>
  )
}

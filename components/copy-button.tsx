'use client'

import { useEffect, useState } from 'react'
import { at } from '@/lib/address'
import { CheckIcon, CopyIcon } from './icons'

async function textAt(path: string) {
  const response = await fetch(at(path))
  if (!response.ok) throw new Error(`${path}: ${response.status}`)
  return response.text()
}

/**
 * Copies what `text` gives, or what stands at the address `from` of this site, or else the code in the same
 * `.code` box. The words beside the icon are there when `children` are. A `label` that says more than they do
 * contains them.
 */
export function CopyButton({
  text,
  from,
  children,
  label = children ?? 'Copy code',
  className = '',
}: {
  text?: () => Promise<string>
  from?: string
  children?: string
  label?: string
  className?: string
}) {
  const [state, setState] = useState<'idle' | 'copied' | 'failed'>('idle')

  useEffect(() => {
    if (state === 'idle') return
    const timer = setTimeout(() => setState('idle'), 2000)
    return () => clearTimeout(timer)
  }, [state])

  async function copy(button: HTMLElement) {
    try {
      if (text || from) {
        // The promise goes into the clipboard item: Safari lets nothing be copied after an await.
        const answer = (text ? text() : textAt(from!)).then((it) => new Blob([it], { type: 'text/plain' }))
        await navigator.clipboard.write([new ClipboardItem({ 'text/plain': answer })])
      } else {
        const code = Array.from(button.closest('.code')!.querySelectorAll('pre'))
        const shown = code.find((pre) => pre.checkVisibility())
        await navigator.clipboard.writeText(shown!.textContent)
      }
      setState('copied')
    } catch {
      setState('failed')
    }
  }

  const said = { idle: label, copied: 'Copied', failed: 'Not copied' }[state]
  return (
    <>
      <button
        type="button"
        data-print="hide"
        data-state={state}
        aria-label={said}
        title={said}
        onClick={(event) => copy(event.currentTarget)}
        className={`inline-flex h-8 min-w-8 shrink-0 items-center justify-center gap-2 rounded-md px-2 text-muted-foreground text-sm transition-colors hover:bg-muted hover:text-foreground data-[state=failed]:text-red-700 dark:data-[state=failed]:text-red-300 ${className}`}
      >
        {state === 'copied' ? <CheckIcon /> : <CopyIcon />}
        {children && <span>{state === 'idle' ? children : said}</span>}
      </button>
      <span role="status" className="sr-only">
        {state === 'idle' ? '' : said}
      </span>
    </>
  )
}

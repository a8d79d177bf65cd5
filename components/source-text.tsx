'use client'

import type { ReactNode } from 'react'
import { useSource } from './use-source'

/** The button that had the focus is gone; a reader who has moved on meanwhile is left alone. */
function takeFocus(code: HTMLElement | null) {
  if (document.activeElement === document.body) code?.querySelector('pre')?.focus({ preventScroll: true })
}

/** `children` are the first lines; a press on `all` brings the file in full, highlighted at build time. */
export function SourceText({ all, plain, children }: { all: string; plain: ReactNode; children: ReactNode }) {
  const { html, state, load } = useSource('gravity-stack')

  return (
    <>
      {html ? (
        // biome-ignore lint/security/noDangerouslySetInnerHtml: our own file, turned into HTML at build time
        <div ref={takeFocus} className="[&>pre]:max-h-[36rem]" dangerouslySetInnerHTML={{ __html: html }} />
      ) : (
        children
      )}
      <div className="flex flex-wrap items-center gap-x-4 gap-y-1 border-t px-4 py-2 text-sm">
        {!html && (
          <button
            type="button"
            onClick={load}
            className="font-medium underline decoration-foreground/30 underline-offset-4 hover:decoration-foreground"
          >
            {state === 'fetching' ? 'Fetching…' : all}
          </button>
        )}
        {plain}
        {state === 'failed' && <span role="alert">It could not be fetched; the plain text may work.</span>}
      </div>
    </>
  )
}

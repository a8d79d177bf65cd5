'use client'

import { useRef } from 'react'
import { DocsNavigation, type Navigation } from './docs-navigation'
import { MenuIcon } from './icons'

/** The docs' navigation on narrow screens: a native dialog, which keeps the focus and closes on Escape by itself. */
export function MobileNavigation({ sections }: { sections: Navigation }) {
  const dialog = useRef<HTMLDialogElement>(null)
  const close = () => dialog.current?.close()
  return (
    <div className="lg:hidden">
      <button
        type="button"
        aria-label="Menu"
        onClick={() => dialog.current?.showModal()}
        className="inline-flex size-9 items-center justify-center rounded-md text-muted-foreground hover:bg-muted hover:text-foreground"
      >
        <MenuIcon />
      </button>
      {/* biome-ignore lint/a11y/useKeyWithClickEvents: a press beside the panel; Escape does it for the keyboard */}
      <dialog
        ref={dialog}
        aria-label="Menu"
        onClick={(event) => event.target === event.currentTarget && close()}
        className="mr-0 ml-auto h-dvh max-h-none w-72 max-w-[85vw] border-l bg-background p-0 text-foreground backdrop:bg-black/40"
      >
        <nav aria-label="Pages" className="h-full overflow-y-auto px-3 py-4">
          <div className="mb-2 flex justify-end">
            <button
              type="button"
              onClick={close}
              className="rounded-md px-3 py-1.5 text-muted-foreground text-sm hover:bg-muted hover:text-foreground"
            >
              Close
            </button>
          </div>
          <DocsNavigation sections={sections} onNavigate={close} />
        </nav>
      </dialog>
    </div>
  )
}

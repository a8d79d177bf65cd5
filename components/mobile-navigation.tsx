'use client'

import { type ReactNode, useRef } from 'react'

/**
 * The docs' navigation on narrow screens: a native dialog, which keeps the focus and closes on Escape by
 * itself. `children` are links from the server, which doesn't know the page: it is marked when the menu
 * opens.
 */
export function MobileNavigation({ icon, children }: { icon: ReactNode; children: ReactNode }) {
  const dialog = useRef<HTMLDialogElement>(null)
  const close = () => dialog.current?.close()
  const open = () => {
    for (const link of dialog.current!.querySelectorAll('a'))
      link.ariaCurrent = link.pathname === location.pathname ? 'page' : null
    dialog.current!.showModal()
  }
  return (
    <div className="lg:hidden">
      <button
        type="button"
        aria-label="Menu"
        onClick={open}
        className="inline-flex h-9 w-[min(2.25rem,12vw)] items-center justify-center rounded-md text-muted-foreground hover:bg-muted hover:text-foreground"
      >
        {icon}
      </button>
      {/* biome-ignore lint/a11y/useKeyWithClickEvents: Escape closes it by the keyboard */}
      <dialog
        ref={dialog}
        aria-label="Menu"
        onClick={({ target, currentTarget }) => {
          if (target === currentTarget || (target as Element).closest('a')) close()
        }}
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
          {children}
        </nav>
      </dialog>
    </div>
  )
}

'use client'

import { type ReactNode, useLayoutEffect, useRef } from 'react'

/** Whether a key pressed there writes something. */
const isField = (target: EventTarget) =>
  target instanceof Element && target.closest('input, textarea, select, [contenteditable]')

/**
 * Makes the button among its children open the dialog among them, as ⌘K, Ctrl K and a slash do. They are the
 * search as it stands in the page's HTML, with a field to type into while the script is on its way. Nothing
 * of the search is fetched before it is opened; `failed` is said when it can't be.
 */
export function SearchOpener({
  index,
  failed,
  children,
}: {
  index: string
  failed: string
  children: ReactNode
}) {
  const box = useRef<HTMLDivElement>(null)

  // A layout effect runs in the task in which React takes the page over. A passive effect would run later,
  // and a key pressed before that would be lost.
  useLayoutEffect(() => {
    const dialog = box.current!.querySelector('dialog')!
    const toggle = () => {
      if (dialog.open) return dialog.close()
      dialog.showModal()
      import('./search-panel').then(
        ({ mount }) => mount(dialog, index),
        () => {
          dialog.querySelector('[role=status]')!.textContent = failed
        },
      )
    }
    const press = (event: KeyboardEvent) => {
      const slash = event.key === '/' && !isField(event.composedPath()[0])
      const command = event.metaKey || event.ctrlKey
      if (event.altKey || (slash ? command : !command || event.key.toLowerCase() !== 'k')) return
      const modal = document.querySelector('dialog:modal')
      if (modal && modal !== dialog) return
      event.preventDefault()
      toggle()
    }
    // A press beside the panel is one on the dialog itself.
    const pressBeside = ({ target }: Event) => target === dialog && dialog.close()
    const button = box.current!.querySelector('button')!
    button.addEventListener('click', toggle)
    dialog.addEventListener('click', pressBeside)
    addEventListener('keydown', press)
    return () => {
      button.removeEventListener('click', toggle)
      dialog.removeEventListener('click', pressBeside)
      removeEventListener('keydown', press)
    }
  }, [index, failed])

  return <div ref={box}>{children}</div>
}

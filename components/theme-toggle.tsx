'use client'

import { type ReactNode, useEffect } from 'react'
import { save } from '@/lib/preferences'

/** Light or dark; until someone presses it the page follows the system's setting, also when that changes. */
export function ThemeToggle({ children }: { children: ReactNode }) {
  useEffect(() => {
    const system = matchMedia('(prefers-color-scheme: dark)')
    const follow = () => {
      try {
        if (localStorage.getItem('theme')) return
      } catch {
        // Nothing can be saved, so nothing was.
      }
      document.documentElement.classList.toggle('dark', system.matches)
    }
    // Paper is white.
    const paper = matchMedia('print')
    let wasDark = false
    const print = () => {
      if (paper.matches) wasDark = document.documentElement.classList.contains('dark')
      document.documentElement.classList.toggle('dark', wasDark && !paper.matches)
    }
    system.addEventListener('change', follow)
    paper.addEventListener('change', print)
    // What changed while this script was on its way was heard by nobody.
    follow()
    if (paper.matches) print()
    return () => {
      system.removeEventListener('change', follow)
      paper.removeEventListener('change', print)
    }
  }, [])

  return (
    <button
      type="button"
      aria-label="Switch between light and dark"
      title="Switch between light and dark"
      onClick={() => {
        const dark = document.documentElement.classList.toggle('dark')
        save('theme', dark ? 'dark' : 'light')
      }}
      className="inline-flex h-9 w-[min(2.25rem,12vw)] items-center justify-center rounded-md text-muted-foreground transition-colors hover:bg-muted hover:text-foreground"
    >
      {children}
    </button>
  )
}

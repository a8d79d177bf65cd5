import type { ReactNode } from 'react'
import { navigation } from '@/lib/docs'
import { DocsNavigation } from './docs-navigation'

/** A page of the docs beside their navigation. Layouts of Next don't know which page they hold. */
export function DocsLayout({ path, children }: { path: string; children: ReactNode }) {
  return (
    <div className="mx-auto grid w-full max-w-[88rem] flex-1 grid-cols-[minmax(0,1fr)] px-4 sm:px-6 lg:grid-cols-[13rem_minmax(0,1fr)] lg:gap-12">
      <div data-print="hide" className="hidden lg:block">
        <nav
          aria-label="Docs"
          className="-ml-3 sticky top-14 max-h-[calc(100dvh-3.5rem)] overflow-y-auto pt-10 pb-10"
        >
          <DocsNavigation sections={navigation} path={path} />
        </nav>
      </div>
      {children}
    </div>
  )
}

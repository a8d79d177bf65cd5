import type { ComponentProps, ReactNode } from 'react'
import { SearchIcon } from './icons'

// The parts of the search that stand in the page's HTML before its script has come, and after it as well.

export const searchWords = {
  fetching: 'Fetching…',
  failed: 'The search could not be fetched. Close it, and open it to try again.',
}

/** The field, and the button that closes the dialog: a form's, so that it needs no script. */
export function SearchBar(field: ComponentProps<'input'>) {
  return (
    <div className="flex items-center gap-3 border-b pr-2 pl-4 text-muted-foreground">
      <SearchIcon />
      <input
        type="text"
        aria-label="Search"
        placeholder="Search the docs"
        enterKeyHint="go"
        // Large enough that a phone does not zoom in on it.
        className="h-12 min-w-0 flex-1 bg-transparent text-base text-foreground outline-none placeholder:text-muted-foreground"
        {...field}
      />
      <form method="dialog">
        <button type="submit" className="rounded-md px-3 py-1.5 text-sm hover:bg-muted hover:text-foreground">
          Close
        </button>
      </form>
    </div>
  )
}

export function SearchStatus({ children }: { children: ReactNode }) {
  return (
    <div className="flex items-center justify-between gap-4 px-4 py-2.5 text-muted-foreground text-xs not-first:border-t">
      <p role="status" className="wrap-anywhere">
        {children}
      </p>
      <p aria-hidden="true" className="hidden shrink-0 sm:block">
        ↑ ↓ to move, ↵ to open, Esc to close
      </p>
    </div>
  )
}

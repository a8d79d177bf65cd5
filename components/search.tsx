import { at } from '@/lib/address'
import { SearchIcon } from './icons'
import { SearchOpener } from './search-opener'
import { SearchBar, SearchStatus, searchWords } from './search-shell'

/** The search in the header: a button, and the dialog that it opens. */
export function Search() {
  return (
    <SearchOpener index={at('/search.json')} failed={searchWords.failed}>
      <button
        type="button"
        aria-haspopup="dialog"
        aria-keyshortcuts="/ Control+K Meta+K"
        title="Search (/, Ctrl K or ⌘K)"
        className="flex h-9 min-w-[min(2.25rem,12vw)] items-center justify-center gap-2 rounded-md text-muted-foreground text-sm transition-colors hover:bg-muted hover:text-foreground lg:border lg:px-3"
      >
        <SearchIcon />
        <span className="sr-only lg:not-sr-only">Search</span>
        <span aria-hidden="true" className="hidden rounded border px-1.5 font-mono text-xs lg:inline">
          /
        </span>
      </button>
      <dialog
        aria-label="Search"
        className="mx-auto mt-2 w-[calc(100%-1rem)] max-w-2xl overflow-hidden rounded-2xl border bg-background p-0 text-foreground shadow-2xl backdrop:bg-black/40 sm:mt-[10vh]"
      >
        <SearchBar />
        <SearchStatus>{searchWords.fetching}</SearchStatus>
      </dialog>
    </SearchOpener>
  )
}

'use client'

import { type KeyboardEvent, type MouseEvent, useEffect, useId, useRef, useState } from 'react'
import { flushSync } from 'react-dom'
import { createRoot, type Root } from 'react-dom/client'
import { at } from '@/lib/address'
import { type Entry, excerpt, marked, search } from '@/lib/search'
import { SearchBar, SearchStatus, searchWords } from './search-shell'

let root: Root | undefined
let opened = 0

/** Puts the panel into the dialog, empty each time but for what was typed before this script had come. */
export function mount(dialog: HTMLDialogElement, index: string) {
  const typed = root ? '' : dialog.querySelector('input')!.value
  root ??= createRoot(dialog)
  // At once: a key pressed between two fields would be lost.
  flushSync(() => root!.render(<SearchPanel key={opened++} index={index} typed={typed} />))
}

let loading: Promise<Entry[]> | undefined

/** The index, asked for once; after a failure it is asked for again. */
function load(index: string) {
  loading ??= fetch(index)
    .then((response) => {
      if (!response.ok) throw new Error(`${index}: ${response.status}`)
      return response.json()
    })
    .catch((error) => {
      loading = undefined
      throw error
    })
  return loading
}

const shown = 40

const count = (found: number, query: string) => {
  if (query === '') return `${found} pages`
  if (found === 0) return `Nothing has the words “${query}”`
  if (found > shown) return `${found} results, the best ${shown} are listed`
  return found === 1 ? '1 result' : `${found} results`
}

const code: Entry['kind'][] = ['Prop', 'Action', 'Error message']

/** A field and what it finds: arrows move, Enter opens, and how much was found is announced. */
function SearchPanel({ index, typed }: { index: string; typed: string }) {
  const id = useId()
  const list = useRef<HTMLDivElement>(null)
  const [entries, setEntries] = useState<Entry[]>()
  const [failed, setFailed] = useState(false)
  const [typing, setTyping] = useState(typed)
  const [active, setActive] = useState(0)

  useEffect(() => {
    load(index).then(setEntries, () => setFailed(true))
  }, [index])

  const query = typing.trim()
  const all = entries ?? []
  const found = query === '' ? all.filter(({ kind }) => kind === 'Page') : search(all, query)
  const listed = found.slice(0, shown)

  function go(to: number) {
    const next = (to + listed.length) % listed.length
    setActive(next)
    list.current!.children[next].scrollIntoView({ block: 'nearest' })
  }

  function press(event: KeyboardEvent<HTMLInputElement>) {
    if (event.nativeEvent.isComposing || listed.length === 0) return
    if (event.key === 'ArrowDown') go(active + 1)
    else if (event.key === 'ArrowUp') go(active - 1)
    else if (event.key === 'Enter') {
      const { altKey, ctrlKey, metaKey, shiftKey } = event
      const click = { bubbles: true, cancelable: true, altKey, ctrlKey, metaKey, shiftKey }
      list.current!.children[active].dispatchEvent(new window.MouseEvent('click', click))
    } else return
    event.preventDefault()
  }

  /** A link that opens here closes the search: it may lead to another place on this page. */
  function leave({ altKey, ctrlKey, metaKey, shiftKey, currentTarget }: MouseEvent) {
    if (!altKey && !ctrlKey && !metaKey && !shiftKey) currentTarget.closest('dialog')!.close()
  }

  return (
    <>
      <SearchBar
        role="combobox"
        aria-autocomplete="list"
        aria-controls={id}
        aria-expanded={listed.length > 0}
        aria-activedescendant={listed.length > 0 ? `${id}-${active}` : undefined}
        autoComplete="off"
        spellCheck={false}
        autoFocus
        value={typing}
        onChange={(event) => {
          setTyping(event.target.value)
          setActive(0)
          list.current!.scrollTop = 0
        }}
        onKeyDown={press}
      />
      <div
        ref={list}
        role="listbox"
        id={id}
        aria-label="Results"
        // As many rows as fit above a phone's keyboard, or so.
        className="max-h-[min(28rem,calc(100dvh-9rem))] scroll-py-2 overflow-y-auto overscroll-contain p-2 empty:hidden sm:max-h-[min(28rem,calc(80dvh-7rem))]"
      >
        {listed.map((entry, place) => (
          <a
            key={entry.href + entry.title}
            href={at(entry.href)}
            role="option"
            id={`${id}-${place}`}
            aria-selected={place === active}
            tabIndex={-1}
            onMouseMove={() => setActive(place)}
            onClick={leave}
            className="block rounded-lg px-3 py-2 aria-selected:bg-muted"
          >
            <span className="flex items-baseline justify-between gap-4">
              <span
                className={`wrap-anywhere font-medium ${code.includes(entry.kind) ? 'font-mono text-[0.8125rem]' : 'text-sm'}`}
              >
                <Marked text={entry.title} query={query} />
              </span>
              <span className="shrink-0 text-muted-foreground text-xs">{entry.kind}</span>
            </span>
            <span className="mt-0.5 line-clamp-2 text-muted-foreground text-xs leading-relaxed">
              {entry.page !== entry.title && <span className="text-foreground/80">{entry.page} · </span>}
              <Marked text={excerpt(entry.text, query)} query={query} />
            </span>
          </a>
        ))}
      </div>
      <SearchStatus>
        {failed ? searchWords.failed : entries ? count(found.length, query) : searchWords.fetching}
      </SearchStatus>
    </>
  )
}

function Marked({ text, query }: { text: string; query: string }) {
  return marked(text, query).map(({ piece, hit }, index) =>
    hit ? (
      <mark
        // biome-ignore lint/suspicious/noArrayIndexKey: pieces have no other name
        key={index}
        className="bg-transparent font-semibold text-foreground underline decoration-2 decoration-amber-500 underline-offset-2"
      >
        {piece}
      </mark>
    ) : (
      piece
    ),
  )
}

import type { Heading } from '@/lib/headings'

/** The headings of a page, beside it where there is room. */
export function OnThisPage({ headings }: { headings: Heading[] }) {
  return (
    <aside data-print="hide" className="hidden xl:block">
      {headings.length > 0 && (
        <nav
          aria-label="On this page"
          className="-mx-1 sticky top-14 max-h-[calc(100dvh-3.5rem)] overflow-y-auto px-1 py-12 text-sm"
        >
          <p className="font-medium">On this page</p>
          <ul className="mt-3 space-y-2">
            {headings.map((heading) => (
              <li key={heading.id} className={heading.depth > 2 ? 'pl-3' : undefined}>
                <a href={`#${heading.id}`} className="text-muted-foreground hover:text-foreground">
                  {heading.text}
                </a>
              </li>
            ))}
          </ul>
        </nav>
      )}
    </aside>
  )
}

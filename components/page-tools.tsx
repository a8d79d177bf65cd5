import { at } from '@/lib/address'
import { assistants } from '@/lib/elsewhere'
import { repositoryUrl } from '@/site.config.mjs'
import { CopyButton } from './copy-button'
import { ChevronIcon } from './icons'

const item = 'block rounded-md px-3 py-1.5 -outline-offset-2 hover:bg-muted hover:text-foreground'

/**
 * What every page offers about itself: a copy as Markdown, other places to take it to, and the way to change
 * it. The menu is the browser's own popover, which opens without script, closes on Escape and gives the focus
 * back.
 */
export function PageTools({ twin, source, className }: { twin: string; source: string; className?: string }) {
  return (
    <div
      data-print="hide"
      className={`-ml-2 flex flex-wrap items-center gap-x-2 text-muted-foreground text-sm ${className ?? ''}`}
    >
      <span className="flex items-center [@media(scripting:none)]:hidden">
        <CopyButton from={twin} label="Copy page as Markdown">
          Copy page
        </CopyButton>
        <button
          type="button"
          popoverTarget="page-menu"
          aria-label="More ways to take this page"
          title="More ways to take this page"
          className="grid size-8 place-items-center rounded-md [anchor-name:--page-menu] hover:bg-muted hover:text-foreground"
        >
          <ChevronIcon />
        </button>
      </span>
      <ul
        popover="auto"
        id="page-menu"
        className="w-52 rounded-xl border bg-panel p-1.5 text-muted-foreground text-sm shadow-lg [@media(scripting:none)]:static [@media(scripting:none)]:block supports-[position-area:bottom]:inset-auto supports-[position-area:bottom]:m-0 supports-[position-area:bottom]:mt-1 supports-[position-area:bottom]:[position-anchor:--page-menu] supports-[position-area:bottom]:[position-area:bottom_span-right] supports-[position-area:bottom]:[position-try-fallbacks:flip-inline,flip-block]"
      >
        <li>
          <a href={at(twin)} className={item}>
            Open as Markdown
          </a>
        </li>
        {assistants(twin).map(({ title, href }) => (
          <li key={title}>
            <a href={href} className={item}>
              {title}
            </a>
          </li>
        ))}
      </ul>
      {repositoryUrl && (
        <a
          href={`${repositoryUrl}/edit/main/${source}`}
          className="rounded-md px-2 py-1.5 hover:text-foreground"
        >
          Edit
        </a>
      )}
    </div>
  )
}

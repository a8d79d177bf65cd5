import { repositoryUrl } from '@/site.config.mjs'
import { CopyButton } from './copy-button'

/** What every page offers about itself: a copy as Markdown, its Markdown twin, and the way to change it. */
export function PageTools({ twin, source, className }: { twin: string; source: string; className?: string }) {
  const link = 'rounded-md px-2 py-1.5 text-muted-foreground hover:text-foreground'
  return (
    <div data-print="hide" className={`-ml-2 flex flex-wrap items-center gap-x-2 text-sm ${className ?? ''}`}>
      <CopyButton from={twin} label="Copy page as Markdown">
        Copy page
      </CopyButton>
      <a href={twin} className={link}>
        Markdown
      </a>
      {repositoryUrl && (
        <a href={`${repositoryUrl}/edit/main/${source}`} className={link}>
          Edit
        </a>
      )}
    </div>
  )
}

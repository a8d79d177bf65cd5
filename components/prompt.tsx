import { promptOf } from '@/lib/prompt'
import { CopyButton } from './copy-button'

/** The text for a coding assistant, to be copied as it stands. */
export function Prompt({ name }: { name: string }) {
  return (
    <div className="code overflow-hidden rounded-xl border bg-panel">
      <div className="flex items-center justify-between border-b py-1 pr-1.5 pl-4">
        <span className="truncate font-mono text-muted-foreground text-xs">For a coding assistant</span>
        <CopyButton>Copy prompt</CopyButton>
      </div>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: a block that scrolls must be reachable */}
      <pre tabIndex={0} className="max-h-96 whitespace-pre-wrap">
        <code>{promptOf(name)}</code>
      </pre>
    </div>
  )
}

import { at } from '@/lib/address'
import { componentFile, componentSource } from '@/lib/source'
import { Code } from './code-block'
import { CopyButton } from './copy-button'
import { SourceText } from './source-text'

const shownLines = 32

/** The whole file that people copy. Its first lines are in the page; the rest is fetched on demand. */
export function ComponentSource() {
  const source = componentSource()
  const lines = source.trimEnd().split('\n')
  return (
    <div className="code overflow-hidden rounded-xl border bg-panel">
      <div className="flex items-center justify-between border-b py-1 pr-1.5 pl-4">
        <span className="truncate font-mono text-muted-foreground text-xs">{componentFile}</span>
        <CopyButton from="/source/gravity-stack.tsx.txt">Copy the whole file</CopyButton>
      </div>
      <SourceText
        all={`Show all ${lines.length.toLocaleString('en')} lines`}
        plain={
          <a
            data-plain
            href={at('/source/gravity-stack.tsx.txt')}
            className="text-muted-foreground hover:text-foreground"
          >
            Plain text
          </a>
        }
      >
        <Code code={lines.slice(0, shownLines).join('\n')} />
      </SourceText>
    </div>
  )
}

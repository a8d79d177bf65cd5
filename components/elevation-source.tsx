import { elevationSource } from '@/lib/source'
import { Code } from './code-block'
import { CopyButton } from './copy-button'

/** The tokens of the ladder, to be pasted. */
export function ElevationSource() {
  return (
    <div className="code relative overflow-hidden rounded-xl border bg-panel max-sm:pt-7">
      <CopyButton className="absolute top-1 right-1.5 bg-panel" />
      <Code code={elevationSource()} lang="css" className="[&>pre]:max-h-96" />
    </div>
  )
}

import { exampleSource } from '@/lib/source'
import { Code } from './code-block'
import { ReplayIcon } from './icons'
import { PreviewTabs } from './preview-tabs'

/** An example of the registry, live, with its source behind a tab. */
export function ComponentPreview({ name }: { name: string }) {
  return (
    <PreviewTabs
      name={name}
      again={
        <>
          <ReplayIcon /> Drop again
        </>
      }
      code={<Code code={exampleSource(name)} className="absolute inset-0 [&>pre]:h-full" />}
    />
  )
}

import { exampleSource } from '@/lib/source'
import { Code } from './code-block'
import { demos } from './demos'
import { PreviewTabs } from './preview-tabs'

/** An example of the registry, live, with its source behind a tab. */
export function ComponentPreview({ name }: { name: string }) {
  const Demo = demos[name]
  if (!Demo) throw new Error(`components/demos.tsx knows no example ${name}`)
  return (
    <PreviewTabs
      name={name}
      code={<Code code={exampleSource(name)} className="absolute inset-0 [&>pre]:h-full" />}
    >
      <Demo />
    </PreviewTabs>
  )
}

import { classes } from '@/lib/classes'
import { type CodeLanguage, highlight } from '@/lib/highlight'
import { CopyButton } from './copy-button'

/** Highlighted at build time; stands inside a `.code` box. */
export async function Code({
  code,
  lang,
  className,
}: {
  code: string
  lang?: CodeLanguage
  className?: string
}) {
  const html = await highlight(code, lang)
  // biome-ignore lint/security/noDangerouslySetInnerHtml: our own code, turned into HTML at build time
  return <div className={className} dangerouslySetInnerHTML={{ __html: html }} />
}

export function CodeBlock({
  title,
  className,
  ...code
}: {
  code: string
  lang?: CodeLanguage
  title?: string
  className?: string
}) {
  return (
    <div className={classes('code relative overflow-hidden rounded-xl border bg-panel', className)}>
      {title && (
        <div className="border-b px-4 py-2.5 pr-12 font-mono text-muted-foreground text-xs">{title}</div>
      )}
      <CopyButton className="absolute top-1 right-1.5 bg-panel" />
      <Code {...code} />
    </div>
  )
}

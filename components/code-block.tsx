import { highlight } from '@/lib/highlight'

/** Highlighted at build time; stands inside a `.code` box. */
export async function Code({
  code,
  lang,
  className,
}: {
  code: string
  lang?: 'tsx' | 'css'
  className?: string
}) {
  const html = await highlight(code, lang)
  // biome-ignore lint/security/noDangerouslySetInnerHtml: our own code, turned into HTML at build time
  return <div className={className} dangerouslySetInnerHTML={{ __html: html }} />
}

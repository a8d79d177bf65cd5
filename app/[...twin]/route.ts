import { docs, findDoc } from '@/lib/docs'
import { docMarkdown } from '@/lib/markdown'

// Every page of the docs as Markdown, at its own address with .md behind it.
export const dynamic = 'force-static'
export const dynamicParams = false
export const generateStaticParams = () => docs.map(({ slug }) => ({ twin: ['docs', `${slug}.md`] }))

export async function GET(_request: Request, { params }: RouteContext<'/[...twin]'>) {
  const { twin } = await params
  const { doc } = findDoc(twin[1].replace(/\.md$/, ''))
  return new Response(docMarkdown(doc), { headers: { 'content-type': 'text/markdown; charset=utf-8' } })
}

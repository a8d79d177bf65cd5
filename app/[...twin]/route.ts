import { twins } from '@/lib/markdown'

// Every page as Markdown, at its own address with .md behind it.
export const dynamic = 'force-static'
export const dynamicParams = false

/** While developing, next.config.mjs sends /docs/….md through here: /docs/[slug] would take it for a page. */
const developed = (path: string) =>
  process.env.NODE_ENV === 'development' ? [path, `twins/${path}`] : [path]

export const generateStaticParams = () =>
  Object.keys(twins)
    .flatMap(developed)
    .map((path) => ({ twin: path.split('/') }))

export async function GET(_request: Request, { params }: RouteContext<'/[...twin]'>) {
  const path = (await params).twin.join('/').replace(/^twins\//, '')
  return new Response(await twins[path](), { headers: { 'content-type': 'text/markdown; charset=utf-8' } })
}

import { blocks } from '@/lib/blocks'
import { highlight } from '@/lib/highlight'
import { agentsSource, blockSource, componentFile, componentSource } from '@/lib/source'

// The ending is .txt for all: any static host serves that as text and no browser runs it.
const files: Record<string, () => string | Promise<string>> = {
  'gravity-stack.tsx.txt': componentSource,
  'agents.md.txt': agentsSource,
  'gravity-stack.html.txt': async () =>
    (await highlight(componentSource())).replace(
      '<pre ',
      `<pre role="region" aria-label="${componentFile}" `,
    ),
  ...Object.fromEntries(
    blocks.flatMap(({ name }) => [
      [`${name}.tsx.txt`, () => blockSource(name)],
      [`${name}.html.txt`, () => highlight(blockSource(name))],
    ]),
  ),
}

export const dynamic = 'force-static'
export const dynamicParams = false
export const generateStaticParams = () => Object.keys(files).map((file) => ({ file }))

export async function GET(_request: Request, { params }: RouteContext<'/source/[file]'>) {
  const { file } = await params
  return new Response(await files[file](), { headers: { 'content-type': 'text/plain; charset=utf-8' } })
}

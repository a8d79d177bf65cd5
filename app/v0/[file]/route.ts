import { v0Item, v0Names } from '@/lib/v0'

export const dynamic = 'force-static'
export const dynamicParams = false
export const generateStaticParams = () => v0Names.map((name) => ({ file: `${name}.json` }))

export async function GET(_request: Request, { params }: RouteContext<'/v0/[file]'>) {
  const { file } = await params
  return Response.json(v0Item(file.replace('.json', '')))
}

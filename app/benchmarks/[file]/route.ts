import { existsSync, readFileSync } from 'node:fs'

// The raw data of the page, as the benchmark wrote it.
const types: Record<string, string> = {
  'results.json': 'application/json',
  'browser.json': 'application/json',
  'errors.csv': 'text/csv; charset=utf-8',
  'costs.csv': 'text/csv; charset=utf-8',
}

export const dynamic = 'force-static'
export const dynamicParams = false
const pathOf = (file: string) => `bench/results/${file}`
export const generateStaticParams = () =>
  Object.keys(types)
    .filter((file) => existsSync(pathOf(file)))
    .map((file) => ({ file }))

export async function GET(_request: Request, { params }: RouteContext<'/benchmarks/[file]'>) {
  const { file } = await params
  return new Response(readFileSync(pathOf(file)), { headers: { 'content-type': types[file] } })
}

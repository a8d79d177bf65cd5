import { readFileSync } from 'node:fs'
import { allFigures } from '@/lib/evidence/results'

const figures = 'figures.json'

// The raw data of the page, as the benchmark wrote it, and the figures beside its plots.
const types: Record<string, string> = {
  'results.json': 'application/json',
  'browser.json': 'application/json',
  [figures]: 'application/json',
  'errors.csv': 'text/csv; charset=utf-8',
  'costs.csv': 'text/csv; charset=utf-8',
}

export const dynamic = 'force-static'
export const dynamicParams = false
const pathOf = (file: string) => `bench/results/${file}`
export const generateStaticParams = () => Object.keys(types).map((file) => ({ file }))

export async function GET(_request: Request, { params }: RouteContext<'/benchmarks/[file]'>) {
  const { file } = await params
  const body = file === figures ? JSON.stringify(allFigures()) : readFileSync(pathOf(file))
  return new Response(body, { headers: { 'content-type': types[file] } })
}

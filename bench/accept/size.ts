// What the component weighs and how much of it there is to read.
import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { componentBytes } from '../publish/bytes'
import type { Row } from './row'
import type { Solver } from './solver'

/** Every file of constants in the registry. */
const constantFiles = (dir: string) =>
  readdirSync(join(dir, 'registry/gravity-stack'), { recursive: true, encoding: 'utf8' })
    .filter((path) => /(^|[\\/])constants\.ts$/.test(path))
    .map((path) => join(dir, 'registry/gravity-stack', path))

export async function sizeRows({ dir }: Solver): Promise<Row[]> {
  const lines = readFileSync(join(dir, 'components/ui/gravity-stack.tsx'), 'utf8')
    .trimEnd()
    .split('\n').length
  const numbers = constantFiles(dir)
    .flatMap((file) => readFileSync(file, 'utf8').split('\n'))
    .filter((line) => /^export const [A-Z]/.test(line)).length
  const row = { group: 'size', what: 'gravity-stack.tsx', runs: 1 }
  return [
    {
      ...row,
      figure: 'minified and gzipped, with Motion’s part',
      value: await componentBytes(dir),
      unit: 'bytes',
      bound: 17_500,
    },
    { ...row, figure: 'lines', value: lines, unit: 'lines', bound: 3600 },
    { ...row, figure: 'numbers in the solver’s constants', value: numbers, unit: 'numbers', bound: 50 },
  ]
}

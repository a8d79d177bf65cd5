// The solver that is measured: that of the work tree, or that of another commit, taken out of git.
import { execFileSync } from 'node:child_process'
import { mkdirSync, rmSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { root } from '../build/root'
import { script } from '../build/script'

const git = (...args: string[]) =>
  execFileSync('git', args, { cwd: root, encoding: 'utf8', maxBuffer: 2 ** 28 })

/** A folder of this process alone, inside the project, so that packages are found from it. */
const folder = (name: string) => {
  const dir = join(root, 'node_modules/.cache/gravity-stack-bench', `${name}-${process.pid}`)
  mkdirSync(dir, { recursive: true })
  process.on('exit', () => rmSync(dir, { recursive: true, force: true }))
  return dir
}

export type Solver = { commit: string; dir: string }

/** The work tree as it is. */
export const here = (): Solver => ({ commit: 'work tree', dir: root })

/** Registry and assembled file of another commit. */
export function solverAt(revision: string): Solver {
  const commit = git('rev-parse', '--short', `${revision}^{commit}`).trim()
  const dir = folder(`solver-${commit}`)
  const archive = join(dir, 'solver.tar')
  git('archive', '--format=tar', `--output=${archive}`, commit, 'registry', 'components/ui')
  execFileSync('tar', ['-xf', archive, '-C', dir])
  return { commit, dir }
}

/** The world alone as one script, as Vite builds an app: `format` iife leaves it in the global `world`. */
export async function worldScript({ commit, dir }: Solver, format: 'iife' | 'esm') {
  const code = await script(`export { createWorld } from './registry/gravity-stack/world'`, dir, format, {
    name: 'world',
  })
  const file = join(folder(`world-${commit.replace(' ', '-')}`), `world.${format === 'esm' ? 'mjs' : 'js'}`)
  writeFileSync(file, code)
  return file
}

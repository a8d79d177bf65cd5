import 'server-only'
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { addressed } from '@/site.config.mjs'

/** The text of a file of this repository, read at build time. */
function read(...path: string[]): string {
  return readFileSync(join(process.cwd(), ...path), 'utf8')
}

/** The one file that people copy, which names the address of this site. */
export const componentFile = 'components/ui/gravity-stack.tsx'
export const componentSource = () => addressed(read(componentFile))

export const exampleSource = (name: string) => read('registry', 'examples', `${name}.tsx`)

export const blockSource = (name: string) => read('registry', 'blocks', `${name}.tsx`)

/** The tokens of the registry's item `elevation`. */
export const elevationSource = () => read('app', 'elevation.css')

/** What the registry's item `agents` tells a coding assistant. */
export const agentsSource = () => addressed(read('registry', 'agents.md'))

/** CHANGELOG.md below its title. */
export const changelog = () => read('CHANGELOG.md').replace(/^# .+\n/, '')

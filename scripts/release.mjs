// Releases the version that package.json names: its registry files are kept in public/r/VERSION, where they
// stay as they are. From then on a change to any of them needs a new version; scripts/registry.mjs --check
// says so.
import { cp, mkdir, readFile, writeFile } from 'node:fs/promises'
import { join } from 'node:path'
import { version } from '../site.config.mjs'
import { digest, folderOf, itemFiles, releases, releasesFile } from './releases.mjs'
import { must, root } from './run.mjs'

function refuse(why) {
  console.error(why)
  process.exit(1)
}

if (releases[version])
  refuse(`${version} was released on ${releases[version].date}. Raise the version in package.json.`)
if (!(await readFile(join(root, 'CHANGELOG.md'), 'utf8')).includes(`\n## ${version}\n`))
  refuse(`CHANGELOG.md has no heading ## ${version} yet.`)
await must('node', ['scripts/assemble.mjs', '--check'])
await must('node', ['scripts/registry.mjs', '--check'])

const folder = folderOf(version)
await mkdir(folder)
for (const name of itemFiles(folderOf())) await cp(join(folderOf(), name), join(folder, name))
const date = new Date().toISOString().slice(0, 10)
const all = { [version]: { date, sha256: digest(folder) }, ...releases }
await writeFile(releasesFile, `${JSON.stringify(all, null, 2)}\n`)
console.log(`${version} is released. Commit it, and tag the commit: git tag v${version}`)

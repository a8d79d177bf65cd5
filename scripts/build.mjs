// Builds the whole site, registry included: a folder of static files that any host can serve. What is
// committed stays as it is, whatever address the build is for.
import { readFile, writeFile } from 'node:fs/promises'
import { join } from 'node:path'
import { basePath, out } from '../site.config.mjs'
import { lateScripts } from './late-scripts.mjs'
import { buildRegistry } from './registry.mjs'
import { must, root } from './run.mjs'

await must('node', ['scripts/assemble.mjs'])
await must('contentlayer2', ['build'])
await must('next', ['build'])
const folder = join(root, out)
await buildRegistry(folder)
lateScripts(folder)
// Hosts read this file by paths from their root.
const headers = await readFile(join(root, 'public/_headers'), 'utf8')
await writeFile(join(folder, '_headers'), headers.replace(/^\//gm, `${basePath}/`))

// Builds the whole site, registry included, into out/: a folder of static files that any host can serve.
import { join } from 'node:path'
import { lateScripts } from './late-scripts.mjs'
import { buildRegistry } from './registry.mjs'
import { must, root } from './run.mjs'

await must('node', ['scripts/assemble.mjs'])
await must('contentlayer2', ['build'])
await buildRegistry()
await must('next', ['build'])
lateScripts(join(root, 'out'))

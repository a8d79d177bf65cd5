// Builds the site and its registry, serves both, and says where.
import { ready } from './ready.mjs'
import { must, run } from './run.mjs'

await ready()
await must('node', ['scripts/build.mjs'])
process.exitCode = await run('node', ['scripts/serve.mjs'])

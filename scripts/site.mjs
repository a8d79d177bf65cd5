// Builds the site and its registry, serves both, and says where.
import { ready } from './ready.mjs'
import { must } from './run.mjs'

await ready()
await must('node', ['scripts/build.mjs'])
await must('node', ['scripts/serve.mjs'])

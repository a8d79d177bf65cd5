// Builds the site and its registry, serves both, and says where.
import { ready } from './ready.mjs'
import { must } from './run.mjs'

await ready()
await must('node', ['scripts/build.mjs'])
// Its packages are there by now. In this process, so that nothing goes on serving when it is ended.
const { serveSite } = await import('./serve.mjs')
await serveSite()

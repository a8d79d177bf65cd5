// For working on it: a change to the solver, a page or the site shows in the browser within a second.
import { ready } from './ready.mjs'
import { must, start } from './run.mjs'

await ready()
await must('node', ['scripts/assemble.mjs'])
await must('contentlayer2', ['build'])

const all = [
  start('node', ['scripts/assemble.mjs', '--watch']),
  start('contentlayer2', ['dev']),
  start('next', ['dev', ...process.argv.slice(2)]),
]
const stop = () => {
  for (const child of all) child.kill()
}
for (const child of all)
  child.on('exit', (code) => {
    process.exitCode ||= code ?? 0
    stop()
  })
process.on('SIGINT', stop).on('SIGTERM', stop)

// Runs every check and test there is, on a machine that has nothing but Node, and goes on after a failure.
// The last line counts them: each test of Vitest and Playwright is one, and each check is one.
import { mkdtemp, readFile, rm } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { basename, join } from 'node:path'
import { ready } from './ready.mjs'
import { root, run } from './run.mjs'

// What is committed names the usual address, whatever a shell is set to.
delete process.env.SITE_URL

const reports = await mkdtemp(join(tmpdir(), 'gravity-stack-'))
const totals = { passed: 0, failed: 0 }
const failures = []
let missing = []

/** Runs one step, which gives how many passed and failed, and prints what it was and how long it took. */
async function step(name, work) {
  console.log(`\n▸ ${name}`)
  const begin = performance.now()
  let result
  try {
    result = await work()
  } catch (error) {
    console.error(error)
    result = { passed: 0, failed: 1 }
  }
  totals.passed += result.passed
  totals.failed += result.failed
  if (result.failed > 0) failures.push(`${name}: ${result.failed} failed`)
  const seconds = ((performance.now() - begin) / 1000).toFixed(1)
  console.log(`${result.failed > 0 ? '✗' : '✓'} ${name} (${seconds} s)`)
}

const verdict = (code) => ({ passed: code === 0 ? 1 : 0, failed: code === 0 ? 0 : 1 })

/** A check made of commands: one pass when all of them end well, one failure at the first that doesn't. */
const check = (name, ...commands) =>
  step(name, async () => {
    for (const [command, ...args] of commands) {
      const code = await run(command, args)
      if (code !== 0) return verdict(code)
    }
    return verdict(0)
  })

/** A test runner with a JSON report. A run that fails without a failed test, or runs none, is one failure. */
const tests = (name, command, args, report, count, env) =>
  step(name, async () => {
    const code = await run(command, args, { env })
    const text = await readFile(report, 'utf8').catch(() => undefined)
    const { passed, failed } = text ? count(JSON.parse(text)) : { passed: 0, failed: 0 }
    const endedBadly = failed === 0 && (code !== 0 || passed === 0)
    return { passed, failed: endedBadly ? 1 : failed }
  })

await step('Dependencies are installed', async () => {
  await ready()
  return verdict(0)
})
await step('A browser is here', async () => {
  const { bringBrowser, bringEngines } = await import('./browser.mjs')
  await bringBrowser()
  missing = await bringEngines()
  return verdict(0)
})
await check('Code is formatted and clean', ['biome', 'check'])
await check('Words are spelt right', ['cspell', '--no-progress', '--no-summary'])
await check('The one file is what its modules assemble to', ['node', 'scripts/assemble.mjs', '--check'])
await check('The registry is valid', ['shadcn', 'registry', 'validate'])
await check('The served registry is what a fresh build gives', ['node', 'scripts/registry.mjs', '--check'])
await check('The one file holds in the strictest projects', ['tsc', '-p', 'tsconfig.strictest.json'])
await check('Types hold', ['contentlayer2', 'build'], ['next', 'typegen'], ['tsc', '--noEmit'])

const unitReport = join(reports, 'vitest.json')
await tests(
  'Unit tests',
  'vitest',
  ['run', '--reporter=default', '--reporter=json', `--outputFile.json=${unitReport}`],
  unitReport,
  ({ numPassedTests, numTotalTests }) => ({ passed: numPassedTests, failed: numTotalTests - numPassedTests }),
  { CI: '1' },
)

// A site of the tests' own, in a folder and on a port that no other uses: one that is served meanwhile stays
// as it is. The port is held from before the build, which writes it into the pages.
const folder = join(root, 'out-test')
let server
await step('The site builds', async () => {
  const { serve } = await import('./serve.mjs')
  server = await serve(folder, 0)
  process.env.SITE_OUT = basename(folder)
  process.env.SITE_URL = `http://localhost:${server.address().port}`
  return verdict(await run('node', ['scripts/build.mjs']))
})

const browserReport = join(reports, 'playwright.json')
await tests(
  'Browser and install tests',
  'playwright',
  ['test', '--reporter=list,json'],
  browserReport,
  ({ stats }) => ({ passed: stats.expected, failed: stats.unexpected + stats.flaky + stats.skipped }),
  { PLAYWRIGHT_JSON_OUTPUT_FILE: browserReport, CI: '1' },
)

server?.close()
server?.closeAllConnections()
for (const path of [reports, folder]) await rm(path, { recursive: true, force: true })
if (missing.length > 0)
  console.log(`\nNot run: what is tested in ${missing.join(' and ')}, not to be had here`)
console.log(failures.length > 0 ? `\nFailed:\n  ${failures.join('\n  ')}\n` : '')
console.log(`${totals.passed} passed, ${totals.failed} failed`)
process.exitCode = totals.failed > 0 || totals.passed === 0 ? 1 : 0

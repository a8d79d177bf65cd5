// Finds a Chromium for the tests: one that is here, else Playwright's own, else the system package manager's.
import { execFileSync } from 'node:child_process'
import { accessSync, constants } from 'node:fs'
import { createRequire } from 'node:module'
import { delimiter, join } from 'node:path'
import { isMain, run } from './run.mjs'

const names = ['chromium', 'chromium-browser', 'google-chrome-stable', 'google-chrome']
const macPaths = ['/Applications/Google Chrome.app/Contents/MacOS/Google Chrome']

/** Its version when it starts, so that a browser whose libraries are missing isn't taken. */
function versionOf(path) {
  try {
    accessSync(path, constants.X_OK)
    return execFileSync(path, ['--version'], { encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] }).trim()
  } catch {
    return undefined
  }
}

const playwrightsOwn = () => createRequire(import.meta.url)('playwright-core').chromium.executablePath()

/** The path and version of a browser that is already here, or undefined. CHROME_PATH has the first word. */
export function findBrowser() {
  const onPath = (process.env.PATH ?? '')
    .split(delimiter)
    .flatMap((dir) => names.map((name) => join(dir, name)))
  const found = [process.env.CHROME_PATH, ...onPath, ...macPaths, playwrightsOwn()]
  for (const path of found) {
    const version = path && versionOf(path)
    if (version) return { path, version }
  }
}

async function download() {
  // Where there is no way to the internet it says so with a page of stack traces: our own last line is enough.
  const code = await run('playwright', ['install', 'chromium'], { stdio: ['ignore', 'inherit', 'ignore'] })
  if (code === 0 && !findBrowser()) await run('playwright', ['install-deps', 'chromium'])
}

async function aptGet() {
  const env = { DEBIAN_FRONTEND: 'noninteractive' }
  const packages = ['chromium', 'fonts-liberation']
  await run('apt-get', ['update', '-q'], { env })
  await run('apt-get', ['install', '-y', '-q', '--no-install-recommends', ...packages], { env })
}

const ways = [
  { name: 'already here', get: () => {} },
  { name: "Playwright's download", get: download },
  { name: 'installed by apt-get', get: aptGet },
]

/** Brings a browser, says which, and leaves its path in CHROME_PATH for the tests. */
export async function bringBrowser() {
  for (const { name, get } of ways) {
    await get()
    const browser = findBrowser()
    if (browser) {
      console.log(`Browser: ${browser.version} at ${browser.path} (${name})`)
      process.env.CHROME_PATH = browser.path
      return
    }
  }
  throw new Error('No Chromium could be found, downloaded or installed; set CHROME_PATH to one')
}

if (isMain(import.meta.url)) await bringBrowser()

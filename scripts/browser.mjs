// Finds a Chromium for the tests: one that is here, else Playwright's own, else the system package manager's.
// And the engines of the other browsers, where they are here or can be had.
import { execFileSync } from 'node:child_process'
import { accessSync, constants, existsSync } from 'node:fs'
import { createRequire } from 'node:module'
import { delimiter, join } from 'node:path'
import { isMain, run } from './run.mjs'

// The headless shell is Chromium without windows of its own, which cost a page in them as much again.
const shell = 'chromium-headless-shell'
const names = [shell, 'chromium', 'chromium-browser', 'google-chrome-stable', 'google-chrome']
const macPaths = ['/Applications/Google Chrome.app/Contents/MacOS/Google Chrome']

/** What it says when it starts, so that a browser whose libraries are missing isn't taken. */
function versionOf(path, ...args) {
  try {
    accessSync(path, constants.X_OK)
    return execFileSync(path, args, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] }).trim()
  } catch {
    return undefined
  }
}

const playwrightsOwn = () => createRequire(import.meta.url)('@playwright/test').chromium.executablePath()

const onPath = (names) =>
  (process.env.PATH ?? '').split(delimiter).flatMap((dir) => names.map((name) => join(dir, name)))

/** The path and version of a browser that is already here, or undefined. CHROME_PATH has the first word. */
export function findBrowser() {
  const found = [process.env.CHROME_PATH, ...onPath(names), ...macPaths, playwrightsOwn()]
  for (const path of found) {
    const version = path && versionOf(path, '--version')
    if (version) return { path, version }
  }
}

async function download() {
  // Without a network it prints a page of stack traces. Our own last line is enough.
  const code = await run('playwright', ['install', 'chromium'], { stdio: ['ignore', 'inherit', 'ignore'] })
  if (code === 0 && !findBrowser()) await run('playwright', ['install-deps', 'chromium'])
}

let updated

async function aptGet(...packages) {
  const env = { DEBIAN_FRONTEND: 'noninteractive' }
  updated ??= run('apt-get', ['update', '-q'], { env })
  await updated
  await run('apt-get', ['install', '-y', '-q', '--no-install-recommends', ...packages], { env })
}

const ways = [
  { name: 'already here', get: () => {} },
  { name: "Playwright's download", get: download },
  { name: 'installed by apt-get', get: () => aptGet(shell, 'fonts-liberation') },
  // Not every system packs the shell.
  { name: 'installed by apt-get', get: () => aptGet('chromium', 'fonts-liberation') },
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

const engines = {
  Firefox: {
    names: ['firefox-esr', 'firefox'],
    macPath: '/Applications/Firefox.app/Contents/MacOS/firefox',
    version: ['--version'],
    packages: ['firefox-esr'],
  },
  // WebKit's engine as a bare shell: it tells no version.
  JavaScriptCore: {
    names: ['jsc'],
    macPath: '/System/Library/Frameworks/JavaScriptCore.framework/Versions/Current/Helpers/jsc',
    version: ['-e', "print('JavaScriptCore')"],
    packages: ['libjavascriptcoregtk-4.0-bin'],
  },
  // The whole of it, in WebKitGTK's small browser, which this starts, and a screen for it.
  WebKit: {
    names: ['WebKitWebDriver'],
    needs: ['Xvfb'],
    version: ['--help'],
    packages: ['webkit2gtk-driver', 'xvfb'],
  },
}

/** The paths of the engines beside Chromium's: undefined for one that isn't here. */
export const findEngines = () =>
  Object.entries(engines).map(([name, { names, needs, macPath, version }]) => ({
    name,
    path: [...onPath(names), macPath].find(
      (path) => versionOf(path, ...version) && (!needs || onPath(needs).some(existsSync)),
    ),
  }))

/** Brings the engines that are missing, 160 MB at most, and gives the names of those that can't be had. */
export async function bringEngines() {
  for (const { name, path } of findEngines()) if (!path) await aptGet(...engines[name].packages)
  const found = findEngines()
  for (const { name, path } of found) console.log(`${name}: ${path ?? 'not to be had'}`)
  return found.filter(({ path }) => !path).map(({ name }) => name)
}

if (isMain(import.meta.url)) {
  await bringBrowser()
  await bringEngines()
}

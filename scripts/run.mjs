import { spawn } from 'node:child_process'
import { realpathSync } from 'node:fs'
import { dirname, join } from 'node:path'
import { fileURLToPath } from 'node:url'

export const root = dirname(dirname(fileURLToPath(import.meta.url)))

/** Starts a command in the project's root; tools from node_modules go by their bare name. */
export function start(command, args = [], options = {}) {
  return spawn(command, args, {
    cwd: root,
    stdio: 'inherit',
    ...options,
    env: {
      ...process.env,
      PATH: `${join(root, 'node_modules/.bin')}:${process.env.PATH}`,
      // contentlayer looks here before it asks for the working directory
      PWD: root,
      NEXT_TELEMETRY_DISABLED: '1',
      ...options.env,
    },
  })
}

/** Runs a command to its end and gives its exit code. */
export function run(command, args, options) {
  return new Promise((resolve) => {
    start(command, args, options)
      .on('error', (error) => {
        console.error(error.message)
        resolve(127)
      })
      .on('close', (code) => resolve(code ?? 1))
  })
}

/** Runs a command and throws when it fails: for chains in which each link needs the one before it. */
export async function must(command, args, options) {
  const code = await run(command, args, options)
  if (code !== 0) throw new Error(`${[command, ...(args ?? [])].join(' ')} ended with code ${code}`)
}

/** Was this module started from the command line, or imported by another? */
export const isMain = (url) => realpathSync(process.argv[1]) === fileURLToPath(url)

// Installs the dependencies when they are missing or differ from package-lock.json. Needs nothing but Node.
import { readFile } from 'node:fs/promises'
import { join } from 'node:path'
import { isMain, must, root } from './run.mjs'

const lockAt = async (path) => {
  try {
    return JSON.parse(await readFile(join(root, path), 'utf8')).packages
  } catch {
    return undefined
  }
}

/**
 * The first package whose installed version isn't the locked one. Packages of other platforms may be absent.
 */
async function firstDifference() {
  const locked = await lockAt('package-lock.json')
  const installed = await lockAt('node_modules/.package-lock.json')
  if (!installed) return 'node_modules'
  return Object.keys(locked).find((path) => {
    if (path === '') return false
    if (!installed[path]) return !locked[path].optional
    return installed[path].version !== locked[path].version
  })
}

export async function ready() {
  const difference = await firstDifference()
  if (!difference) return
  console.log(`Installing dependencies: ${difference} is missing or out of date`)
  await must('npm', ['ci', '--include=dev', '--no-audit', '--no-fund'])
}

if (isMain(import.meta.url)) await ready()

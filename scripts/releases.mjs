import { createHash } from 'node:crypto'
import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { root } from './run.mjs'

export const releasesFile = join(root, 'registry/releases.json')

/**
 * The versions that were released, each with its day and the SHA-256 of its files. Those stand in
 * public/r/VERSION, as they were in public/r on that day, and never change again: people pin their project to
 * them.
 */
export const releases = JSON.parse(readFileSync(releasesFile, 'utf8'))

/** The registry's files of a version, or of none, what is worked on. */
export const folderOf = (version = '') => join(root, 'public/r', version)

/** The names of a registry's files, without the folders of versions beside them. */
export const itemFiles = (folder) =>
  readdirSync(folder)
    .filter((name) => name.endsWith('.json'))
    .sort()

/** The SHA-256 of all files of a registry, by name and byte. */
export function digest(folder) {
  const hash = createHash('sha256')
  for (const name of itemFiles(folder)) hash.update(`${name}\0`).update(readFileSync(join(folder, name)))
  return hash.digest('hex')
}

import { dirname } from 'node:path'
import { fileURLToPath } from 'node:url'

/** The project's folder. Not a URL of a folder, which the site's bundler would look for as a file. */
export const root = dirname(dirname(dirname(fileURLToPath(import.meta.url))))

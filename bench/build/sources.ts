import { createHash } from 'node:crypto'
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { build } from 'esbuild'
import { root } from './root'

/**
 * A digest of every file of the project that these modules need, as the bundler finds them: a figure is kept
 * for as long as it stays the same. Packages are told by their versions. What is imported late is another
 * module's: name it if it counts.
 */
export async function sourceDigest(modules: string[]) {
  const hash = createHash('sha1')
  for (const file of await sourcesOf(modules)) hash.update(file).update(readFileSync(join(root, file)))
  return hash.digest('hex').slice(0, 12)
}

/** The files of the project that these modules need, themselves included. */
export async function sourcesOf(modules: string[]) {
  const { metafile } = await build({
    absWorkingDir: root,
    stdin: { contents: modules.map((file) => `import './${file}'`).join('\n'), resolveDir: root },
    bundle: true,
    write: false,
    metafile: true,
    format: 'esm',
    platform: 'node',
    packages: 'external',
    plugins: [
      {
        name: 'not-what-is-imported-late',
        setup: ({ onResolve }) =>
          onResolve({ filter: /.*/ }, ({ kind, path }) =>
            kind === 'dynamic-import' || path.includes('node_modules') ? { path, external: true } : null,
          ),
      },
    ],
  })
  return Object.keys(metafile.inputs)
    .filter((file) => file !== '<stdin>')
    .sort()
}

import { rmSync } from 'node:fs'
import { dirname, join, resolve } from 'node:path'
import { rolldown } from 'rolldown'
import { root } from './root'

/**
 * Bundles a worker of the benchmark as Vite builds an app: it answers calls of one function of a module in
 * `bench/`. `world` is a file that stands in for the solver's `world.ts`. Not with esbuild, which turns the
 * constants of a bundle into variables: the compiler then looks every one of them up, and a solver that names
 * its offsets is half as slow again. What is imported late stays a file of its own, or every process would
 * load every engine.
 */
export async function bundleWorker(module: string, name: string, world?: string) {
  const own = join(root, 'registry/gravity-stack/world')
  const entry = join(root, 'bench/worker-entry.ts')
  const dir = join(root, 'node_modules/.cache/gravity-stack-bench', `${name}-${process.pid}`)
  const built = await rolldown({
    input: { [name]: entry },
    platform: 'node',
    external: /^[^./]/,
    plugins: [
      {
        name: 'entry',
        resolveId: (id) => (id === entry ? id : null),
        load: (id) =>
          id === entry
            ? `import { ${name} } from './${module}'\nimport { serve } from './worker/serve'\nserve(${name})`
            : null,
      },
      {
        name: 'another-world',
        resolveId: (id, importer) =>
          world && importer && resolve(dirname(importer), id) === own ? world : null,
      },
      {
        // Files inside node_modules stay outside the bundle: WebAssembly is loaded from beside them.
        name: 'keep-packages-outside',
        resolveId(id, importer) {
          if (!importer || !id.includes('node_modules')) return null
          return { id: resolve(dirname(importer), id), external: 'absolute' }
        },
      },
    ],
    logLevel: 'warn',
  })
  await built.write({
    dir,
    format: 'esm',
    entryFileNames: '[name].mjs',
    chunkFileNames: '[name].mjs',
    minify: { compress: true },
  })
  process.on('exit', () => rmSync(dir, { recursive: true, force: true }))
  return join(dir, `${name}.mjs`)
}

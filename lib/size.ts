import 'server-only'
import { gzipSync } from 'node:zlib'
import { buildSync } from 'esbuild'
import { componentFile } from './source'

/** kB, the component minified and compressed, without React, Motion and `cn`. Measured when the site is built. */
export function componentSize(): string {
  const { outputFiles } = buildSync({
    entryPoints: [componentFile],
    bundle: true,
    minify: true,
    format: 'esm',
    write: false,
    external: ['react', 'react/jsx-runtime', 'motion', 'motion/*', 'cn'],
    jsx: 'automatic',
  })
  return (gzipSync(outputFiles[0].contents).length / 1000).toFixed(1)
}

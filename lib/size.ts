import 'server-only'
import { gzipSync } from 'node:zlib'
import { rolldown } from 'rolldown'
import { componentFile } from './source'

/** kB, the component as Vite builds it, minified and compressed, with Motion's part, without React and `cn`. Measured when the site is built. */
export async function componentSize(): Promise<string> {
  const built = await rolldown({
    input: componentFile,
    external: /^(react|cn)(\/|$)/,
    transform: { define: { 'process.env.NODE_ENV': '"production"' } },
    logLevel: 'silent',
  })
  const { output } = await built.generate({ format: 'esm', minify: true })
  return (gzipSync(output[0].code, { level: 9 }).length / 1000).toFixed(1)
}

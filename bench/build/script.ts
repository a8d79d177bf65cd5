import { join } from 'node:path'
import { type InputOptions, rolldown } from 'rolldown'

/**
 * One script of a module in `folder` that holds `contents`, as Vite builds an app. Not with esbuild, which
 * turns the constants of a bundle into variables: the compiler then looks every one of them up, and longer
 * code takes longer to get warm. `name` is the global that an iife leaves its exports in.
 */
export async function script(
  contents: string,
  folder: string,
  format: 'esm' | 'cjs' | 'iife',
  { name, ...more }: InputOptions & { name?: string } = {},
) {
  const entry = join(folder, 'entry.tsx')
  const built = await rolldown({
    input: entry,
    logLevel: 'silent',
    transform: { define: { 'process.env.NODE_ENV': '"production"' } },
    plugins: [
      {
        name: 'entry',
        resolveId: (id) => (id === entry ? id : null),
        load: (id) => (id === entry ? contents : null),
      },
    ],
    ...more,
  })
  const { output } = await built.generate({ format, minify: true, codeSplitting: false, name })
  return output[0].code
}

import { writeFile } from 'node:fs/promises'
import { build as buildTables } from 'cn/build'
import { PHASE_DEVELOPMENT_SERVER, PHASE_PRODUCTION_BUILD } from 'next/constants.js'

/** `cn` with tables for the classes that this site's stages have: those for all of Tailwind are 3 kB more. */
async function fittedCn() {
  await buildTables({
    content: ['components/{hero,lost-words,ui/gravity-stack}.tsx', 'registry/examples/*.tsx'],
    css: 'app/globals.css',
    out: '.contentlayer/cn-tables.mjs',
  })
  await writeFile(
    '.contentlayer/cn.mjs',
    `import { createCn } from 'cn/engine'
import tables from './cn-tables.mjs'
export const cn = createCn(tables)
`,
  )
  return './.contentlayer/cn.mjs'
}

/** @returns {Promise<import('next').NextConfig>} */
export default async (phase) => ({
  ...(phase === PHASE_DEVELOPMENT_SERVER
    ? // The twins of the docs; exported, they are files. See app/[...twin].
      {
        rewrites: async () => ({
          beforeFiles: [{ source: '/docs/:slug.md', destination: '/twins/docs/:slug.md' }],
        }),
      }
    : { output: 'export' }),
  reactStrictMode: true,
  serverExternalPackages: ['esbuild', 'react-docgen', 'shiki'],
  turbopack: {
    // This folder is the root, also when a folder above holds a lock file.
    root: import.meta.dirname,
    resolveAlias: phase === PHASE_PRODUCTION_BUILD ? { cn: await fittedCn() } : {},
  },
})

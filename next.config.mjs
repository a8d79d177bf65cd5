import { writeFile } from 'node:fs/promises'
import { build as buildTables } from 'cn/build'
import { PHASE_DEVELOPMENT_SERVER, PHASE_PRODUCTION_BUILD } from 'next/constants.js'
import { basePath } from './site.config.mjs'

/** Lighter replacements for parts of the pages' script. Without them the component page weighs 9 kB more. */
async function lighter() {
  // `cn` with tables for the groups of classes that a stage has, not for all of Tailwind.
  await buildTables({
    content: ['components/ui/gravity-stack.tsx'],
    css: false,
    out: '.contentlayer/cn-tables.mjs',
  })
  await writeFile(
    '.contentlayer/cn.mjs',
    `import { createEngine } from 'cn/engine'
import tables from './cn-tables.mjs'
export const cn = createEngine(tables).merge
`,
  )
  // Node's `process`, of which a browser needs no more than an empty environment.
  await writeFile('.contentlayer/process.mjs', 'export default { env: {} }\n')
  // Polyfills for browsers that are too old for Tailwind's styles. Next's client calls none of them.
  await writeFile('.contentlayer/no-polyfills.mjs', 'export {}\n')
  // What Next's links fetch in advance; ours are plain ones.
  const nothing = [
    'cancelPrefetchTask',
    'isPrefetchTaskDirty',
    'needsSpeculativePrefetch',
    'pingPrefetchScheduler',
    'pingPrefetchTask',
    'reschedulePrefetchTask',
    'schedulePrefetchTask',
    'startRevalidationCooldown',
  ]
  await writeFile(
    '.contentlayer/no-prefetch.mjs',
    nothing.map((name) => `export function ${name}() {}\n`).join(''),
  )
  // What runs a server's functions from the browser; a site of files has no server.
  await writeFile('.contentlayer/no-actions.mjs', 'export const serverActionReducer = (state) => state\n')
  return {
    cn: './.contentlayer/cn.mjs',
    './reducers/server-action-reducer': './.contentlayer/no-actions.mjs',
    'next/dist/compiled/process': './.contentlayer/process.mjs',
    '../build/polyfills/polyfill-module': './.contentlayer/no-polyfills.mjs',
    // Next's page for a page that React gave up on brings a stylesheet of its own. Ours is shorter.
    ...Object.fromEntries(
      ['./builtin/global-error', '../components/builtin/global-error'].map((path) => [
        path,
        './app/global-error.tsx',
      ]),
    ),
    ...Object.fromEntries(
      ['./scheduler', './segment-cache/scheduler', '../../segment-cache/scheduler'].map((path) => [
        path,
        './.contentlayer/no-prefetch.mjs',
      ]),
    ),
  }
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
    : // Where `distDir` is given, `next typegen` writes there too, so it is for the tests' own build alone.
      { output: 'export', distDir: process.env.SITE_OUT }),
  basePath,
  // For lib/address.ts, on the server and in browsers.
  env: { BASE_PATH: basePath },
  reactStrictMode: true,
  serverExternalPackages: ['react-docgen', 'rolldown', 'shiki'],
  experimental: {
    // Every link here loads a document, so the part of Next's router that guesses routes has nothing to do.
    optimisticRouting: false,
    prefetchInlining: false,
    varyParams: false,
    turbopackCjsTreeShaking: true,
  },
  turbopack: {
    // This folder is the root, also when a folder above holds a lock file.
    root: import.meta.dirname,
    resolveAlias: phase === PHASE_PRODUCTION_BUILD ? await lighter() : {},
  },
})

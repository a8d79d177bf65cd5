import packageJson from './package.json' with { type: 'json' }

/**
 * Where the site will stand, without a slash at the end: the one setting behind every address that we write
 * into pages, the registry and the component's first lines. Give it at build time: `SITE_URL=https://… npm run build`.
 */
export const siteUrl = (process.env.SITE_URL || 'http://localhost:4000').replace(/\/+$/, '')

/** The version people see in the component's first lines, in the registry and in the changelog. */
export const { version } = packageJson

/** Where the source stands, for the edit links of the docs; without it there are none. */
export const repositoryUrl = (process.env.REPOSITORY_URL || '').replace(/\/+$/, '')

import packageJson from './package.json' with { type: 'json' }

/** The address in the files that are committed; a build names `siteUrl` in its place. */
export const committedUrl = 'http://localhost:4000'

/** Where the site will stand, without a slash at the end. Give it at build time: `SITE_URL=https://… npm run build`. */
export const siteUrl = (process.env.SITE_URL || committedUrl).replace(/\/+$/, '')

/** The folder of its host that the site stands in, '' at the root: the path of its address. */
export const basePath = new URL(siteUrl).pathname.replace(/\/$/, '')

/** A text of this repository with the address of this build for the committed one. */
export const addressed = (text) => text.replaceAll(committedUrl, siteUrl)

/** The folder that a build goes to. The tests name one of their own, which leaves what `npm run site` serves as it is. */
export const out = process.env.SITE_OUT || 'out'

/** The version people see in the component's first lines, in the registry and in the changelog. */
export const { version } = packageJson

/** Where the source stands, for the edit links of the docs; without it there are none. */
export const repositoryUrl = (process.env.REPOSITORY_URL || '').replace(/\/+$/, '')

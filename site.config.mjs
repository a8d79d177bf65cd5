import packageJson from './package.json' with { type: 'json' }

/** The address in the files that are committed; a build names `siteUrl` in its place. */
export const committedUrl = 'http://localhost:4000'

/**
 * The site's address without a slash at the end: `SITE_URL`, else what the host says, else the committed one.
 */
export const siteUrl = (process.env.SITE_URL || hostedAt(process.env) || committedUrl).replace(/\/+$/, '')

/** The address of a build by the variables of its host. Previews have addresses of their own. */
export function hostedAt(env) {
  if (env.VERCEL) {
    const host = env.VERCEL_ENV === 'production' ? env.VERCEL_PROJECT_PRODUCTION_URL : env.VERCEL_URL
    return host && `https://${host}`
  }
  if (env.NETLIFY) return env.CONTEXT === 'production' ? env.URL : env.DEPLOY_PRIME_URL
  if (env.CF_PAGES) {
    // Its variable names this one build, for good; people come to the project, of which it is a subdomain.
    const live = ['main', 'master'].includes(env.CF_PAGES_BRANCH)
    return live
      ? env.CF_PAGES_URL?.replace(/^(https:\/\/)[^.]+\.([^.]+\.pages\.dev)/, '$1$2')
      : env.CF_PAGES_URL
  }
  if (env.GITHUB_ACTIONS && env.GITHUB_REPOSITORY) {
    const [owner, name] = env.GITHUB_REPOSITORY.toLowerCase().split('/')
    const host = `${owner}.github.io`
    return name === host ? `https://${host}` : `https://${host}/${env.GITHUB_REPOSITORY.split('/')[1]}`
  }
}

/** The folder of its host that the site stands in, '' at the root: the path of its address. */
export const basePath = new URL(siteUrl).pathname.replace(/\/$/, '')

/** A text of this repository with the address of this build for the committed one. */
export const addressed = (text) => text.replaceAll(committedUrl, siteUrl)

/** The folder that a build goes to. Tests name their own, so that what `npm run site` serves stays. */
export const out = process.env.SITE_OUT || 'out'

/** The version people see in the component's first lines, in the registry and in the changelog. */
export const { version } = packageJson

/**
 * The repository on GitHub as owner/name, for people who add items from it: those of registry.json then name
 * each other there. Left empty, they name each other by addresses of the site, as they do in what a site
 * serves in any case.
 */
export const repository = ''

/** Where the source stands, for the edit links of the docs; without it there are none. */
export const repositoryUrl = publicAddress(
  process.env.REPOSITORY_URL || (repository && `https://github.com/${repository}`),
)

/**
 * The address of a repository without credentials: some hosts put the token into it that they fetch it with.
 */
export function publicAddress(address) {
  const web = address.replace(/^git@([^:]+):/, 'https://$1/')
  return web.replace(/^(https?:\/\/)[^/@]*@/, '$1').replace(/(\.git)?\/*$/, '')
}

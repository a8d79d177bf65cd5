// Serves a built site as a static host would: clean URLs, compression, and the headers of public/_headers.
import { existsSync, readFileSync } from 'node:fs'
import { createServer } from 'node:http'
import { join } from 'node:path'
import compression from 'compression'
import { lookup } from 'mrmime'
import sirv from 'sirv'
import { basePath, out, siteUrl } from '../site.config.mjs'
import { isMain, root } from './run.mjs'

/** The rules of a _headers file: a path, a star at its end for all below it, then indented headers. */
function headerRules(file) {
  const rules = []
  for (const line of readFileSync(file, 'utf8').split('\n')) {
    if (/^\//.test(line)) rules.push({ path: line.trim(), headers: [] })
    else if (/^\s+\S/.test(line)) rules.at(-1).headers.push(line.trim().split(/:\s*(.*)/, 2))
  }
  return rules.map(({ path, headers }) => ({
    headers,
    matches: (url) => (path.endsWith('*') ? url.startsWith(path.slice(0, -1)) : url === path),
  }))
}

/**
 * Serves a built folder from a port, 0 for any free one, below `base`: the path of the address that it was
 * built for. What is built into the folder meanwhile is served too.
 */
export function serve(folder, port, base = '') {
  const compress = compression()
  const files = sirv(folder, {
    extensions: ['html'],
    etag: true,
    // read from disk each time, so that a build made meanwhile shows
    dev: true,
    setHeaders(response, url) {
      // sirv names a type only after this, and a charset for pages alone.
      const type = lookup(url)
      if (/^text\/\w+$/.test(type)) response.setHeader('Content-Type', `${type};charset=utf-8`)
      for (const { matches, headers } of headerRules(join(folder, '_headers'))) {
        if (matches(base + url)) for (const [name, value] of headers) response.setHeader(name, value)
      }
    },
  })
  const notFound = (response) => {
    response.writeHead(404, { 'Content-Type': 'text/html;charset=utf-8' })
    response.end(readFileSync(join(folder, '404.html')))
  }
  const server = createServer((request, response) => {
    const [path] = request.url.split('?')
    if (path !== base && !path.startsWith(`${base}/`)) return response.writeHead(404).end()
    request.url = request.url.slice(base.length).replace(/^(?!\/)/, '/')
    compress(request, response, () => files(request, response, () => notFound(response)))
  })
  return new Promise((resolve, reject) => server.once('error', reject).listen(port, () => resolve(server)))
}

/** Serves until the process ends, and says where. */
export async function serveSite() {
  const folder = join(root, out)
  if (!existsSync(folder)) throw new Error(`There is no ${out}/ to serve yet. Run: npm run build`)
  // Pages and registry name their own address: served at another port, every copied command would be dead.
  const port = Number(new URL(siteUrl).port || 4000)
  await serve(folder, port, basePath).catch((error) => {
    if (error.code !== 'EADDRINUSE') throw error
    console.error(`Port ${port} is taken. Another one: SITE_URL=http://localhost:${port + 1} npm run site`)
    process.exit(1)
  })
  console.log(`Site:     http://localhost:${port}${basePath}`)
  console.log(`Registry: http://localhost:${port}${basePath}/r/gravity-stack.json`)
}

if (isMain(import.meta.url)) await serveSite()

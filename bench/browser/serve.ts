// Serves the measured pages: one stage each, rendered on the server, with the script of a production build.
import { createServer } from 'node:http'
import { createRequire } from 'node:module'
import type { AddressInfo } from 'node:net'
import { join } from 'node:path'
import { gzipSync } from 'node:zlib'
import tailwind from '@tailwindcss/postcss'
import postcss from 'postcss'
import { root } from '../build/root'
import { script } from '../build/script'
import type { StageName } from './results'

const here = join(root, 'bench/browser')
const resolve = { alias: { '@': root } }
export const stageNames: StageName[] = ['gravity-stack', 'circle-chains', 'matter-js']

async function bundle(stage: StageName | 'demos') {
  const stdin = `import Stage from './${stage}'\n`
  const [client, server, alone] = await Promise.all([
    script(
      `${stdin}
      import { hydrateRoot } from 'react-dom/client'
      const props = JSON.parse(document.getElementById('props').textContent)
      hydrateRoot(document.getElementById('root'), <Stage {...props} />)`,
      here,
      'esm',
      { resolve },
    ),
    script(
      `${stdin}
      import { renderToString } from 'react-dom/server'
      export const render = (props) => renderToString(<Stage {...props} />)`,
      here,
      'cjs',
      { platform: 'node', resolve },
    ),
    script(`${stdin}export default Stage`, here, 'esm', {
      external: ['react', 'react/jsx-runtime', 'cn'],
      resolve,
    }),
  ])
  const module = { exports: {} as { render: (props: object) => string } }
  const require = createRequire(import.meta.url)
  new Function('module', 'exports', 'require', server)(module, module.exports, require)
  return { script: client, bytes: gzipSync(alone, { level: 9 }).length, render: module.exports.render }
}

const css = `@import "tailwindcss" source(none);
@import "../../app/elevation.css";
@source "./";
@source "../../registry/examples";
@source "../../components/ui/gravity-stack.tsx";
body { font-family: Arial, sans-serif; }`

/** Starts the server; `close` ends it. */
export async function serve() {
  const bundles = Object.fromEntries(
    await Promise.all(
      [...stageNames, 'demos' as const].map(async (stage) => [stage, await bundle(stage)] as const),
    ),
  )
  const watching = `export { observe } from './observe'; export { record } from './replay'`
  const observing = await script(watching, here, 'iife', { name: 'observer' })
  const styles = await postcss([tailwind()]).process(css, { from: join(here, 'page.css') })
  const server = createServer((request, response) => {
    const { pathname, searchParams } = new URL(request.url ?? '/', 'http://localhost')
    const send = (type: string, text: string) => {
      response.writeHead(200, { 'content-type': `${type}; charset=utf-8` }).end(text)
    }
    const [, name, file] = pathname.split('/')
    const stage = bundles[name]
    if (name === 'idle')
      return send('text/html', '<script>(function loop() { requestAnimationFrame(loop) })()</script>')
    if (name === 'page.css') return send('text/css', styles.css)
    if (!stage) return response.writeHead(name === 'favicon.ico' ? 200 : 404).end()
    if (file === 'client.js') return send('text/javascript', stage.script)
    const { above, counting, recording, ...values } = Object.fromEntries(searchParams)
    const props = Object.fromEntries(Object.entries(values).map(([key, value]) => [key, JSON.parse(value)]))
    return send(
      'text/html',
      `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>${name}</title>
<meta name="viewport" content="width=device-width"><link rel="stylesheet" href="/page.css">
<script>${observing}observer.observe(${counting === 'true'});${recording === 'true' ? 'observer.record()' : ''}</script></head>
<body><div style="height:${Number(above)}px"></div><div id="root">${stage.render(props)}</div>
<script id="props" type="application/json">${JSON.stringify(props)}</script></body></html>`,
    )
  })
  await new Promise<void>((resolve) => server.listen(0, resolve))
  const { port } = server.address() as AddressInfo
  const bytes = (stage: StageName) => bundles[stage].bytes
  return { url: `http://localhost:${port}`, bytes, close: () => server.close() }
}

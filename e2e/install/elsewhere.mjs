// Loaded into the CLI by a test: what it asks of GitHub's file server is answered from this checkout, and what it
// asks of shadcn's own site for a preset, by an empty one.
import { readFile } from 'node:fs/promises'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'

const root = fileURLToPath(new URL('../..', import.meta.url))
const online = globalThis.fetch

globalThis.fetch = async (input, init) => {
  const { hostname, pathname } = new URL(typeof input === 'string' ? input : (input.url ?? input.href))
  if (hostname === 'ui.shadcn.com' && pathname === '/init')
    return Response.json({ name: 'preset', type: 'registry:base' })
  if (hostname !== 'raw.githubusercontent.com') return online(input, init)
  const [, , , , ...path] = pathname.split('/')
  try {
    return new Response(await readFile(join(root, ...path)))
  } catch {
    return new Response('404: Not Found', { status: 404 })
  }
}

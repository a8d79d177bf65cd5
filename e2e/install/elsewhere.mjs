// Loaded into the CLI by a test: what it asks of GitHub's file server is answered from the repository in the
// folder REPOSITORY, and what it asks of shadcn's own site for a preset, by an empty one.
import { execFileSync } from 'node:child_process'

const online = globalThis.fetch

globalThis.fetch = async (input, init) => {
  const { hostname, pathname } = new URL(typeof input === 'string' ? input : (input.url ?? input.href))
  if (hostname === 'ui.shadcn.com' && pathname === '/init')
    return Response.json({ name: 'preset', type: 'registry:base' })
  if (hostname !== 'raw.githubusercontent.com') return online(input, init)
  const [, , , commit, ...path] = pathname.split('/')
  try {
    const options = { cwd: process.env.REPOSITORY, stdio: 'pipe', maxBuffer: 2 ** 26 }
    return new Response(execFileSync('git', ['show', `${commit}:${path.join('/')}`], options))
  } catch {
    return new Response('404: Not Found', { status: 404 })
  }
}

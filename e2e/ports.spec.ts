import { spawn } from 'node:child_process'
import { once } from 'node:events'
import type { AddressInfo } from 'node:net'
import { join } from 'node:path'
import { createInterface } from 'node:readline'
import { expect, test } from '@playwright/test'
import { root } from '../scripts/run.mjs'
import { serve } from '../scripts/serve.mjs'
import { out } from '../site.config.mjs'

test('tests of two clones have servers of their own at the same time', async ({ request }) => {
  const fixtures = spawn('node', ['e2e/fixtures/server.mjs'], { cwd: root })
  const site = await serve(join(root, out), 0)
  try {
    const lines = createInterface({ input: fixtures.stdout })
    const [said] = await Promise.race([once(lines, 'line'), once(lines, 'close')])
    const url = String(said).replace('Fixtures: ', '')
    expect(url).not.toBe(process.env.FIXTURES_URL)
    expect((await request.get(`${url}/pile`)).ok()).toBe(true)

    const { port } = site.address() as AddressInfo
    expect(await (await request.get(`http://localhost:${port}/llms.txt`)).text()).toContain('# Gravity Stack')
  } finally {
    fixtures.kill()
    site.close()
    site.closeAllConnections()
  }
})

import { spawn } from 'node:child_process'
import { once } from 'node:events'
import { createServer } from 'node:http'
import type { AddressInfo } from 'node:net'

/** Runs a script that puts what it finds into `found`. No driver: a page sends that back. */
export async function inFirefox(command: string, folder: string, script: string) {
  const page = `<!doctype html><meta charset="utf-8"><script type="module">${script}
    fetch('/', { method: 'POST', body: await found })</script>`
  const server = createServer((request, response) => {
    if (request.method !== 'POST') return response.setHeader('content-type', 'text/html').end(page)
    let body = ''
    request.on('data', (text) => {
      body += text
    })
    request.on('end', () => server.emit('found', body))
  }).listen(0)
  const url = `http://localhost:${(server.address() as AddressInfo).port}`
  const args = ['--headless', '--no-remote', '--profile', folder, url]
  // It ends before the test gives up, so that none is left behind.
  const browser = spawn(command, args, { stdio: 'ignore', timeout: 150_000 })
  const exit = once(browser, 'exit')
  try {
    const ended = exit.then(() => {
      throw new Error(`${command} ended before it had found anything`)
    })
    return (await Promise.race([once(server, 'found'), ended]))[0] as string
  } finally {
    browser.kill()
    await exit
    server.closeAllConnections()
    server.close()
  }
}

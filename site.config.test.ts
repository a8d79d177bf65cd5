import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from 'vitest'
import { parse } from 'yaml'
import { root } from './scripts/run.mjs'
import { hostedAt, publicAddress } from './site.config.mjs'

const text = (path: string) => readFileSync(join(root, path), 'utf8')

test('a build knows its address on each host, and that of a preview', () => {
  const vercel = {
    VERCEL: '1',
    VERCEL_URL: 'chips-a1b2.vercel.app',
    VERCEL_PROJECT_PRODUCTION_URL: 'chips.example',
  }
  expect(hostedAt({ ...vercel, VERCEL_ENV: 'production' })).toBe('https://chips.example')
  expect(hostedAt({ ...vercel, VERCEL_ENV: 'preview' })).toBe('https://chips-a1b2.vercel.app')

  const netlify = {
    NETLIFY: 'true',
    URL: 'https://chips.example',
    DEPLOY_PRIME_URL: 'https://deploy-preview-7--chips.netlify.app',
  }
  expect(hostedAt({ ...netlify, CONTEXT: 'production' })).toBe('https://chips.example')
  expect(hostedAt({ ...netlify, CONTEXT: 'deploy-preview' })).toBe(netlify.DEPLOY_PRIME_URL)

  const cloudflare = { CF_PAGES: '1', CF_PAGES_URL: 'https://a1b2c3d4.chips.pages.dev' }
  expect(hostedAt({ ...cloudflare, CF_PAGES_BRANCH: 'main' })).toBe('https://chips.pages.dev')
  expect(hostedAt({ ...cloudflare, CF_PAGES_BRANCH: 'softer' })).toBe(cloudflare.CF_PAGES_URL)

  const github = { GITHUB_ACTIONS: 'true' }
  expect(hostedAt({ ...github, GITHUB_REPOSITORY: 'Someone/Chips' })).toBe('https://someone.github.io/Chips')
  expect(hostedAt({ ...github, GITHUB_REPOSITORY: 'Someone/someone.github.io' })).toBe(
    'https://someone.github.io',
  )

  expect(hostedAt({})).toBeUndefined()
  expect(hostedAt({ VERCEL: '1' })).toBeUndefined()
})

test('an edit link never shows the token with which a host fetches the repository', () => {
  for (const address of [
    'https://x-access-token:v1.5c3b@github.com/liten/gravity-stack',
    'https://github.com/liten/gravity-stack.git',
    'git@github.com:liten/gravity-stack.git',
    'https://github.com/liten/gravity-stack/',
  ])
    expect(publicAddress(address)).toBe('https://github.com/liten/gravity-stack')
  expect(publicAddress('')).toBe('')
})

test('Vercel, which reads no _headers, sends the same headers', () => {
  const rules = JSON.parse(text('vercel.json')).headers as {
    source: string
    headers: { key: string; value: string }[]
  }[]
  const asFile = rules.map(({ source, headers }) =>
    [source.replace('(.*)', '*'), ...headers.map(({ key, value }) => `  ${key}: ${value}`)].join('\n'),
  )
  expect(`${asFile.join('\n\n')}\n`).toBe(text('public/_headers'))
})

test('the workflows run commands that there are, and publish what has passed its tests', () => {
  const { scripts } = JSON.parse(text('package.json'))
  const workflow = (name: string) => parse(text(`.github/workflows/${name}.yml`))
  const stepsOf = (name: string) =>
    Object.values<{ steps: { run?: string; with?: { path?: string } }[] }>(workflow(name).jobs).flatMap(
      ({ steps }) => steps,
    )
  const commands = [...stepsOf('test'), ...stepsOf('pages')].flatMap(({ run }) => run ?? [])
  expect(commands).toEqual(['npm test', 'npm run build'])
  for (const command of commands) expect(scripts).toHaveProperty(command.split(' ').at(-1)!)
  expect(workflow('pages').on.workflow_run.workflows).toEqual([workflow('test').name])
  expect(stepsOf('pages').some((step) => step.with?.path === 'out')).toBe(true)
})

test('a bug report asks for a link to the playground, the version and the browser', () => {
  const { body } = parse(text('.github/ISSUE_TEMPLATE/bug.yml'))
  const asked = body.map(({ id }: { id: string }) => id)
  expect(asked).toEqual(expect.arrayContaining(['playground', 'version', 'browser']))
})

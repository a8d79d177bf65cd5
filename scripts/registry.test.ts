import { execFile } from 'node:child_process'
import { mkdtemp, readdir, readFile, rm } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { promisify } from 'node:util'
import { registryItemSchema, registrySchema } from 'shadcn/schema'
import { expect, onTestFinished, test } from 'vitest'
import { committedUrl } from '../site.config.mjs'
import { freshIndex } from './registry.mjs'
import { root } from './run.mjs'

const served = join(root, 'public/r')
const read = async (path: string) => JSON.parse(await readFile(path, 'utf8'))

test('each served item and the index hold to shadcn’s own schema', async () => {
  for (const file of await readdir(served)) {
    const schema = file === 'registry.json' ? registrySchema : registryItemSchema
    const { error } = schema.safeParse(await read(join(served, file)))
    expect(error, file).toBeUndefined()
  }
})

test('each example of the docs is an item, named …-demo, that brings the component along', async () => {
  const { homepage, items } = await read(join(root, 'registry.json'))
  const demos = items.filter(({ name }: { name: string }) => name.endsWith('-demo'))
  const files = await readdir(join(root, 'registry/examples'))
  expect(demos.map(({ name }: { name: string }) => `${name}.tsx`).sort()).toEqual(files.sort())
  for (const { registryDependencies } of demos) {
    expect(registryDependencies).toContain(`${homepage}/r/gravity-stack.json`)
  }
})

test('items name each other by address, or by the repository that people add them from', async () => {
  const dependencies = async (repository: string) =>
    (await freshIndex(repository)).items.flatMap(
      ({ registryDependencies = [] }: { registryDependencies?: string[] }) => registryDependencies,
    )
  const addresses = await dependencies('')
  expect(addresses).toContain(`${committedUrl}/r/elevation.json`)
  expect(await dependencies('liten/gravity-stack')).toEqual(
    addresses.map((to: string) =>
      to.replace(`${committedUrl}/r/`, 'liten/gravity-stack/').replace(/\.json$/, ''),
    ),
  )
})

test('each item says what it is, whose, and where its docs are', async () => {
  const { version } = await read(join(root, 'package.json'))
  for (const { name } of (await read(join(root, 'registry.json'))).items) {
    const item = await read(join(served, `${name}.json`))
    expect(item, name).toMatchObject({
      title: expect.any(String),
      description: expect.any(String),
      author: expect.any(String),
      categories: expect.any(Array),
      meta: { version, homepage: expect.stringContaining('/docs/') },
    })
  }
})

test('the address given at build time is the only one in what is served', async () => {
  const folder = await mkdtemp(join(tmpdir(), 'registry-'))
  onTestFinished(() => rm(folder, { recursive: true }))
  const SITE_URL = 'https://chips.example'
  await promisify(execFile)('node', ['scripts/registry.mjs', folder], {
    cwd: root,
    env: { ...process.env, SITE_URL },
  })
  const index = await read(join(folder, 'r/registry.json'))
  expect(index.homepage).toBe(SITE_URL)
  const demo = await read(join(folder, 'r/gravity-stack-demo.json'))
  expect(demo.registryDependencies).toEqual([`${SITE_URL}/r/gravity-stack.json`])
  const files = (await readdir(folder, { recursive: true })).filter((path) => path.endsWith('.json'))
  for (const file of files) {
    expect(await readFile(join(folder, file), 'utf8'), file).not.toContain('localhost')
  }
})

test('the entry for the directory has all it asks for, and a square logo', async () => {
  const entry = await read(join(root, 'public/directory.json'))
  expect(entry).toEqual({
    name: expect.stringMatching(/^@[a-z-]+$/),
    homepage: expect.any(String),
    url: `${entry.homepage}/r/{name}.json`,
    description: expect.any(String),
    logo: expect.stringMatching(/^<svg /),
  })
  const [, , width, height] = entry.logo.match(/viewBox="(\S+) (\S+) (\S+) (\S+)"/).slice(1)
  expect(width).toBe(height)
})

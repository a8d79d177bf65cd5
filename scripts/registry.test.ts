import { execFile } from 'node:child_process'
import { cp, mkdtemp, readdir, readFile, rm, symlink, writeFile } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { promisify } from 'node:util'
import { registryItemSchema, registrySchema } from 'shadcn/schema'
import { expect, onTestFinished, test } from 'vitest'
import { committedUrl, version } from '../site.config.mjs'
import { freshIndex } from './registry.mjs'
import { digest, folderOf, itemFiles, releases } from './releases.mjs'
import { root } from './run.mjs'

const served = join(root, 'public/r')
const read = async (path: string) => JSON.parse(await readFile(path, 'utf8'))

test('each served item and the index hold to shadcn’s own schema', async () => {
  for (const file of itemFiles(served)) {
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

test('each block is an item of its own, one file that brings the component along', async () => {
  const { homepage, items } = await read(join(root, 'registry.json'))
  const blocks = items.filter(({ type }: { type: string }) => type === 'registry:block')
  const files = await readdir(join(root, 'registry/blocks'))
  expect(blocks.map(({ name }: { name: string }) => `${name}.tsx`).sort()).toEqual(files.sort())
  for (const { name, files, registryDependencies } of blocks) {
    expect(files).toMatchObject([{ path: `registry/blocks/${name}.tsx` }])
    expect(registryDependencies).toEqual([`${homepage}/r/gravity-stack.json`])
  }
})

test('each item says what it is, whose, and where its docs are', async () => {
  for (const { name } of (await read(join(root, 'registry.json'))).items) {
    const item = await read(join(served, `${name}.json`))
    expect(item, name).toMatchObject({
      title: expect.any(String),
      description: expect.any(String),
      author: expect.any(String),
      categories: expect.any(Array),
      meta: { version, homepage: expect.stringMatching(/\/(docs\/|blocks#)/) },
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
  // Who pins a version gets it by way of an example too.
  for (const pinned of [version, ...Object.keys(releases)]) {
    const of = (name: string) => join(folder, 'r', pinned, `${name}.json`)
    expect((await read(of('gravity-stack'))).meta.version).toBe(pinned)
    expect((await read(of('gravity-stack-demo'))).registryDependencies).toEqual([
      `${SITE_URL}/r/${pinned}/gravity-stack.json`,
    ])
  }
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

test('the files of a released version are those of its day, byte for byte', async () => {
  expect(releases['0.1.0'].sha256).toBe('343332ca35978e2137152e4fb59ffd6b314ec8206d0c085104a1cae71161841e')
  const kept = await readdir(served, { withFileTypes: true })
  const folders = kept.filter((entry) => entry.isDirectory()).map(({ name }) => name)
  expect(folders.sort()).toEqual(Object.keys(releases).sort())
  for (const released of folders) expect(digest(folderOf(released)), released).toBe(releases[released].sha256)
})

test('a release keeps the files of its version, and a later change to them needs a new version', async () => {
  const clone = await mkdtemp(join(tmpdir(), 'release-'))
  onTestFinished(() => rm(clone, { recursive: true }))
  for (const path of [
    ...['scripts', 'registry', 'public', 'components/ui', 'app/elevation.css', 'app/icon.svg'],
    ...['registry.json', 'package.json', 'site.config.mjs', 'biome.json', '.gitignore', 'CHANGELOG.md'],
  ])
    await cp(join(root, path), join(clone, path), { recursive: true })
  await symlink(join(root, 'node_modules'), join(clone, 'node_modules'))
  const edit = async (path: string, change: (text: string) => string) =>
    writeFile(join(clone, path), change(await readFile(join(clone, path), 'utf8')))
  const next = '7.0.0'
  await edit('package.json', (text) => text.replace(`"version": "${version}"`, `"version": "${next}"`))
  await edit('CHANGELOG.md', (text) => text.replace('\n## ', `\n## ${next}\n\n- New.\n\n## `))
  const run = (script: string, ...args: string[]) =>
    promisify(execFile)('node', [`scripts/${script}.mjs`, ...args], { cwd: clone }).then(
      () => 'done',
      ({ stderr }) => stderr,
    )
  expect(await run('release'), 'what is stale is not released').toMatch(/is stale/)
  await run('assemble')
  await run('registry')
  expect(await run('release')).toBe('done')
  const kept = (await read(join(clone, 'public/r', next, 'gravity-stack.json'))).files
  expect(kept).toEqual((await read(join(clone, 'public/r/gravity-stack.json'))).files)
  expect(await run('registry', '--check')).toBe('done')

  await edit('registry/examples/gravity-stack-demo.tsx', (text) => text.replace('h-80', 'h-96'))
  await run('registry')
  expect(await run('registry', '--check')).toMatch('7.0.0 is released and its files have changed')
})

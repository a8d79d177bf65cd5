// Builds the registry from registry.json and the files it names: the folder r of items, and directory.json,
// which is our entry for shadcn's directory of registries.
//   node scripts/registry.mjs           renews registry.json, writes into public with the committed address
//   node scripts/registry.mjs FOLDER    writes them into that folder, with the address of this build
//   node scripts/registry.mjs --check   fails when registry.json or public isn't what that would give
import { mkdir, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import postcss from 'postcss'
import { addressed, committedUrl, repository, siteUrl, version } from '../site.config.mjs'
import { digest, folderOf, itemFiles, releases } from './releases.mjs'
import { isMain, must, root } from './run.mjs'

const index = join(root, 'registry.json')
const served = join(root, 'public')

/** The site's elevation ladder as a registry item: tokens are `cssVars`, other rules are `css`. */
async function elevation() {
  const cssVars = { theme: {}, light: {}, dark: {} }
  const css = {}
  const { nodes } = postcss.parse(await readFile(join(root, 'app/elevation.css'), 'utf8'))
  for (const { name, selector, nodes: declarations } of nodes.filter(({ type }) => type !== 'comment')) {
    const theme = name ?? (selector.startsWith(':root') ? 'light' : selector === '.dark' && 'dark')
    for (const { prop, value } of declarations) {
      const text = value.replace(/\s+/g, ' ')
      if (theme) cssVars[theme][prop.replace('--', '')] = text
      else css[selector] = { ...css[selector], [prop]: text }
    }
  }
  return { cssVars, css }
}

const address = (name) => `${committedUrl}/r/${name}.json`

/** An index in which items that depend on others of the same index name them by `form`. */
function withDependencies({ items, ...rest }, form) {
  const names = new Set(items.map(({ name }) => name))
  const renamed = (dependency) => {
    const name = dependency.match(/\/([^/]+?)(\.json)?$/)?.[1]
    return names.has(name) ? form(name) : dependency
  }
  return {
    ...rest,
    items: items.map((item) =>
      item.registryDependencies
        ? { ...item, registryDependencies: item.registryDependencies.map(renamed) }
        : item,
    ),
  }
}

/**
 * registry.json as it is committed: with the address, the form of dependencies and the stylesheet's tokens.
 */
export async function freshIndex(source = repository) {
  const text = await readFile(index, 'utf8')
  const registry = JSON.parse(text.replaceAll(JSON.parse(text).homepage, committedUrl))
  const ladder = registry.items.find(({ name }) => name === 'elevation')
  Object.assign(ladder, await elevation())
  return withDependencies(registry, source ? (name) => `${source}/${name}` : address)
}

/** Writes registry.json as it is to be committed, and says whether it was another one. */
async function renewIndex({ write }) {
  const fresh = await freshIndex()
  const committed = JSON.parse(await readFile(index, 'utf8'))
  if (JSON.stringify(committed) === JSON.stringify(fresh)) return false
  if (write) {
    await writeFile(index, JSON.stringify(fresh, null, 2))
    await must('biome', ['format', '--write', index])
  }
  return true
}

/** What the site serves: the index with addresses for dependencies, and the package's version. */
async function source() {
  const { items, ...rest } = withDependencies(await freshIndex(), address)
  return { ...rest, items: items.map((item) => ({ ...item, meta: { ...item.meta, version } })) }
}

async function directoryEntry() {
  const { name, items } = await source()
  const logo = await readFile(join(root, 'app/icon.svg'), 'utf8')
  return {
    name: `@${name}`,
    homepage: committedUrl,
    url: `${committedUrl}/r/{name}.json`,
    description: items[0].description,
    logo: logo.replace(/\n\s*/g, ''),
  }
}

/** Does some work in a folder that is gone afterwards. */
async function inFolder(work) {
  const folder = await mkdtemp(join(tmpdir(), 'registry-'))
  try {
    return await work(folder)
  } finally {
    await rm(folder, { recursive: true })
  }
}

/** Writes the registry into a folder with the address that is committed. */
async function writeRegistry(output) {
  await inFolder(async (folder) => {
    const file = join(folder, 'registry.json')
    await writeFile(file, JSON.stringify(await source()))
    await mkdir(join(output, 'r'), { recursive: true })
    for (const name of itemFiles(join(output, 'r'))) await rm(join(output, 'r', name))
    await must('shadcn', ['build', file, '--cwd', root, '--output', join(output, 'r')])
  })
  await writeFile(join(output, 'directory.json'), `${JSON.stringify(await directoryEntry(), null, 2)}\n`)
}

/** Writes a version of the registry into a build's folder. Its items name each other at that version. */
async function writeVersion(output, version, from) {
  const to = join(output, 'r', version)
  await mkdir(to, { recursive: true })
  const { homepage } = JSON.parse(await readFile(join(from, 'registry.json'), 'utf8'))
  for (const name of itemFiles(from)) {
    const text = (await readFile(join(from, name), 'utf8')).replaceAll(homepage, siteUrl)
    await writeFile(join(to, name), text.replaceAll(`${siteUrl}/r/`, `${siteUrl}/r/${version}/`))
  }
}

/** Writes the registry with this build's address: the newest, each released version, and this version. */
export async function buildRegistry(output) {
  await writeRegistry(output)
  for (const released of Object.keys(releases)) await writeVersion(output, released, folderOf(released))
  if (!releases[version]) await writeVersion(output, version, join(output, 'r'))
  for (const [path, text] of await readAll(output)) await writeFile(join(output, path), addressed(text))
}

async function readAll(folder) {
  const paths = ['directory.json', ...itemFiles(join(folder, 'r')).map((name) => join('r', name))]
  const read = async (path) => [path, await readFile(join(folder, path), 'utf8').catch(() => '')]
  return new Map(await Promise.all(paths.map(read)))
}

/** The names of files that a fresh build would change, add or drop. */
async function staleFiles() {
  if (await renewIndex({ write: false })) return ['registry.json']
  const [now, then] = await inFolder(async (folder) => {
    await writeRegistry(folder)
    return [await readAll(folder), await readAll(served)]
  })
  return [...new Set([...now.keys(), ...then.keys()])].filter((path) => now.get(path) !== then.get(path))
}

if (isMain(import.meta.url)) {
  const [argument] = process.argv.slice(2)
  if (argument === '--check') {
    const stale = await staleFiles()
    if (stale.length > 0) {
      console.error(`Out of date: ${stale.join(', ')}. Run: npm run registry`)
      process.exit(1)
    }
    if (releases[version] && digest(folderOf()) !== releases[version].sha256) {
      console.error(`${version} is released and its files have changed. Raise the version in package.json.`)
      process.exit(1)
    }
  } else if (argument) {
    await buildRegistry(argument)
  } else {
    await renewIndex({ write: true })
    await writeRegistry(served)
  }
}

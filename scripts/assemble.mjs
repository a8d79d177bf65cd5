// Assembles the one file that people copy from the rooms under registry/gravity-stack.
//   node scripts/assemble.mjs           writes components/ui/gravity-stack.tsx
//   node scripts/assemble.mjs --check   fails when that file is stale
//   node scripts/assemble.mjs --watch   writes it again on every save
import { spawnSync } from 'node:child_process'
import { watch } from 'node:fs'
import { mkdir, readFile, writeFile } from 'node:fs/promises'
import { dirname, join } from 'node:path'
import { committedUrl, version } from '../site.config.mjs'
import { isMain, root } from './run.mjs'

const rooms = join(root, 'registry/gravity-stack')
const output = join(root, 'components/ui/gravity-stack.tsx')
const entry = 'gravity-stack'

/** What each room is for, as its heading in the file. */
const headings = {
  constants: 'every number, its unit and its reason',
  body: 'shapes, mass, inertia, the flat arrays that bodies live in',
  collide: 'two shapes in, contact points out',
  contacts: 'contacts kept from step to step',
  impacts: 'bounces, at their time inside the step',
  solver: 'velocity and position sweeps',
  pairs: 'which pairs may touch (broad phase)',
  islands: 'who rests with whom',
  grab: 'the soft point constraint of a held chip',
  step: 'one step of all that is awake',
  simulation: 'what the stage calls',
  drop: 'where and when each chip starts',
  kick: 'hops and shakes',
  'release-queue': 'whose turn it is, and the clock of the stage',
  'look-ahead': 'how each chip will lie, before anyone sees it',
  input: 'what a caller may pass, and what stands in for the rest',
  chip: 'how a chip looks, and how it is drawn',
  pointers: 'presses, drags and taps',
  view: 'what of a stage is in view',
  loop: 'a call in every frame',
  stage: 'the DOM: measure, paint, observe, loop',
  'gravity-stack': 'the React component',
}

/** For owners whose TypeScript doubts every index (noUncheckedIndexedAccess); the rooms themselves stay precise. */
const trust = `// The solver reads from its arrays only what it wrote there, so no read of them is undefined.
type Trusted<T> = T & { [index: number]: ReturnType<typeof JSON.parse> }
type Float64Array = Trusted<globalThis.Float64Array>
type Int32Array = Trusted<globalThis.Int32Array>
type Uint8Array = Trusted<globalThis.Uint8Array>
`

const IMPORT = /^import\s+(?:type\s+)?(?:[^'"]*?\s+from\s+)?['"]([^'"]+)['"]\n/gm
const DECLARED =
  /^(?:export )?(?:declare )?(?:async )?(?:function\*?|const|let|class|interface|type|enum) (\w+)/gm
const UNNAMED = /^(?:export )?(?:const|let) [[{]|^export (?:default|\*|\{)/m

async function readRoom(name) {
  const path = join(rooms, `${name}.${name === entry ? 'tsx' : 'ts'}`)
  const source = await readFile(path, 'utf8')
  const imports = [...source.matchAll(IMPORT)].map(([text, from]) => ({ text, from }))
  if (UNNAMED.test(source)) throw new Error(`${path}: declare and export by name, one at a time`)
  return { name, path, source, imports, body: source.replace(IMPORT, '').trim() }
}

const rank = (name) => Object.keys(headings).indexOf(name)

/** The rooms that `entry` needs, each after those it imports, else in the order of the headings. */
async function inOrder() {
  const ordered = []
  const visit = async (name, from = []) => {
    if (from.includes(name)) throw new Error(`Rooms import each other: ${[...from, name].join(' → ')}`)
    if (ordered.some((room) => room.name === name)) return
    const room = await readRoom(name)
    const renamed = room.imports.find(({ text, from }) => from.startsWith('.') && /\sas\s/.test(text))
    if (renamed) throw new Error(`${room.path}: ${renamed.from} is imported under another name`)
    const needed = room.imports.flatMap(({ from }) => (from.startsWith('.') ? [from.slice(2)] : []))
    for (const other of needed.sort((a, b) => rank(a) - rank(b))) await visit(other, [...from, name])
    ordered.push(room)
  }
  await visit(entry)
  return ordered
}

/** In one file every top-level name is there once. */
function refuseCollisions(ordered) {
  const owner = new Map()
  for (const { name, body } of ordered) {
    for (const [, declared] of body.matchAll(DECLARED)) {
      if (owner.has(declared) && owner.get(declared) !== name)
        throw new Error(`${declared} is declared in ${owner.get(declared)} and in ${name}`)
      owner.set(declared, name)
    }
  }
}

function format(source) {
  const biome = join(root, 'node_modules/.bin/biome')
  const args = ['format', `--stdin-file-path=${output}`]
  const { status, stdout, stderr } = spawnSync(biome, args, { input: source, encoding: 'utf8', cwd: root })
  if (status !== 0) throw new Error(stderr)
  return stdout
}

export async function assemble() {
  const ordered = await inOrder()
  refuseCollisions(ordered)
  const external = new Map()
  for (const { text, from } of ordered.flatMap(({ imports }) => imports)) {
    if (from.startsWith('.')) continue
    if ((external.get(from) ?? text) !== text) throw new Error(`${from} is imported in two ways`)
    external.set(from, text)
  }
  const [first, ...rest] = ordered.map(({ name, body }) => {
    if (!headings[name]) throw new Error(`${name} needs a heading in scripts/assemble.mjs`)
    const title = `// ${name === entry ? 'component' : name}: ${headings[name]} `
    const heading = title.padEnd(110, '─')
    // What the entry exports is the component's interface; the rest is its own affair.
    return `${heading}\n\n${name === entry ? body : body.replace(/^export /gm, '')}`
  })
  return format(
    [
      `'use client'\n`,
      [...external.keys()]
        .sort()
        .map((from) => external.get(from))
        .join(''),
      // Between imports and values: where the shadcn CLI drops 'use client', or types, comments right before or after go with it.
      `// Gravity Stack ${version} · ${committedUrl}/docs/gravity-stack · MIT`,
      `// Generated by scripts/assemble.mjs from the modules in registry/gravity-stack: there, change those.`,
      `// A copy of this file in your project is yours to change.\n`,
      first,
      `\n${trust}`,
      rest.join('\n\n'),
      '',
    ].join('\n'),
  )
}

async function write() {
  const now = await assemble()
  const then = await readFile(output, 'utf8').catch(() => '')
  if (now === then) return
  await mkdir(dirname(output), { recursive: true })
  await writeFile(output, now)
}

if (isMain(import.meta.url)) {
  if (process.argv.includes('--check')) {
    const now = await readFile(output, 'utf8').catch(() => '')
    if (now !== (await assemble())) {
      console.error('components/ui/gravity-stack.tsx is stale. Run: npm run assemble')
      process.exit(1)
    }
  } else {
    await write()
    if (process.argv.includes('--watch')) {
      let timer
      watch(rooms, () => {
        clearTimeout(timer)
        timer = setTimeout(() => write().catch((error) => console.error(error.message)), 50)
      })
    }
  }
}

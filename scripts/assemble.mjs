// Assembles the one file that people copy from the modules under registry/gravity-stack.
//   node scripts/assemble.mjs           writes components/ui/gravity-stack.tsx
//   node scripts/assemble.mjs --check   fails when that file is stale
//   node scripts/assemble.mjs --watch   writes it again on every save
import { spawnSync } from 'node:child_process'
import { watch } from 'node:fs'
import { mkdir, readFile, writeFile } from 'node:fs/promises'
import { dirname, join } from 'node:path'
import { committedUrl, version } from '../site.config.mjs'
import { isMain, root } from './run.mjs'

const modules = join(root, 'registry/gravity-stack')
const output = join(root, 'components/ui/gravity-stack.tsx')
const entry = 'gravity-stack'

/** What each module is for, as its heading in the file. */
const headings = {
  'solver/constants': 'every number of the solver, its unit and what more and less of it does',
  'solver/state': 'every record and its layout',
  'solver/math': 'rotation and damping, the same bits in every engine',
  'solver/input': 'what callers pass to the world',
  'solver/body': 'shapes, mass, inertia, extents',
  'solver/manifold': 'two shapes in, contact points out',
  'solver/contact': 'pairs that may touch, kept from step to step',
  'solver/broad-phase': 'which pairs may touch',
  'solver/islands': 'who rests with whom',
  'solver/sleep': 'rest and waking',
  'solver/regime': 'how exactly a step is solved',
  'solver/integrate': 'velocities and positions through a sub-step',
  'solver/contact-solver': 'impulses of contacts and friction',
  'solver/entry': 'chips on their way into the stage',
  'solver/position-correction': 'overlap taken out of poses',
  'solver/restitution': 'impacts, at their time inside a sub-step',
  'solver/prepare': 'what contacts ask of a sub-step',
  'solver/make-room': 'after walls have moved or chips have grown',
  'solver/mouse-joint': 'the soft point constraint of a held chip',
  'solver/surroundings': 'walls, ceiling, gravity, friction',
  'solver/population': 'bodies come, go and are changed from outside',
  'solver/push': 'a disc that pushes chips aside',
  'solver/step': 'the algorithm: one step of all that is awake',
  'solver/grab': 'a chip in a hand',
  'solver/copy': 'a world made equal to another',
  'solver/world': 'what the stage calls',
  'stage/props': 'what a caller may pass, and how it is checked',
  'stage/release': 'where and when each chip starts',
  'stage/launch': 'hops and shakes',
  'stage/chip': 'how a chip looks, and how it is drawn',
  'stage/children': 'a chip for each child',
  'stage/release-queue': 'whose turn it is, and the clock of the stage',
  'stage/look-ahead': 'how each chip will lie, before anyone sees it',
  'stage/context': 'what the parts of a stage share',
  'stage/visibility': 'what of a stage is in view',
  'stage/frame-loop': 'a call in every frame',
  'stage/pile': 'the chips in their world',
  'stage/pointer-map': 'from the px of the page to those of the stage',
  'stage/obstacles': 'elements that chips land on',
  'stage/plan': 'what is computed between frames',
  'stage/listeners': 'events, until their listeners end',
  'stage/focus': 'the chip that has the focus',
  'stage/sizes': 'the sizes of the stage and its chips',
  'stage/state': 'static, waiting, running, paused or resting',
  'stage/lifecycle': 'what passes the time in each state',
  'stage/targets': 'what a press or a click is about',
  'stage/clicks': 'taps, and the clicks that end drags',
  'stage/pointers': 'presses and drags',
  'stage/hover': 'the way of a pointer over the stage',
  'stage/stage': 'the parts, wired together',
  'gravity-stack': 'the React component',
}

/**
 * For projects with noUncheckedIndexedAccess, where TypeScript takes each read of an array for possibly
 * undefined.
 */
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

async function readModule(name) {
  const path = join(modules, `${name}.${name === entry ? 'tsx' : 'ts'}`)
  const source = await readFile(path, 'utf8')
  const imports = [...source.matchAll(IMPORT)].map(([text, from]) => ({ text, from }))
  if (UNNAMED.test(source)) throw new Error(`${path}: declare and export by name, one at a time`)
  return { name, path, source, imports, body: source.replace(IMPORT, '').trim() }
}

const rank = (name) => Object.keys(headings).indexOf(name)

/** The modules that `entry` needs, in the order of the headings: each after those it imports. */
async function inOrder() {
  const needed = new Map()
  const visit = async (name) => {
    if (needed.has(name)) return
    needed.set(name, undefined)
    const module = await readModule(name)
    needed.set(name, module)
    const renamed = module.imports.find(({ text, from }) => from.startsWith('.') && /\sas\s/.test(text))
    if (renamed) throw new Error(`${module.path}: ${renamed.from} is imported under another name`)
    for (const { from } of module.imports) {
      if (!from.startsWith('.')) continue
      const other = join(dirname(name), from)
      if (!(rank(other) < rank(name))) throw new Error(`${name} imports ${other}, whose heading comes later`)
      await visit(other)
    }
  }
  await visit(entry)
  return Object.keys(headings).flatMap((name) => needed.get(name) ?? [])
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
      // The comment stands between imports and values: next to 'use client' or a type the shadcn CLI drops
      // it.
      `// Gravity Stack ${version} · ${committedUrl}/docs/gravity-stack · MIT`,
      `// Generated by scripts/assemble.mjs. In this file's own repository edit registry/gravity-stack instead.`,
      `// The records that comments name (D-001 and so on) are in docs/decisions there.`,
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
      watch(modules, { recursive: true }, () => {
        clearTimeout(timer)
        timer = setTimeout(() => write().catch((error) => console.error(error.message)), 50)
      })
    }
  }
}

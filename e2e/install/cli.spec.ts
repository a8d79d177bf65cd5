import { spawn } from 'node:child_process'
import { readFile } from 'node:fs/promises'
import { join } from 'node:path'
import { createInterface } from 'node:readline'
import { freshIndex } from '../../scripts/registry.mjs'
import { root } from '../../scripts/run.mjs'
import { addressed, siteUrl, version } from '../../site.config.mjs'
import { answered, components, expect, item, type Project, test, tool } from './project'

const committed = () => readFile(join(root, 'components/ui/gravity-stack.tsx'), 'utf8')
const source = async () => addressed(await committed())
const file = 'components/ui/gravity-stack.tsx'

/** The least that the CLI takes for a project. */
const bare = (project: Project) =>
  project.write({
    'package.json': { name: 'bare', private: true },
    'tsconfig.json': { compilerOptions: { paths: { '@/*': ['./*'] } } },
    'app.css': "@import 'tailwindcss';\n",
    'components.json': components('app.css', { registries: { '@liten': `${siteUrl}/r/{name}.json` } }),
  })

test('the namespace @liten lists, finds and shows every item', async ({ make }) => {
  const project = await make('bare')
  await bare(project)
  const { items } = JSON.parse(await readFile(join(root, 'registry.json'), 'utf8'))

  const list = await project.shadcn('list', '@liten')
  for (const { name, type } of items)
    expect(list).toContain(`@liten/${name} (${type.replace('registry:', '')})`)

  const search = await project.shadcn('search', '@liten', '--query', 'tinted')
  expect(search).toContain('@liten/gravity-stack-tinted-demo')

  // Into a file: what a busy machine has not read from a pipe when the CLI exits is lost.
  await project.run('sh', ['-c', `'${tool('shadcn')}' view @liten/gravity-stack > shown.json`])
  const [shown] = JSON.parse(await project.read('shown.json'))
  expect(shown.files[0].content).toBe(await source())
  expect(shown.meta.version).toBe(JSON.parse(await readFile(join(root, 'package.json'), 'utf8')).version)
})

test('one command of the Setup page teaches a project the namespace', async ({ make, page }) => {
  const project = await make('namespace')
  await bare(project)
  await project.write({ 'components.json': components('app.css') })
  await page.goto('/docs/setup')
  const command = await page
    .getByText(/^npx shadcn@latest registry add @liten=/)
    .first()
    .textContent()
  await project.shadcn(...(command ?? '').trim().split(' ').slice(2))
  expect(await project.shadcn('list', '@liten')).toContain('@liten/gravity-stack')
})

test('a project that pins 0.1.0 gets that version, by way of an example and by the command of the Setup page too', async ({
  make,
  page,
}) => {
  const project = await make('pinned')
  await bare(project)
  await project.write({ 'components.json': components('app.css') })
  await page.goto('/docs/setup')
  const command =
    (await page
      .getByText(RegExp(`registry add @liten=\\S+/r/${version}/`))
      .first()
      .textContent()) ?? ''
  await project.shadcn(...command.replace(`/r/${version}/`, '/r/0.1.0/').trim().split(' ').slice(2))
  await project.shadcn('add', '@liten/gravity-stack-demo', '--yes')
  expect(await project.read(file)).toContain(`Gravity Stack 0.1.0 · ${siteUrl}/docs/gravity-stack`)
  expect(await project.shadcn('list', '@liten')).toContain('@liten/gravity-stack-demo')
})

test('a project gets an AGENTS.md with the addresses of this site, and one that has its own keeps it', async ({
  make,
}) => {
  const notes = addressed(await readFile(join(root, 'registry/agents.md'), 'utf8'))
  const project = await make('agents')
  await bare(project)
  await project.shadcn('add', item('agents'), '--yes')
  expect(await project.read('AGENTS.md')).toBe(notes)
  await project.write({ 'AGENTS.md': '# Ours\n' })
  await project.shadcn('add', item('agents'), '--yes')
  expect(await project.read('AGENTS.md')).toBe('# Ours\n')
})

test('the MCP server finds the examples by name and hands out their code', async ({ make }) => {
  const project = await make('bare')
  await bare(project)
  const child = spawn(join(root, 'node_modules/.bin/shadcn'), ['mcp'], { cwd: project.folder })
  const answers = createInterface({ input: child.stdout })[Symbol.asyncIterator]()
  const send = (message: object) => child.stdin.write(`${JSON.stringify({ jsonrpc: '2.0', ...message })}\n`)
  const ask = async (id: number, method: string, params: object) => {
    send({ id, method, params })
    for (;;) {
      const { value, done } = await answers.next()
      if (done) throw new Error('the MCP server has gone')
      const message = JSON.parse(value)
      if (message.id === id) return message.result
    }
  }
  try {
    await ask(1, 'initialize', {
      protocolVersion: '2025-06-18',
      capabilities: {},
      clientInfo: { name: 'test', version: '1' },
    })
    send({ method: 'notifications/initialized' })
    const { content } = await ask(2, 'tools/call', {
      name: 'get_item_examples_from_registries',
      arguments: { registries: ['@liten'], query: 'gravity-stack-demo' },
    })
    expect(content[0].text).toContain('<GravityStack className="h-80">')
  } finally {
    child.kill()
  }
})

test('pages anywhere may read the registry, for five minutes from their cache', async ({ request }) => {
  const response = await request.get(item('gravity-stack'))
  expect(response.headers()).toMatchObject({
    'access-control-allow-origin': '*',
    'cache-control': 'public, max-age=300',
    'content-type': expect.stringMatching(/^application\/json/),
    'content-encoding': expect.stringMatching(/gzip|br/),
  })
})

test('a dry run says what would change and changes nothing', async ({ make }) => {
  const project = await make('bare')
  await bare(project)
  const said = await project.shadcn('add', '@liten/gravity-stack', '--dry-run')
  expect(said).toContain(file)
  expect(said).toMatch(/\+ motion/)
  expect(said).toMatch(/\+ cn/)
  expect(project.has(file)).toBe(false)
  expect(JSON.parse(await project.read('package.json')).dependencies).toBeUndefined()
})

test('an example brings the component and its tokens along', async ({ make }) => {
  const project = await make('bare')
  await bare(project)
  await project.shadcn('add', '@liten/gravity-stack-elevation-demo', '--yes')
  expect(await project.read(file)).toBe(await source())
  expect(await project.read('components/gravity-stack-elevation-demo.tsx')).toBe(
    await readFile(join(root, 'registry/examples/gravity-stack-elevation-demo.tsx'), 'utf8'),
  )
  const css = await project.read('app.css')
  expect(css).toContain('--color-elevation-4: var(--elevation-4);')
  expect(css).toMatch(/--shadow-raised-2: inset calc\(1px \* var\(--light-x\)\) .* var\(--cast\);/)
  expect(css).toMatch(/"gravity-stack-chip"\] \{\s*--light-x: sin\(var\(--chip-angle, 0deg\)\);/)
  expect(css).toMatch(/\.dark \{[^}]*--elevation-4: oklch/)
})

test('every block installs into one project, beside one component, and typechecks there', async ({
  make,
}) => {
  const project = await make('bare')
  await bare(project)
  await project.write({
    'package.json': {
      name: 'bare',
      private: true,
      dependencies: { react: '^19', 'react-dom': '^19', '@types/react': '^19', '@types/react-dom': '^19' },
    },
    'tsconfig.json': {
      compilerOptions: {
        ...{ jsx: 'react-jsx', module: 'esnext', moduleResolution: 'bundler', target: 'es2023' },
        ...{ strict: true, noEmit: true, skipLibCheck: true, paths: { '@/*': ['./*'] } },
      },
    },
  })
  const { items } = JSON.parse(await readFile(join(root, 'registry.json'), 'utf8'))
  const blocks = items
    .filter(({ type }: { type: string }) => type === 'registry:block')
    .map(({ name }: { name: string }) => name)
  await project.shadcn('add', ...blocks.map((name: string) => `@liten/${name}`), '--yes')
  for (const name of blocks)
    expect(await project.read(`components/${name}.tsx`)).toBe(
      await readFile(join(root, `registry/blocks/${name}.tsx`), 'utf8'),
    )
  expect(await project.read(file)).toBe(await source())
  await project.run(tool('tsc'), [])
})

test('an older copy shows what changed, is kept unless told otherwise, and updates with --overwrite', async ({
  make,
}) => {
  const project = await make('bare')
  await bare(project)
  const older = `${await source()}// an edit of mine\n`
  await project.write({ [file]: older })

  expect(await project.shadcn('add', '@liten/gravity-stack', '--diff', file)).toMatch(
    /-\s*\/\/ an edit of mine/,
  )
  await project.shadcn('add', '@liten/gravity-stack', '--yes')
  expect(await project.read(file)).toBe(older)
  await project.shadcn('add', '@liten/gravity-stack', '--yes', '--overwrite')
  expect(await project.read(file)).toBe(await source())
})

test('from a repository an example brings the component and its tokens along, and no site is asked', async ({
  make,
}) => {
  // The repository as it is committed when the setting `repository` names it.
  const repository = await make('repository')
  const index = await freshIndex('liten/gravity-stack')
  const paths = index.items.flatMap(({ files = [] }) => files.map(({ path }: { path: string }) => path))
  const files = paths.map(async (path: string) => [path, await readFile(join(root, path), 'utf8')])
  await repository.write({ 'registry.json': index, ...Object.fromEntries(await Promise.all(files)) })
  const git = (...args: string[]) =>
    repository.run('git', ['-c', 'user.name=liten', '-c', 'user.email=liten@someone.example', ...args])
  await git('init', '--quiet')
  await git('add', '--all')
  await git('commit', '--quiet', '--message', 'All of it')

  const project = await make('bare')
  await bare(project)
  // git itself says which commit is meant, and looks for the repository on this machine.
  Object.assign(project.env, answered, {
    REPOSITORY: repository.folder,
    GIT_CONFIG_COUNT: '1',
    GIT_CONFIG_KEY_0: `url.${repository.folder}.insteadOf`,
    GIT_CONFIG_VALUE_0: 'https://github.com/liten/gravity-stack.git',
  })
  await project.shadcn('add', 'liten/gravity-stack/gravity-stack-elevation-demo', '--yes')
  expect(await project.read(file)).toBe(await committed())
  expect(project.has('components/gravity-stack-elevation-demo.tsx')).toBe(true)
  expect(await project.read('app.css')).toContain('--color-elevation-4: var(--elevation-4);')
})

test('other aliases, such as ~/, are followed in the files that arrive', async ({ make }) => {
  const project = await make('bare')
  await bare(project)
  const aliases = {
    components: '~/parts',
    utils: '~/lib/utils',
    ui: '~/parts/ui',
    lib: '~/lib',
    hooks: '~/hooks',
  }
  await project.write({
    'tsconfig.json': { compilerOptions: { paths: { '~/*': ['./*'] } } },
    'components.json': components('app.css', { aliases }),
  })
  await project.shadcn('add', item('gravity-stack-demo'), '--yes')
  expect(project.has('parts/ui/gravity-stack.tsx')).toBe(true)
  expect(await project.read('parts/gravity-stack-demo.tsx')).toContain("from '~/parts/ui/gravity-stack'")
})

test('a project without TypeScript gets plain JavaScript, which still says what version it is', async ({
  make,
}) => {
  const project = await make('bare')
  await bare(project)
  await project.write({ 'components.json': components('app.css', { rsc: false, tsx: false }) })
  await project.shadcn('add', item('gravity-stack'), '--yes')
  const added = await project.read('components/ui/gravity-stack.jsx')
  expect(added).toContain(`Gravity Stack ${version} · ${siteUrl}/docs/gravity-stack`)
  expect(added).not.toMatch(/^type |^interface /m)
})

test('in a monorepo the component goes to the package for it, where the app that asked finds it', async ({
  make,
}) => {
  const project = await make('monorepo')
  const shared = { utils: '@workspace/ui/lib/utils', ui: '@workspace/ui/components' }
  const inUi = {
    components: '@workspace/ui/components',
    lib: '@workspace/ui/lib',
    hooks: '@workspace/ui/hooks',
  }
  const inWeb = { components: '@/components', lib: '@/lib', hooks: '@/hooks' }
  const options = {
    jsx: 'react-jsx',
    module: 'esnext',
    moduleResolution: 'bundler',
    strict: true,
    noEmit: true,
  }
  const types = { '@types/react': '^19', '@types/react-dom': '^19' }
  await project.write({
    'package.json': { name: 'monorepo', private: true, workspaces: ['apps/*', 'packages/*'] },
    'packages/ui/package.json': { name: '@workspace/ui', private: true },
    'packages/ui/tsconfig.json': {
      compilerOptions: { ...options, paths: { '@workspace/ui/*': ['./src/*'] } },
    },
    'packages/ui/src/styles/globals.css': "@import 'tailwindcss';\n",
    'packages/ui/components.json': components('src/styles/globals.css', { aliases: { ...inUi, ...shared } }),
    'apps/web/package.json': {
      name: 'web',
      private: true,
      dependencies: { '@workspace/ui': '*', react: '^19', 'react-dom': '^19', ...types },
    },
    'apps/web/tsconfig.json': {
      compilerOptions: {
        ...options,
        skipLibCheck: true,
        paths: { '@/*': ['./src/*'], '@workspace/ui/*': ['../../packages/ui/src/*'] },
      },
      include: ['src'],
    },
    'apps/web/components.json': components('../../packages/ui/src/styles/globals.css', {
      aliases: { ...inWeb, ...shared },
    }),
  })
  await project.run('npm', ['install'])
  await project.shadcn('add', item('gravity-stack-demo'), '--yes', '--cwd', 'apps/web')
  expect(await project.read('packages/ui/src/components/gravity-stack.tsx')).toBe(await source())
  await project.run(tool('tsc'), ['--project', 'apps/web'])
})

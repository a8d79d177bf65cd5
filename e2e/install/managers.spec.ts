import { components, docsCode, expect, expectPile, item, test, tool, viteProject } from './project'

// npm itself is in the other tests.
const managers = [
  { name: 'pnpm', version: '12.21.0', lockfile: 'pnpm-lock.yaml' },
  { name: 'bun', version: '1.4.5', lockfile: 'bun.lock' },
]

for (const { name, version, lockfile } of managers) {
  test(`in a project of ${name}'s the CLI adds the packages with ${name}`, async ({ make, page }) => {
    const tools = await make('tools')
    await tools.write({ 'package.json': { private: true } })
    await tools.run('npm', ['install', `${name}@${version}`])
    const project = await make(name)
    project.finds(tools.path('node_modules/.bin'))
    await viteProject(project, { install: [name, 'add'] })
    expect(project.has(lockfile)).toBe(true)
    await project.shadcn('add', item('gravity-stack'), '--yes')
    expect(project.has('package-lock.json')).toBe(false)
    expect(await project.read(lockfile)).toContain('motion')

    await project.write({
      'src/topics.tsx': await docsCode('gravity-stack', { heading: 'Usage' }),
      'src/App.tsx': "export { Topics as default } from '@/topics'\n",
    })
    await project.run(name, ['run', 'build'])
    const server = await project.serve('vite', (port) => ['preview', '--port', `${port}`, '--strictPort'])
    await expectPile(page, server.url)
    await server.stop()
  })
}

// Yarn asks the registry for every platform's build of a package. A mirror that lacks some stops it at Vite's
// and Tailwind's, so this project has neither, and no browser to show it in.
test("in a project of yarn's the CLI adds the packages with yarn, and all of it typechecks", async ({
  make,
}) => {
  const tools = await make('tools')
  await tools.write({ 'package.json': { private: true } })
  await tools.run('npm', ['install', '@yarnpkg/cli-dist@4.18.1'])
  const project = await make('yarn')
  project.finds(tools.path('node_modules/.bin'))
  // Of its own accord yarn asks a registry of its own.
  const { output: registry } = await project.try('npm', ['config', 'get', 'registry'])
  project.env.YARN_NPM_REGISTRY_SERVER = registry.match(/^https?:.*$/m)?.[0] ?? ''
  await project.write({
    'package.json': {
      name: 'yarn',
      private: true,
      dependencies: { react: '^19', 'react-dom': '^19' },
      devDependencies: { '@types/react': '^19' },
    },
    'yarn.lock': '',
    '.yarnrc.yml': 'nodeLinker: node-modules\n',
    'tsconfig.json': {
      compilerOptions: {
        jsx: 'react-jsx',
        module: 'esnext',
        moduleResolution: 'bundler',
        strict: true,
        noEmit: true,
        paths: { '@/*': ['./*'] },
      },
    },
    'app.css': "@import 'tailwindcss';\n",
    'components.json': components('app.css'),
    'topics.tsx': await docsCode('gravity-stack', { heading: 'Usage' }),
  })
  await project.shadcn('add', item('gravity-stack'), '--yes')
  expect(project.has('package-lock.json')).toBe(false)
  const lockfile = await project.read('yarn.lock')
  expect(lockfile).toContain('"motion@npm:')
  expect(lockfile).toContain('"cn@npm:')
  await project.run(tool('tsc'))
})

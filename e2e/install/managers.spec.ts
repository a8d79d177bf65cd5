import { docsCode, expect, expectPile, item, test, viteProject } from './project'

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

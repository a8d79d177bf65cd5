import { siteUrl, version } from '../../site.config.mjs'
import { docsCode, expect, expectPile, item, nextProject, test, viteProject } from './project'

test('a new Vite project has a falling pile one command later', async ({ make, page }) => {
  const project = await make('vite')
  await viteProject(project)
  await project.shadcn('add', item('gravity-stack'), '--yes')

  const file = await project.read('src/components/ui/gravity-stack.tsx')
  expect(file, 'the owner reads which version it is, and where its docs are').toContain(
    `Gravity Stack ${version} · ${siteUrl}/docs/gravity-stack`,
  )
  const { dependencies } = JSON.parse(await project.read('package.json'))
  expect(Object.keys(dependencies)).toEqual(expect.arrayContaining(['cn', 'motion']))

  await project.write({
    'src/topics.tsx': await docsCode('gravity-stack', { heading: 'Usage' }),
    'src/App.tsx': "export { Topics as default } from '@/topics'\n",
  })
  await project.run('npm', ['run', 'build'])
  const server = await project.serve('vite', (port) => ['preview', '--port', `${port}`, '--strictPort'])
  await expectPile(page, server.url)
  await server.stop()
})

test('a new Next project has a falling pile one command later', async ({ make, page }) => {
  const project = await make('next')
  await nextProject(project, '--biome')
  await project.run('npm', ['install'])
  await project.shadcn('add', item('gravity-stack'), '--yes')

  expect(await project.read('components/ui/gravity-stack.tsx')).toMatch(/^'use client'/)

  await project.write({
    'app/topics.tsx': await docsCode('gravity-stack', { heading: 'Usage' }),
    'app/page.tsx': "export { Topics as default } from './topics'\n",
  })
  await project.run('npx', ['biome', 'lint', 'components'])
  await project.run('npm', ['run', 'build'])
  const server = await project.serve('next', (port) => ['start', '--port', `${port}`])
  await expectPile(page, server.url)
  await server.stop()
})

import { alive } from '../page'
import { docsCode, expect, expectPile, test, viteProject } from './project'

test('what the docs let people copy by hand works as it is pasted', async ({
  make,
  page,
  context,
  baseURL,
}) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write'], { origin: baseURL })
  await page.goto('/docs/gravity-stack')
  await alive(page)
  const copied = () => page.evaluate(() => navigator.clipboard.readText())
  await page.getByRole('tab', { name: 'Manual' }).click()
  const manual = page.getByRole('tabpanel', { name: 'Manual' })

  const command = manual.getByText(/^npm install/).first()
  await expect(command).toBeVisible()
  const [npm, ...words] = ((await command.textContent()) ?? '').trim().split(/\s+/)

  await manual.getByRole('button', { name: 'Copy the whole file' }).click()
  await expect(manual.getByRole('button', { name: 'Copied' })).toBeVisible()
  const file = await copied()

  const project = await make('manual')
  await viteProject(project)
  await project.run(npm, words)
  await project.write({
    'src/components/ui/gravity-stack.tsx': file,
    'src/topics.tsx': await docsCode('gravity-stack', { heading: 'Usage' }),
    'src/App.tsx': "export { Topics as default } from '@/topics'\n",
  })
  await project.run('npm', ['run', 'build'])
  const server = await project.serve('vite', (port) => ['preview', '--port', `${port}`, '--strictPort'])
  await expectPile(page, server.url)
  await server.stop()
})

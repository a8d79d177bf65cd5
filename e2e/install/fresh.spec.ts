import { readFile } from 'node:fs/promises'
import { join } from 'node:path'
import { root } from '../../scripts/run.mjs'
import { siteUrl, version } from '../../site.config.mjs'
import { docsCode, expect, expectPile, item, nextProject, test, viteProject } from './project'

test('a new Vite project has a falling pile one command later', async ({ make, page }) => {
  const project = await make('vite')
  await viteProject(project)
  const said = await project.shadcn('add', item('gravity-stack'), '--yes')
  const { items } = JSON.parse(await readFile(join(root, 'registry.json'), 'utf8'))
  expect(said, 'the CLI ends with how to use it').toContain(items[0].docs.replace(/http\S+/, ''))

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

test('a new Next project has a falling pile one command later, and one of neutral chips another later', async ({
  make,
  page,
}) => {
  const project = await make('next')
  await nextProject(project, '--biome')
  await project.run('npm', ['install'])
  await project.shadcn('add', item('gravity-stack'), '--yes')

  expect(await project.read('components/ui/gravity-stack.tsx')).toMatch(/^'use client'/)

  await project.write({
    'app/topics.tsx': await docsCode('gravity-stack', { heading: 'Usage' }),
    'app/page.tsx': "export { Topics as default } from './topics'\n",
    'app/neutral/page.tsx':
      "export { GravityStackElevationDemo as default } from '@/components/gravity-stack-elevation-demo'\n",
  })
  await project.shadcn('add', item('gravity-stack-elevation-demo'), '--yes')
  await project.run('npx', ['biome', 'lint', 'components'])
  await project.run('npm', ['run', 'build'])
  const server = await project.serve('next', (port) => ['start', '--port', `${port}`])
  await expectPile(page, server.url)
  await page.goto(`${server.url}/neutral`)
  await expect(page.locator('[data-slot="gravity-stack"]')).toHaveAttribute('data-state', 'resting')
  // The tokens have become utilities of the project's own: four surfaces, four shadows, each lit from above
  // on the screen, whatever angle the chip lies at: by a highlight one pixel long.
  const looks = await Promise.all(
    ['Paper', 'Plaster', 'Linen', 'Felt'].map((word) =>
      page.getByText(word, { exact: true }).evaluate((chip) => {
        const { backgroundColor, boxShadow } = getComputedStyle(chip)
        return [backgroundColor, boxShadow]
      }),
    ),
  )
  expect(new Set(looks.map(([surface]) => surface)).size).toBe(4)
  expect(new Set(looks.map(([, shadow]) => shadow)).size).toBe(4)
  // A shadow is eased into its place once the pile rests, so it is asked until it lies there.
  for (const word of ['Paper', 'Plaster', 'Linen', 'Felt'])
    await expect(async () => {
      const [x, y] = await page.getByText(word, { exact: true }).evaluate((chip) => {
        const [, x, y] = getComputedStyle(chip).boxShadow.match(/(-?[\d.]+)px (-?[\d.]+)px 0px 0px inset/)!
        const { a, b, c, d } = new DOMMatrix(getComputedStyle(chip.closest('[data-slot]')!).transform)
        return [a * +x + c * +y, b * +x + d * +y]
      })
      expect(Math.abs(x)).toBeLessThan(0.05)
      expect(y).toBeCloseTo(1)
    }).toPass()
  await server.stop()
})

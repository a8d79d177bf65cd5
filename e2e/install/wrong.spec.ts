import { readFile, rm } from 'node:fs/promises'
import { join } from 'node:path'
import { root } from '../../scripts/run.mjs'
import { siteUrl } from '../../site.config.mjs'
import {
  answered,
  components,
  docsCode,
  docsPage,
  expect,
  item,
  type Project,
  test,
  tool,
  viteProject,
} from './project'

/** The rows of the Setup page's table that speak of these words: each `…` of a row stands for anything. */
async function answersTo(said: string) {
  const rows = [...(await docsPage('setup')).matchAll(/^\| (.+?) \| (.+) \|$/gm)]
  const quotes = rows.flatMap(([, symptom]) => [...symptom.matchAll(/`([^`]+)`/g)].map(([, words]) => words))
  return quotes.filter(
    (words) => words.length > 3 && words.split('…').every((part) => said.includes(part.trim())),
  )
}

const add = (project: Project, ...what: string[]) => project.try(tool('shadcn'), ['add', ...what, '--yes'])

const bare = (project: Project, manifest: object = {}) =>
  project.write({
    'package.json': { name: 'bare', private: true, ...manifest },
    'tsconfig.json': { compilerOptions: { paths: { '@/*': ['./*'] } } },
    'app.css': "@import 'tailwindcss';\n",
    'components.json': components('app.css', { registries: { '@liten': `${siteUrl}/r/{name}.json` } }),
  })

test.describe('the Setup page answers under the words of the error', () => {
  test('when the name is misspelt', async ({ make }) => {
    const project = await make('misspelt')
    await bare(project)
    const { code, output } = await add(project, '@liten/gravity-stak')
    expect(code).toBe(1)
    expect(await answersTo(output)).toContain('The item at … was not found')
  })

  test('when the registry is out of reach', async ({ make }) => {
    const project = await make('offline')
    await bare(project)
    const { code, output } = await add(project, 'http://localhost:9/r/gravity-stack.json')
    expect(code).toBe(1)
    expect(await answersTo(output)).toContain('Request to … failed')
  })

  test('when the project was never set up for shadcn', async ({ make }) => {
    const project = await make('no-components-json')
    await project.write({ 'package.json': { name: 'new', private: true } })
    const { output } = await add(project, item('gravity-stack'))
    expect(await answersTo(output)).toContain('You need to create a components.json file')
  })

  test('when the project has neither Tailwind nor the alias: init stops', async ({ make }) => {
    const project = await make('no-tailwind')
    await project.run(tool('create-vite'), ['.', '--template', 'react-ts', '--no-interactive'])
    const { code, output } = await project.try(tool('shadcn'), ['init', '--defaults'], answered)
    expect(code).toBe(1)
    expect(project.has('components.json')).toBe(false)
    const answers = await answersTo(output)
    expect(answers).toContain('No Tailwind CSS configuration found at …')
    expect(answers).toContain('Could not find valid path aliases or package imports for init')
  })

  test('when the file is there and Tailwind is not: the words lie one over the other, and the console says why', async ({
    make,
    page,
  }) => {
    const project = await make('forced')
    await viteProject(project, { tailwind: false })
    // The CLI has nothing against it once there is a components.json, and the build neither.
    await project.shadcn('add', item('gravity-stack'), '--yes')
    await project.write({
      'src/topics.tsx': await docsCode('gravity-stack', { heading: 'Usage' }),
      'src/App.tsx': "export { Topics as default } from '@/topics'\n",
    })
    await project.run('npm', ['run', 'build'])
    const said: string[] = []
    page.on('console', (message) => said.push(message.text()))
    const server = await project.serve('vite', (port) => ['--port', `${port}`, '--strictPort'])
    await page.goto(server.url)
    await expect(page.locator('[data-slot="gravity-stack"]')).toHaveAttribute('data-state', 'resting')
    const heap = await page.locator('[data-slot="gravity-stack-chip"]').evaluateAll((chips) => {
      const boxes = chips.map((chip) => chip.getBoundingClientRect())
      return Math.max(...boxes.map(({ top }) => top)) - Math.min(...boxes.map(({ bottom }) => bottom))
    })
    expect(heap, 'px between the highest and the lowest word').toBeLessThan(0)
    expect(await answersTo(said.join('\n'))).toContain('GravityStack: Tailwind has made no styles for it')
    await server.stop()
  })

  test('when there is no tsconfig.json', async ({ make }) => {
    const project = await make('no-tsconfig')
    await bare(project)
    await rm(project.path('tsconfig.json'))
    const { code, output } = await add(project, item('gravity-stack'))
    expect(code).toBe(1)
    expect(await answersTo(output)).toContain("Couldn't find tsconfig.json")
  })

  test('when the alias is missing: the file lands in a folder named @', async ({ make }) => {
    const project = await make('no-alias')
    await bare(project)
    await project.write({ 'tsconfig.json': { compilerOptions: {} } })
    const { output } = await add(project, item('gravity-stack'))
    expect(project.has('@/components/ui/gravity-stack.tsx')).toBe(true)
    expect(await answersTo(output)).toContain('- @/components/ui/gravity-stack.tsx')
  })

  test('when the stylesheet is not where components.json says', async ({ make }) => {
    const project = await make('no-css')
    await bare(project)
    await rm(project.path('app.css'))
    const { code, output } = await add(project, item('elevation'))
    expect(code).toBe(1)
    expect(await answersTo(output)).toContain('ENOENT: no such file or directory')
  })

  test('when React is older than 18', async ({ make }) => {
    const project = await make('react-17')
    await bare(project, { dependencies: { react: '17.0.2' } })
    await project.run('npm', ['install'])
    const { code, output } = await add(project, item('gravity-stack'))
    expect(code).toBe(1)
    expect(await answersTo(output)).toContain('ERESOLVE could not resolve')
  })

  test('when an older copy is in the way', async ({ make }) => {
    const project = await make('older-copy')
    await bare(project)
    await project.write({ 'components/ui/gravity-stack.tsx': '// mine\n' })
    const { output } = await add(project, item('gravity-stack'))
    expect(await project.read('components/ui/gravity-stack.tsx')).toBe('// mine\n')
    expect(await answersTo(output)).toContain('already exists. Would you like to overwrite?')
  })

  test('when the alias or the packages are missing', async ({ make }) => {
    const project = await make('by-hand')
    await project.write({
      'tsconfig.json': {
        compilerOptions: { jsx: 'react-jsx', moduleResolution: 'bundler', module: 'esnext' },
      },
      'components/ui/gravity-stack.tsx': await readFile(
        join(root, 'components/ui/gravity-stack.tsx'),
        'utf8',
      ),
      'topics.tsx': await docsCode('gravity-stack', { heading: 'Usage' }),
    })
    const { code, output } = await project.try(tool('tsc'), ['--noEmit'])
    expect(code).not.toBe(0)
    const answers = await answersTo(output)
    expect(answers).toContain("Cannot find module '@/components/…'")
    expect(answers).toContain("Cannot find module 'cn'")
    expect(answers).toContain("Cannot find module 'motion'")
  })
})

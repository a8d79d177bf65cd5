import { execFileSync } from 'node:child_process'
import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import postcss from 'postcss'
import { createElement, type FunctionComponent } from 'react'
import { renderToStaticMarkup } from 'react-dom/server'
import { expect, test } from 'vitest'
import { heroCode } from '@/lib/hero-code'
import { codeOf, defaults } from '@/lib/playground'

const root = process.cwd()
const folder = join(root, '.contentlayer/samples')

const usualImports = `import { useRef } from 'react'
import { GravityStack, type GravityStackActions } from '@/components/ui/gravity-stack'
`

/** A sample that is no module of its own, such as a bit of JSX, in the module its reader would put it in. */
function asModule(code: string) {
  if (/^(export|'use client')/m.test(code)) return code
  const ownImports = code.match(/^import .*\n/gm)
  const body = code.replace(/^import .*\n/gm, '')
  const at = body.search(/^</m)
  return `${ownImports?.join('') ?? usualImports}
const words = ['one', 'two']
const chips = words.map((word) => <span key={word}>{word}</span>)

export function Sample() {
  ${body.slice(0, at)}
  return <>${body.slice(at)}</>
}
`
}

const blocks = (lang: string, text: string) =>
  [...text.matchAll(new RegExp(`^\`\`\`${lang}(?: [^\\n]*)?\\n([\\s\\S]*?)^\`\`\`$`, 'gm'))].map(
    ([, code]) => code,
  )

const fences = (name: string, text: string) =>
  blocks('tsx', text).map((code, index) => [`${name}-${index + 1}`, code] as const)

const pages = readdirSync('content/docs').map((file) => [
  file,
  readFileSync(join('content/docs', file), 'utf8'),
])

const samples = new Map([
  ...fences('readme', readFileSync('README.md', 'utf8')),
  ...pages.flatMap(([file, text]) => fences(file.replace('.mdx', ''), text)),
  ['home', heroCode({ neutral: false, heavier: false, bouncier: false })],
  ['home-set', heroCode({ neutral: true, heavier: true, bouncier: true })],
  ['home-drop', heroCode({ neutral: false, heavier: true, bouncier: false }, 'drop')],
  ['home-shake', heroCode({ neutral: true, heavier: false, bouncier: true }, 'shake')],
  ['playground', codeOf(defaults)],
  ['playground-mixed', codeOf({ ...defaults, shape: 'mixed', words: "it's, \\, `$(x)`", gravity: 900 })],
  ['playground-obstacle', codeOf({ ...defaults, direction: 150, ceiling: true, push: 44, obstacle: true })],
  ['playground-ink', codeOf({ ...defaults, look: 'ink', interactive: false })],
])

rmSync(folder, { recursive: true, force: true })
mkdirSync(folder, { recursive: true })
for (const [name, code] of samples) writeFileSync(join(folder, `${name}.tsx`), asModule(code))
writeFileSync(
  join(folder, 'tsconfig.json'),
  JSON.stringify({
    extends: '../../tsconfig.json',
    compilerOptions: { incremental: false, paths: { '@/*': ['../../*'] } },
    include: ['*.tsx', '../../registry/examples/*.tsx', '../../registry/blocks/*.tsx'],
  }),
)

test('every code sample on the site and in the README typechecks', () => {
  let complaints = ''
  try {
    execFileSync(join(root, 'node_modules/.bin/tsc'), ['-p', folder], { encoding: 'utf8' })
  } catch (error) {
    complaints = (error as { stdout: string }).stdout
  }
  expect(complaints).toBe('')
}, 60_000)

for (const name of samples.keys()) {
  test(`the code sample ${name} renders`, async () => {
    const module: Record<string, unknown> = await import(/* @vite-ignore */ join(folder, `${name}.tsx`))
    const components = Object.values(module).filter((value) => typeof value === 'function')
    expect(components).not.toHaveLength(0)
    for (const component of components) {
      const props = { words: ['one', 'two'], children: 'words' }
      expect(renderToStaticMarkup(createElement(component as FunctionComponent<object>, props))).toContain(
        '<',
      )
    }
  })
}

// Those of Setup are pasted into new projects by e2e/install, too.
test('every stylesheet and every JSON on the site is one', () => {
  const css = pages.flatMap(([, text]) => blocks('css', text))
  const json = pages.flatMap(([, text]) => blocks('json', text))
  expect(css.length * json.length).toBeGreaterThan(0)
  for (const code of css) expect(postcss.parse(code).nodes).not.toHaveLength(0)
  for (const code of json) expect(JSON.parse(code)).toBeTypeOf('object')
})

test('code on the site is in a language that a test knows', () => {
  const langs = pages.flatMap(([, text]) => [...text.matchAll(/^```(\w+)[^\n]*\n[\s\S]*?^```$/gm)])
  expect([...new Set(langs.map(([, lang]) => lang))].sort()).toEqual(['bash', 'css', 'json', 'ts', 'tsx'])
})

test('the recipe of a raised chip on the elevation page is the one of its token', () => {
  const [recipe] = blocks('css', readFileSync('content/docs/elevation.mdx', 'utf8'))
  const shadow = recipe
    .match(/box-shadow:([^;]+);/)![1]
    .replace(/\s+/g, ' ')
    .trim()
  const { items } = JSON.parse(readFileSync('registry.json', 'utf8'))
  const tokens = items.find(({ name }: { name: string }) => name === 'elevation').cssVars.theme
  expect(shadow).toBe(tokens['shadow-raised-3'])
})

const examples = readdirSync('registry/examples').map((file) => file.replace('.tsx', ''))

test('every example of the registry is on the site', () => {
  const page = readFileSync('content/docs/gravity-stack.mdx', 'utf8')
  for (const name of examples) expect(page).toContain(`<ComponentPreview name="${name}" />`)
})

for (const name of examples) {
  test(`the example ${name} renders its chips on the server`, async () => {
    const module = await import(`@/registry/examples/${name}.tsx`)
    for (const Demo of Object.values<FunctionComponent>(module)) {
      expect(renderToStaticMarkup(createElement(Demo))).toContain('data-slot="gravity-stack-chip"')
    }
  })
}

for (const file of readdirSync('registry/blocks')) {
  test(`the block ${file} renders its chips on the server`, async () => {
    const module = await import(`@/registry/blocks/${file.replace('.tsx', '')}.tsx`)
    for (const Block of Object.values<FunctionComponent>(module))
      expect(renderToStaticMarkup(createElement(Block))).toContain('data-slot="gravity-stack-chip"')
  })
}

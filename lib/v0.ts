import 'server-only'
import registry from '@/registry.json'
import { blocks } from './blocks'
import { blockSource, componentFile, componentSource, exampleSource } from './source'

const component = registry.items.find(({ name }) => name === 'gravity-stack')!

/** Items that v0 can show, and the module that its page shows: a bare component would be an empty page. */
const shown: Record<string, { path: string; source: () => string }> = {
  'gravity-stack': {
    path: 'components/gravity-stack-demo.tsx',
    source: () => exampleSource('gravity-stack-demo'),
  },
  ...Object.fromEntries(
    blocks.map(({ name }) => [name, { path: `components/${name}.tsx`, source: () => blockSource(name) }]),
  ),
}

export const v0Names = Object.keys(shown)

/**
 * An item as v0 takes it. It reads no stylesheet and no tokens of an item, and follows no names to others, so
 * the component stands in it, and a page that shows it.
 */
export function v0Item(name: string) {
  const { path, source } = shown[name]
  const { title, description } = registry.items.find((item) => item.name === name)!
  const code = source()
  const exported = code.match(/^export function (\w+)/m)![1]
  const page = `import { ${exported} } from '@/${path.replace('.tsx', '')}'

export default function Page() {
  return <${exported} />
}
`
  return {
    $schema: 'https://ui.shadcn.com/schema/registry-item.json',
    name,
    type: 'registry:block',
    title,
    description,
    dependencies: component.dependencies,
    files: [
      { path: 'app/page.tsx', type: 'registry:page', target: 'app/page.tsx', content: page },
      { path, type: 'registry:component', target: path, content: code },
      { path: componentFile, type: 'registry:ui', target: componentFile, content: componentSource() },
    ],
  }
}

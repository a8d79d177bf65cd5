import 'server-only'
import registry from '@/registry.json'
import { addressed, siteUrl } from '@/site.config.mjs'
import { findDoc } from './docs'
import { readActions, readProps } from './props'
import { agentsSource, componentFile } from './source'

const itemOf = (name: string) => {
  const item = registry.items.find((item) => item.name === name)
  if (!item) throw new Error(`The registry has no item ${name}`)
  return item
}

const address = (name: string) => `${siteUrl}/r/${name}.json`

/** What to install, and where from. */
const install = (name: string) => `npx shadcn@latest add ${address(name)}`

function componentPrompt() {
  const page = findDoc('gravity-stack')!.body.raw
  const usage = page.match(/\n## Usage\n\n(```tsx\n[\s\S]*?```)/)?.[1]
  if (!usage) throw new Error('The page of the component has no code under Usage')
  const { dependencies = [] } = itemOf('gravity-stack')
  const rules = agentsSource()
    .match(/^- .+$/gm)!
    .join('\n')
  return `Add the React component Gravity Stack to this project, then use it where I say.

${itemOf('gravity-stack').description}

## Install

Run \`${install('gravity-stack')}\`. It writes one file, ${componentFile} (or the project's own folder for it), and installs ${dependencies.join(' and ')}.
It needs React 18.3 or newer, Tailwind CSS 4 and the alias @/. If the project has no components.json, install ${dependencies.join(' and ')}, and save
${siteUrl}/source/gravity-stack.tsx.txt as ${componentFile}. Do not change the file.

## Use

${usage}

${rules}

## Props of GravityStack

${readProps()
  .map(({ name, type, range, fallback, description }) => {
    const facts = [type, range, fallback && `default ${fallback}`].filter(Boolean).join(', ')
    return `- ${name} (${facts}): ${description}`
  })
  .join('\n')}

Every other prop of a div is passed on to the stage.

## Actions that actionsRef hands out

${readActions()
  .map(({ name, description }) => `- ${name}(): ${description}`)
  .join('\n')}

More, in Markdown: ${siteUrl}/docs/gravity-stack.md and ${siteUrl}/docs/recipes.md
`
}

/** A text for a coding assistant that installs an item of the registry and says how to use it. */
export function promptOf(name: string): string {
  if (name === 'gravity-stack') return componentPrompt()
  const { title, description, docs = '' } = itemOf(name)
  return `Add ${title} to this project, then use it where I say.

${description}

Run \`${install(name)}\`. ${addressed(docs)}
`
}

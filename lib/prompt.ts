import 'server-only'
import registry from '@/registry.json'
import { addressed, siteUrl } from '@/site.config.mjs'
import { findDoc } from './docs'
import { readActions, readProps } from './props'
import { componentFile } from './source'

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
  return `Add the React component Gravity Stack to this project, then use it where I say.

${itemOf('gravity-stack').description}

## Install

Run \`${install('gravity-stack')}\`. It writes one file, ${componentFile} (or the project's own folder for it), and installs ${dependencies.join(' and ')}.
It needs React 18.3 or newer, Tailwind CSS 4 and the alias @/. If the project has no components.json, install ${dependencies.join(' and ')}, and save
${siteUrl}/source/gravity-stack.tsx.txt as ${componentFile}. Do not change the file.

## Use

${usage}

- Give the stage a height, such as className="h-80", with room for all chips at the narrowest width.
- Each direct child is one chip. It collides as the box, card, pill or disc that its own classes draw, so give it padding, a background and a radius.
- Give each child of a list a key. Added children drop in, removed ones leave, and the others stay where they lie.
- Chips may be links, buttons and fields: a press is theirs, a drag tosses the chip.
- Put 'use client' at the top of a file that passes onSettle or actionsRef, or that holds the chips in state.
- Chips lie at an angle: words that must be read stand somewhere else too.
- Reduced motion, print and pages without script are taken care of: the chips stand upright in a row.

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

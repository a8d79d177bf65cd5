import 'server-only'
import type { Doc } from 'contentlayer/generated'
import { siteUrl } from '@/site.config.mjs'
import { readActions, readProps } from './props'
import { changelog, exampleSource } from './source'

const fence = (lang: string, code: string, title?: string) =>
  `\`\`\`${lang}${title ? ` title="${title}"` : ''}\n${code.trimEnd()}\n\`\`\``

/** What each component of a page becomes in Markdown; '' for what only a browser can show. */
const parts: Record<string, (attributes: Record<string, string>) => string> = {
  ActionsTable: () =>
    [
      '| Action | What it does |',
      '| --- | --- |',
      ...readActions().map(({ name, description }) => `| \`${name}()\` | ${description} |`),
    ].join('\n'),
  AddNamespace: () => fence('bash', `npx shadcn@latest registry add @liten=${siteUrl}/r/{name}.json`),
  AddCommand: ({ name }) => fence('bash', `npx shadcn@latest add ${siteUrl}/r/${name}.json`),
  Changelog: changelog,
  Command: ({ add, run }) => fence('bash', add ? `npm install ${add}` : `npx ${run}`),
  ComponentPreview: ({ name }) => fence('tsx', exampleSource(name), `${name}.tsx`),
  ComponentSource: () => `The whole file: ${siteUrl}/source/gravity-stack.tsx.txt`,
  ElevationLadder: () => '',
  Install: () => '',
  InstallWay: ({ of }) => (of === 'cli' ? 'With the CLI:' : 'By hand:'),
  HardScenesTable: () => `The table of figures is on the page: ${siteUrl}/docs/stability`,
  ScenesTable: () => `The table of figures is on the page: ${siteUrl}/docs/stability`,
  PropsTable: () => {
    const cell = (text: string) => text.replaceAll('|', '\\|')
    const rows = readProps().map(
      (prop) =>
        `| \`${prop.name}\` | \`${cell(prop.type)}\` | ${prop.fallback ? `\`${prop.fallback}\`` : '–'} | ${cell(prop.description)} |`,
    )
    return ['| Prop | Type | Default | What it does |', '| --- | --- | --- | --- |', ...rows].join('\n')
  },
}

/** A page of the docs as plain Markdown. Throws on a component that `parts` doesn't know. */
export function docMarkdown(doc: Doc): string {
  const blocks = doc.body.raw.split(/(^```[\s\S]*?^```$)/m).map((block) => {
    if (block.startsWith('```')) return block
    return block
      .replace(/^<([A-Z]\w*)([^>]*?)\/?>$/gm, (_, name: string, text: string) => {
        if (name.endsWith('Figure')) return ''
        const part = parts[name]
        if (!part) throw new Error(`lib/markdown.ts has no Markdown for <${name}>, used in ${doc.slug}.mdx`)
        return part(
          Object.fromEntries([...text.matchAll(/(\w+)="([^"]*)"/g)].map(([, key, value]) => [key, value])),
        )
      })
      .replace(/^<\/[A-Z]\w*>$/gm, '')
      .replace(
        /\]\(\/docs\/([\w-]+)(#[^)]*)?\)/g,
        (_, slug, hash = '') => `](${siteUrl}/docs/${slug}.md${hash})`,
      )
      .replace(/\]\(\//g, `](${siteUrl}/`)
  })
  const body = blocks
    .join('')
    .replace(/\n{3,}/g, '\n\n')
    .trim()
  return `# ${doc.title}\n\n> ${doc.description}\n\n${body}\n`
}

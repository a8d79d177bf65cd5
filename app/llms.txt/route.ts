import { navigation } from '@/lib/docs'
import { siteUrl } from '@/site.config.mjs'

export const dynamic = 'force-static'

export function GET() {
  const pages = navigation
    .flatMap((section) => section.pages)
    .map(({ title, href, description }) => `- [${title}](${siteUrl}${href}.md): ${description}`)
  return new Response(`# Gravity Stack

> A React component whose children drop in, tumble and settle into a pile that people can grab and toss. One file, its own rigid-body solver, added with the shadcn CLI or by copying.

Add it: \`npx shadcn@latest add ${siteUrl}/r/gravity-stack.json\`

## Docs

${pages.join('\n')}

## Optional

- [Everything in one file](${siteUrl}/llms-full.txt): all pages and the component's source
- [The component's source](${siteUrl}/source/gravity-stack.tsx.txt)
- [The registry](${siteUrl}/r/registry.json)
`)
}

import { evaluate } from '@mdx-js/mdx'
import type { ComponentProps, ComponentType } from 'react'
import * as runtime from 'react/jsx-runtime'
import rehypePrettyCode from 'rehype-pretty-code'
import rehypeSlug from 'rehype-slug'
import { codeTheme } from '@/lib/code-theme'
import { changelog } from '@/lib/source'
import { rehypeTypeset } from '@/lib/typeset'

/** CHANGELOG.md without its title, which is the page's. */
export async function Changelog({ components }: { components: Record<string, ComponentType<never>> }) {
  const { default: Content } = await evaluate(changelog(), {
    ...(runtime as Parameters<typeof evaluate>[1]),
    format: 'md',
    rehypePlugins: [
      rehypeSlug,
      rehypeTypeset,
      [rehypePrettyCode, { theme: codeTheme, keepBackground: false, grid: false }],
    ],
  })
  return (
    <div className="prose">
      <Content components={components as ComponentProps<typeof Content>['components']} />
    </div>
  )
}

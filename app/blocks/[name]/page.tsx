import type { Metadata } from 'next'
import type { ComponentType } from 'react'
import { blocks } from '@/lib/blocks'

const modules: Record<string, () => Promise<Record<string, ComponentType>>> = {
  'gravity-hero': () => import('@/registry/blocks/gravity-hero'),
  'gravity-not-found': () => import('@/registry/blocks/gravity-not-found'),
  'gravity-footer': () => import('@/registry/blocks/gravity-footer'),
  'gravity-skills': () => import('@/registry/blocks/gravity-skills'),
  'gravity-logos': () => import('@/registry/blocks/gravity-logos'),
  'gravity-newsletter': () => import('@/registry/blocks/gravity-newsletter'),
  'gravity-filters': () => import('@/registry/blocks/gravity-filters'),
  'gravity-roles': () => import('@/registry/blocks/gravity-roles'),
  'gravity-testimonials': () => import('@/registry/blocks/gravity-testimonials'),
  'gravity-tech-stack': () => import('@/registry/blocks/gravity-tech-stack'),
  'gravity-reactions': () => import('@/registry/blocks/gravity-reactions'),
  'gravity-interests': () => import('@/registry/blocks/gravity-interests'),
}

export const dynamicParams = false
export const generateStaticParams = () => blocks.map(({ name }) => ({ name }))

export async function generateMetadata({ params }: PageProps<'/blocks/[name]'>): Promise<Metadata> {
  const { name } = await params
  const { title, description } = blocks.find((block) => block.name === name)!
  return { title: `${title}, a block`, description, robots: { index: false } }
}

/** In a frame the theme is that of the page around it. Links are examples, and lead nowhere. */
const script = `(() => {
  if (parent !== window) {
    const around = parent.document.documentElement
    const follow = () => document.documentElement.classList.toggle('dark', around.classList.contains('dark'))
    follow()
    new MutationObserver(follow).observe(around, { attributeFilter: ['class'] })
  }
  for (const type of ['click', 'auxclick'])
    addEventListener(type, (event) => event.target.closest('a') && event.preventDefault())
})()`

/** A block alone in its page, as it would stand in a page of its reader's. */
export default async function BlockPage({ params }: PageProps<'/blocks/[name]'>) {
  const [Block] = Object.values(await modules[(await params).name]())
  return (
    <div id="content" className="flex min-h-svh flex-col *:flex-1">
      <Block />
      {/* biome-ignore lint/security/noDangerouslySetInnerHtml: a constant of ours */}
      <script dangerouslySetInnerHTML={{ __html: script }} />
    </div>
  )
}

import { allDocs, type Doc } from 'contentlayer/generated'

const sections = ['Start', 'Component', 'Ideas', 'Evidence'] as const

/** Every page of the docs in reading order. */
export const docs = allDocs.toSorted((a, b) => a.order - b.order)

/** Pages that are not Markdown but belong among those that are. */
const others = [
  {
    section: 'Component',
    title: 'Blocks',
    href: '/blocks',
    description: 'Parts of a page that you can ship as they are: footers, forms, walls of logos and more.',
  },
  {
    section: 'Component',
    title: 'Playground',
    href: '/playground',
    description:
      'Gravity, bounce, friction and more to tune, slow motion and single steps, and the code for your settings.',
  },
  {
    section: 'Evidence',
    title: 'Benchmarks',
    href: '/benchmarks',
    description: 'Run time against error, beside six other engines, scene by scene, with the raw data.',
  },
]

/** The way through the docs, section by section; previous and next follow it. */
export const navigation = sections.map((title) => ({
  title,
  pages: [
    ...docs
      .filter((doc) => doc.section === title)
      .map(({ title, slug, description }) => ({ title, href: `/docs/${slug}`, description })),
    ...others.filter((page) => page.section === title),
  ],
}))

const order = navigation.flatMap((section) => section.pages)

export function neighbours(path: string) {
  const index = order.findIndex((page) => page.href === path)
  return { previous: order[index - 1], next: order[index + 1] }
}

export const findDoc = (slug: string): Doc | undefined => docs.find((doc) => doc.slug === slug)

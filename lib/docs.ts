import { allDocs, type Doc } from 'contentlayer/generated'

const sections = ['Start', 'Component', 'Ideas', 'Evidence'] as const

/** Every page of the docs in reading order. */
export const docs = allDocs.toSorted((a, b) => a.order - b.order)

/** Pages that are not Markdown but belong among those that are. */
const others = [
  {
    section: 'Component',
    title: 'Playground',
    href: '/playground',
    description:
      'Every prop under your fingers, slow motion and single steps, and the code that makes the pile.',
  },
  {
    section: 'Evidence',
    title: 'Benchmarks',
    href: '/benchmarks',
    description: 'Run time against error, beside every engine, scene by scene, with the raw data.',
  },
]

export const navigation = sections.map((title) => ({
  title,
  pages: [
    ...docs
      .filter((doc) => doc.section === title)
      .map((doc) => ({ ...link(doc), description: doc.description })),
    ...others.filter((page) => page.section === title),
  ],
}))

export type Heading = { depth: number; text: string; id: string }

export function link(doc: Doc) {
  return { title: doc.title, href: `/docs/${doc.slug}` }
}

export function findDoc(slug: string) {
  const index = docs.findIndex((doc) => doc.slug === slug)
  return { doc: docs[index], previous: docs[index - 1], next: docs[index + 1] }
}

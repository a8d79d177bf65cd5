import { allDocs, type Doc } from 'contentlayer/generated'

const sections = ['Start', 'Component', 'Ideas', 'Evidence'] as const

/** Every page of the docs in reading order. */
export const docs = allDocs.toSorted((a, b) => a.order - b.order)

export const navigation = sections
  .map((title) => ({ title, pages: docs.filter((doc) => doc.section === title).map(link) }))
  .filter((section) => section.pages.length > 0)

export type Heading = { depth: number; text: string; id: string }

export function link(doc: Doc) {
  return { title: doc.title, href: `/docs/${doc.slug}` }
}

export function findDoc(slug: string) {
  const index = docs.findIndex((doc) => doc.slug === slug)
  return { doc: docs[index], previous: docs[index - 1], next: docs[index + 1] }
}

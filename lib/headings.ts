import GithubSlugger from 'github-slugger'
import { typeset } from './typeset'

export type Heading = { depth: number; text: string; id: string }

/** The headings of the second level and below, with the ids that rehype-slug gives them. */
export function headingsOf(markdown: string): Heading[] {
  const slugger = new GithubSlugger()
  const prose = markdown.replace(/^```[\s\S]*?^```/gm, '')
  return [...prose.matchAll(/^(#{2,3}) (.+)$/gm)].map(([, marks, words]) => {
    const text = words.replace(/[`*]/g, '').trim()
    return { depth: marks.length, text: typeset(text), id: slugger.slug(text) }
  })
}

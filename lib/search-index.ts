import 'server-only'
import { headings as benchmarkHeadings } from '@/app/benchmarks/headings'
import registry from '@/registry.json'
import { blocks } from './blocks'
import { docs, navigation } from './docs'
import { headingsOf } from './headings'
import { pitch } from './home'
import { readActions, readProps } from './props'
import type { Entry } from './search'
import { changelog } from './source'
import { typeset } from './typeset'

/** What Markdown says, without its marks. */
const wordsIn = (markdown: string) =>
  typeset(
    markdown
      .replace(/^```[\s\S]*?^```/gm, ' ')
      .replace(/<\/?[A-Z][^>]*>/g, ' ')
      .replace(/^\|[-| ]+\|$/gm, ' ')
      .replace(/\[([^\]]+)\]\([^)]*\)/g, '$1')
      .replace(/[`*]|^#+ |^- /gm, '')
      .replace(/\s*\|\s*/g, ' ')
      .replace(/\s+/g, ' ')
      .trim(),
  )

/** A page's Markdown in pieces: the text before its first heading, and each heading with its text. */
function sectionsOf(markdown: string) {
  const [before, ...parts] = markdown.split(/^(?=#{2,3} )/m)
  const headings = headingsOf(markdown)
  if (headings.length !== parts.length)
    throw new Error('A code block of a page has a line that begins with ##')
  return {
    before,
    sections: headings.map((heading, index) => ({ ...heading, body: parts[index].replace(/^.*\n/, '') })),
  }
}

/** A link to words on a page, for browsers that scroll to them; the others go to the heading. */
const at = (path: string, id: string, words: string) =>
  `${path}#${id}:~:text=${encodeURIComponent(words).replaceAll('-', '%2D')}`

/** Rows of the tables of Setup whose first cell is what someone sees. */
const errorsIn = (path: string, page: string, id: string, body: string): Entry[] =>
  body.includes('| What you see |')
    ? [...body.matchAll(/^\| (.+?) \| (.+) \|$/gm)]
        .filter(([, seen]) => seen !== 'What you see' && !/^-+$/.test(seen))
        .map(([, seen, meaning]) => ({
          kind: 'Error message' as const,
          title: wordsIn(seen),
          page,
          href: at(path, id, seen.match(/`([^`]+)`/)?.[1] ?? wordsIn(seen)),
          text: wordsIn(meaning),
        }))
    : []

function entriesOf({ slug, title: page, description, body }: (typeof docs)[number]): Entry[] {
  const path = `/docs/${slug}`
  const { before, sections } = sectionsOf(body.raw.replace('<Changelog />', changelog))
  return [
    { kind: 'Page', title: page, page, href: path, text: `${description} ${wordsIn(before)}` },
    ...sections.flatMap(({ id, text: title, depth, body }): Entry[] => {
      const example = registry.items.find(({ name }) => body.includes(`<ComponentPreview name="${name}" />`))
      const kind = example ? 'Example' : slug === 'recipes' && depth === 2 ? 'Recipe' : 'Section'
      const errors = errorsIn(path, page, id, body)
      // What an error says is an entry of its own.
      const words = errors.length > 0 ? '' : wordsIn(body)
      const text = [example?.description, words].filter(Boolean).join(' ')
      return [{ kind, title, page, href: `${path}#${id}`, text }, ...errors]
    }),
  ]
}

/** Everything on the site that can be found, in the order of the navigation. */
export function searchIndex(): Entry[] {
  const component = docs.find(({ slug }) => slug === 'gravity-stack')!
  const reference = { page: component.title, path: `/docs/${component.slug}` }
  return [
    { kind: 'Page', title: 'Home', page: 'Home', href: '/', text: pitch.lead },
    { kind: 'Page', title: 'Docs', page: 'Docs', href: '/docs', text: 'All pages of the docs.' },
    ...navigation
      .flatMap(({ pages }) => pages)
      .filter(({ href }) => !href.startsWith('/docs/'))
      .map(
        ({ title, href, description }): Entry => ({
          kind: 'Page',
          title,
          page: title,
          href,
          text: description,
        }),
      ),
    ...docs.flatMap(entriesOf),
    ...blocks.map(({ name, title, description }): Entry => {
      return { kind: 'Block', title, page: 'Blocks', href: `/blocks#${name}`, text: description }
    }),
    ...benchmarkHeadings.map(({ id, text }): Entry => {
      return { kind: 'Section', title: text, page: 'Benchmarks', href: `/benchmarks#${id}`, text: '' }
    }),
    ...readProps().map(({ name, type, description }): Entry => {
      const { page, path } = reference
      return {
        kind: 'Prop',
        title: name,
        page,
        href: `${path}#prop-${name}`,
        text: wordsIn(`${type}. ${description}`),
      }
    }),
    ...readActions().map(({ name, description }): Entry => {
      const { page, path } = reference
      return {
        kind: 'Action',
        title: `${name}()`,
        page,
        href: `${path}#action-${name}`,
        text: wordsIn(description),
      }
    }),
  ]
}

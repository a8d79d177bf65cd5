import { defineDocumentType, makeSource } from 'contentlayer2/source-files'
import GithubSlugger from 'github-slugger'
import rehypePrettyCode from 'rehype-pretty-code'
import rehypeSlug from 'rehype-slug'
import remarkGfm from 'remark-gfm'
import { codeTheme } from './lib/code-theme'
import { rehypeTableNames } from './lib/table-names'
import { rehypeTypeset, typeset } from './lib/typeset'

export const Doc = defineDocumentType(() => ({
  name: 'Doc',
  filePathPattern: 'docs/*.mdx',
  contentType: 'mdx',
  fields: {
    title: { type: 'string', required: true },
    description: { type: 'string', required: true },
    section: { type: 'enum', options: ['Start', 'Component', 'Ideas', 'Evidence'], required: true },
    order: { type: 'number', required: true },
  },
  computedFields: {
    slug: { type: 'string', resolve: (doc) => doc._raw.sourceFileName.replace(/\.mdx$/, '') },
    headings: { type: 'json', resolve: (doc) => headings(doc.body.raw) },
  },
}))

/** The headings of the second level and below, with the ids that rehype-slug will give them. */
function headings(markdown: string) {
  const slugger = new GithubSlugger()
  const prose = markdown.replace(/^```[\s\S]*?^```/gm, '')
  return [...prose.matchAll(/^(#{2,3}) (.+)$/gm)].map(([, marks, words]) => {
    const text = words.replace(/[`*]/g, '').trim()
    return { depth: marks.length, text: typeset(text), id: slugger.slug(text) }
  })
}

export default makeSource({
  contentDirPath: 'content',
  documentTypes: [Doc],
  disableImportAliasWarning: true,
  onMissingOrIncompatibleData: 'fail',
  onUnknownDocuments: 'fail',
  mdx: {
    remarkPlugins: [remarkGfm],
    rehypePlugins: [
      rehypeSlug,
      rehypeTypeset,
      rehypeTableNames,
      [rehypePrettyCode, { theme: codeTheme, keepBackground: false, grid: false }],
    ],
  },
})

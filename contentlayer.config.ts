import { defineDocumentType, makeSource } from 'contentlayer2/source-files'
import rehypePrettyCode from 'rehype-pretty-code'
import rehypeSlug from 'rehype-slug'
import remarkGfm from 'remark-gfm'
import { codeTheme } from './lib/code-theme'
import { rehypeTableNames } from './lib/table-names'
import { rehypeTypeset } from './lib/typeset'

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
  },
}))

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

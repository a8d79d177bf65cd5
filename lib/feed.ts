import 'server-only'
import GithubSlugger from 'github-slugger'
import rehypeStringify from 'rehype-stringify'
import remarkParse from 'remark-parse'
import remarkRehype from 'remark-rehype'
import { unified } from 'unified'
import releases from '@/registry/releases.json'
import { siteUrl } from '@/site.config.mjs'
import { changelog } from './source'

const toHtml = unified().use(remarkParse).use(remarkRehype).use(rehypeStringify)

const entities: Record<string, string> = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' }
const escaped = (text: string) => text.replace(/[&<>"]/g, (sign) => entities[sign])

/** The versions of the changelog that are released, newest first, as an RSS feed. */
export function feed(): string {
  const page = `${siteUrl}/docs/changelog`
  const [, ...versions] = changelog().split(/^## /m)
  const items = versions.flatMap((text) => {
    const [version] = text.split('\n', 1)
    const release = (releases as Record<string, { date: string }>)[version]
    if (!release) return []
    const link = `${page}#${new GithubSlugger().slug(version)}`
    return `<item>
<title>Gravity Stack ${version}</title>
<link>${link}</link>
<guid>${link}</guid>
<pubDate>${new Date(release.date).toUTCString()}</pubDate>
<description>${escaped(String(toHtml.processSync(text.slice(version.length))))}</description>
</item>`
  })
  return `<?xml version="1.0" encoding="UTF-8"?>
<rss version="2.0" xmlns:atom="http://www.w3.org/2005/Atom">
<channel>
<title>Gravity Stack: changelog</title>
<link>${page}</link>
<description>What people who own a copy of the component notice, version by version.</description>
<language>en</language>
<atom:link href="${siteUrl}/changelog.xml" rel="self" type="application/rss+xml"/>
${items.join('\n')}
</channel>
</rss>
`
}

import type { MetadataRoute } from 'next'
import { docs } from '@/lib/docs'
import { siteUrl } from '@/site.config.mjs'

export const dynamic = 'force-static'

export default function sitemap(): MetadataRoute.Sitemap {
  return [
    '',
    '/docs',
    '/blocks',
    '/playground',
    '/benchmarks',
    ...docs.map((doc) => `/docs/${doc.slug}`),
  ].map((path) => ({
    url: siteUrl + path,
  }))
}

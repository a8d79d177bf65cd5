import type { Metadata } from 'next'
import { notFound } from 'next/navigation'
import { DocsLayout } from '@/components/docs-layout'
import { Mdx } from '@/components/mdx'
import { OnThisPage } from '@/components/on-this-page'
import { PageEnd } from '@/components/page-end'
import { PageTools } from '@/components/page-tools'
import { docs, findDoc } from '@/lib/docs'
import { headingsOf } from '@/lib/headings'
import { changelog } from '@/lib/source'
import { typeset } from '@/lib/typeset'

export const dynamicParams = false
export const generateStaticParams = () => docs.map(({ slug }) => ({ slug }))

/** Where a page's title would only repeat the site's name. */
const titles: Record<string, Metadata['title']> = {
  'gravity-stack': { absolute: 'Gravity Stack, a React component' },
}

export async function generateMetadata({ params }: PageProps<'/docs/[slug]'>): Promise<Metadata> {
  const doc = findDoc((await params).slug)
  return doc
    ? {
        title: titles[doc.slug] ?? doc.title,
        description: doc.description,
        alternates: {
          canonical: `/docs/${doc.slug}`,
          types: {
            'text/markdown': `/docs/${doc.slug}.md`,
            ...(doc.slug === 'changelog' && { 'application/rss+xml': '/changelog.xml' }),
          },
        },
      }
    : {}
}

export default async function DocPage({ params }: PageProps<'/docs/[slug]'>) {
  const doc = findDoc((await params).slug)
  if (!doc) notFound()

  return (
    <DocsLayout path={`/docs/${doc.slug}`}>
      <div className="grid grid-cols-[minmax(0,1fr)] gap-14 xl:grid-cols-[minmax(0,46rem)_12rem] xl:justify-between">
        <main id="content" className="min-w-0 max-w-[46rem] pt-10 pb-20 max-xl:mx-auto max-xl:w-full">
          <h1 className="text-balance font-semibold text-4xl tracking-[-0.03em]">{doc.title}</h1>
          <p className="mt-3 text-pretty text-lg text-muted-foreground leading-relaxed">
            {typeset(doc.description)}
          </p>
          <PageTools
            className="mt-4"
            twin={`/docs/${doc.slug}.md`}
            source={`content/${doc._raw.sourceFilePath}`}
          />
          <div className="mt-8">
            <Mdx code={doc.body.code} />
          </div>
          <PageEnd path={`/docs/${doc.slug}`} />
        </main>
        <OnThisPage headings={headingsOf(doc.body.raw.replace('<Changelog />', changelog))} />
      </div>
    </DocsLayout>
  )
}

import type { Metadata } from 'next'
import { notFound } from 'next/navigation'
import { CopyButton } from '@/components/copy-button'
import { Mdx } from '@/components/mdx'
import { docs, findDoc, type Heading, link } from '@/lib/docs'
import { repositoryUrl } from '@/site.config.mjs'

export const dynamicParams = false
export const generateStaticParams = () => docs.map(({ slug }) => ({ slug }))

export async function generateMetadata({ params }: PageProps<'/docs/[slug]'>): Promise<Metadata> {
  const { doc } = findDoc((await params).slug)
  return doc
    ? { title: doc.title, description: doc.description, alternates: { canonical: `/docs/${doc.slug}` } }
    : {}
}

export default async function DocPage({ params }: PageProps<'/docs/[slug]'>) {
  const { doc, previous, next } = findDoc((await params).slug)
  if (!doc) notFound()
  const headings = doc.headings as Heading[]

  return (
    <div className="grid grid-cols-[minmax(0,1fr)] gap-14 xl:grid-cols-[minmax(0,46rem)_12rem] xl:justify-between">
      <main id="content" className="min-w-0 max-w-[46rem] pt-10 pb-20 max-xl:mx-auto max-xl:w-full">
        <h1 className="text-balance font-semibold text-4xl tracking-[-0.03em]">{doc.title}</h1>
        <p className="mt-3 text-pretty text-lg text-muted-foreground leading-relaxed">{doc.description}</p>
        <div data-print="hide" className="-ml-2 mt-4 flex flex-wrap items-center gap-x-2 text-sm">
          <CopyButton from={`/docs/${doc.slug}.md`} label="Copy page as Markdown">
            Copy page
          </CopyButton>
          <a
            href={`/docs/${doc.slug}.md`}
            className="rounded-md px-2 py-1.5 text-muted-foreground hover:text-foreground"
          >
            Markdown
          </a>
          {repositoryUrl && (
            <a
              href={`${repositoryUrl}/edit/main/content/${doc._raw.sourceFilePath}`}
              className="rounded-md px-2 py-1.5 text-muted-foreground hover:text-foreground"
            >
              Edit
            </a>
          )}
        </div>
        <div className="mt-8">
          <Mdx code={doc.body.code} />
        </div>
        <nav
          data-print="hide"
          aria-label="Previous and next"
          className="mt-20 flex justify-between gap-4 border-t pt-6"
        >
          {previous ? <Neighbour word="Previous" {...link(previous)} /> : <span />}
          {next && <Neighbour word="Next" {...link(next)} />}
        </nav>
      </main>
      <aside data-print="hide" className="hidden xl:block">
        <nav
          aria-label="On this page"
          className="sticky top-14 max-h-[calc(100dvh-3.5rem)] overflow-y-auto py-12 text-sm"
        >
          <p className="font-medium">On this page</p>
          <ul className="mt-3 space-y-2">
            {headings.map((heading) => (
              <li key={heading.id} className={heading.depth > 2 ? 'pl-3' : undefined}>
                <a href={`#${heading.id}`} className="text-muted-foreground hover:text-foreground">
                  {heading.text}
                </a>
              </li>
            ))}
          </ul>
        </nav>
      </aside>
    </div>
  )
}

function Neighbour({ word, title, href }: { word: string; title: string; href: string }) {
  return (
    <a
      href={href}
      className="group -mx-3 rounded-lg px-3 py-2 transition-colors last:text-right hover:bg-muted"
    >
      <span className="block text-muted-foreground text-sm">{word}</span>
      <span className="font-medium">{title}</span>
    </a>
  )
}

import type { Metadata } from 'next'
import { DocsLayout } from '@/components/docs-layout'
import { PageTools } from '@/components/page-tools'
import { at } from '@/lib/address'
import { navigation } from '@/lib/docs'
import { typeset } from '@/lib/typeset'

export const metadata: Metadata = {
  title: 'Docs',
  description:
    'All pages of the Gravity Stack docs: setting up, the component, how its solver works and what is measured.',
  alternates: { canonical: '/docs', types: { 'text/markdown': '/docs.md' } },
}

export default function Docs() {
  return (
    <DocsLayout path="/docs">
      <main id="content" className="min-w-0 max-w-[46rem] pt-10 pb-20">
        <h1 className="font-semibold text-4xl tracking-[-0.03em]">Docs</h1>
        <p className="mt-3 text-lg text-muted-foreground leading-relaxed">
          Everything about the component: how to install it, how it works, and what has been measured.
        </p>
        <PageTools className="mt-4" twin="/docs.md" source="app/docs/page.tsx" />
        {navigation.map((section) => (
          <section key={section.title} className="mt-12">
            <h2 className="font-semibold text-xl tracking-[-0.02em]">{section.title}</h2>
            <ul className="mt-4 divide-y overflow-hidden rounded-2xl border bg-panel">
              {section.pages.map((page) => (
                <li key={page.href}>
                  <a
                    href={at(page.href)}
                    className="block rounded-2xl px-5 py-4 -outline-offset-2 transition-colors hover:bg-muted"
                  >
                    <span className="font-medium">{page.title}</span>
                    <span className="mt-1 block text-muted-foreground text-sm">
                      {typeset(page.description)}
                    </span>
                  </a>
                </li>
              ))}
            </ul>
          </section>
        ))}
      </main>
    </DocsLayout>
  )
}

import type { Metadata } from 'next'
import { BlockPreview } from '@/components/block-preview'
import { Command } from '@/components/command'
import { Heading } from '@/components/heading'
import { OpenInV0 } from '@/components/open-in-v0'
import { PageEnd } from '@/components/page-end'
import { PageTools } from '@/components/page-tools'
import { Site } from '@/components/site'
import { blocks, blocksPitch } from '@/lib/blocks'
import { siteUrl } from '@/site.config.mjs'

export const metadata: Metadata = {
  title: 'Blocks',
  description: blocksPitch.lead,
  alternates: { canonical: '/blocks', types: { 'text/markdown': '/blocks.md' } },
}

export default function Blocks() {
  return (
    <Site>
      <main id="content" className="mx-auto w-full max-w-[88rem] flex-1 px-4 pt-10 pb-20 sm:px-6">
        <h1 className="font-semibold text-4xl tracking-[-0.03em]">{blocksPitch.title}</h1>
        <p className="mt-3 max-w-2xl text-pretty text-lg text-muted-foreground leading-relaxed">
          {blocksPitch.lead}
        </p>
        <PageTools className="mt-4" twin="/blocks.md" source="app/blocks/page.tsx" />
        {blocks.map(({ name, title, description, heights }) => (
          <section key={name} className="mt-16">
            <div className="flex flex-wrap items-end justify-between gap-x-6 gap-y-3">
              <div>
                <Heading as="h2" id={name} className="font-semibold text-2xl tracking-[-0.02em]">
                  {title}
                </Heading>
                <p className="mt-1 max-w-2xl text-pretty text-muted-foreground">{description}</p>
              </div>
              <OpenInV0 name={name} />
            </div>
            <div className="mt-5">
              <BlockPreview name={name} title={title} heights={heights} />
            </div>
            <div className="mt-4 max-w-2xl">
              <Command label={`add ${name}`} run={`shadcn@latest add ${siteUrl}/r/${name}.json`} />
            </div>
          </section>
        ))}
        <PageEnd path="/blocks" />
      </main>
    </Site>
  )
}

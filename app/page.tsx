import type { Metadata } from 'next'
import type { CSSProperties } from 'react'
import { BlockFrame } from '@/components/block-frame'
import { Command } from '@/components/command'
import { Hero } from '@/components/hero'
import { ArrowIcon } from '@/components/icons'
import { PageTools } from '@/components/page-tools'
import { Site } from '@/components/site'
import { UprightFlip } from '@/components/upright-flip'
import { at } from '@/lib/address'
import { blocks } from '@/lib/blocks'
import { type Fact, facts, news, pitch, price, ways } from '@/lib/home'
import { typeset } from '@/lib/typeset'
import { siteUrl, version } from '@/site.config.mjs'

export const metadata: Metadata = { alternates: { canonical: '/', types: { 'text/markdown': '/index.md' } } }

/** The blocks on the home page: one of each kind, of about one height. */
const gallery = blocks.filter(({ name }) => /-(logos|interests|newsletter|not-found)$/.test(name))

export default async function Home() {
  return (
    <Site>
      <main id="content" className="mx-auto w-full max-w-[88rem] flex-1 px-4 pb-24 sm:px-6">
        <div className="mt-4 sm:mt-6">
          <Hero>
            <div className="flex min-h-[min(42rem,calc(100svh-15rem))] flex-col items-center px-5 pt-10 pb-80 text-center max-sm:motion-reduce:pb-[28rem] sm:pt-14 sm:pb-60 max-sm:[@media(scripting:none)]:pb-[28rem] max-[16rem]:pb-[40rem]">
              <h1 className="text-balance font-semibold text-5xl tracking-[-0.045em] sm:text-7xl">
                {pitch.title}
              </h1>
              <p className="mt-4 max-w-lg text-pretty text-muted-foreground leading-relaxed sm:text-lg">
                {pitch.lead}
              </p>
              <ul className="mt-4 flex flex-wrap justify-center gap-x-6 gap-y-1 text-muted-foreground text-sm sm:text-base">
                {(await price()).map(([figure, of]) => (
                  <li key={of}>
                    <strong className="font-semibold text-foreground tabular-nums">{figure}</strong> {of}
                  </li>
                ))}
              </ul>
              <div className="mt-6 flex w-full max-w-xl flex-col items-center gap-4">
                <div className="w-full">
                  <Command
                    label="add gravity-stack"
                    run={`shadcn@latest add ${siteUrl}/r/gravity-stack.json`}
                  />
                </div>
                <a
                  href={at('/docs/gravity-stack')}
                  data-print="hide"
                  className="group inline-flex items-center gap-2 rounded-full bg-foreground px-5 py-2.5 font-medium text-background text-sm"
                >
                  Read the docs
                  <ArrowIcon className="transition-transform group-hover:translate-x-0.5" />
                </a>
              </div>
            </div>
          </Hero>
        </div>
        <section
          aria-labelledby="news"
          className="mt-16 grid grid-cols-[minmax(0,1fr)] items-center gap-x-14 gap-y-8 lg:grid-cols-[minmax(0,7fr)_minmax(0,5fr)]"
        >
          <UprightFlip />
          <div>
            <p className="text-muted-foreground text-sm">New in {version}</p>
            <h2 id="news" className="mt-2 text-balance font-semibold text-3xl tracking-[-0.03em]">
              {news.title}
            </h2>
            <p className="mt-3 text-pretty text-muted-foreground leading-relaxed">
              {typeset(news.text)}{' '}
              <a href={at(news.more.href)} className="text-foreground underline underline-offset-4">
                {news.more.title}
              </a>
            </p>
            <ul className="mt-6 space-y-4 border-t pt-6 text-sm">
              {news.others.map(({ title, href, text }) => (
                <li key={href}>
                  <a href={at(href)} className="font-medium underline-offset-4 hover:underline">
                    {title}
                  </a>
                  <p className="mt-1 text-pretty text-muted-foreground leading-relaxed">{typeset(text)}</p>
                </li>
              ))}
            </ul>
          </div>
        </section>
        <dl className="mt-20 grid grid-cols-[minmax(0,1fr)] gap-x-10 gap-y-10 sm:grid-cols-2 lg:grid-cols-4">
          {(await facts()).map((fact) => (
            <FactCell key={fact.title} {...fact} />
          ))}
        </dl>
        <section aria-labelledby="blocks" className="mt-20">
          <div className="flex flex-wrap items-end justify-between gap-x-6 gap-y-2">
            <h2 id="blocks" className="font-semibold text-3xl tracking-[-0.03em]">
              Ship a part of a page
            </h2>
            <a href={at('/blocks')} className="underline underline-offset-4">
              All {blocks.length} blocks
            </a>
          </div>
          <ul className="mt-6 grid grid-cols-[minmax(0,1fr)] gap-4 lg:grid-cols-2">
            {gallery.map(({ name, title, heights }) => (
              <li key={name} className="overflow-hidden rounded-2xl border bg-panel">
                <BlockFrame
                  name={name}
                  title={title}
                  className="h-(--narrow)"
                  style={{ '--narrow': `${heights.narrow}px` } as CSSProperties}
                />
                <p className="flex items-baseline justify-between gap-4 border-t px-5 py-3 text-sm">
                  <a href={at(`/blocks#${name}`)} className="font-medium underline-offset-4 hover:underline">
                    {title}
                  </a>
                </p>
              </li>
            ))}
          </ul>
        </section>
        <ul className="mt-20 grid grid-cols-[minmax(0,1fr)] gap-4 md:grid-cols-3">
          {ways.map((way) => (
            <Way key={way.href} {...way} />
          ))}
        </ul>
        <PageTools className="mt-10 justify-center" twin="/index.md" source="app/page.tsx" />
      </main>
    </Site>
  )
}

function FactCell({ figure, title, text, more }: Fact) {
  return (
    <div>
      <dt className="flex flex-col-reverse font-medium">
        {title}
        <span className="mb-1 font-semibold text-4xl tabular-nums tracking-[-0.03em]">{figure}</span>
      </dt>
      <dd className="mt-2 text-pretty text-muted-foreground text-sm leading-relaxed">
        {text}{' '}
        {more && (
          <a href={at(more.href)} className="underline underline-offset-4">
            {more.title}
          </a>
        )}
      </dd>
    </div>
  )
}

function Way({ href, title, text }: { href: string; title: string; text: string }) {
  return (
    <li>
      <a
        href={at(href)}
        className="group block h-full rounded-2xl border bg-panel p-6 transition-colors hover:border-foreground/40"
      >
        <span className="flex items-center justify-between font-medium">
          {title}
          <ArrowIcon className="text-muted-foreground transition-transform group-hover:translate-x-0.5" />
        </span>
        <span className="mt-2 block text-pretty text-muted-foreground text-sm leading-relaxed">{text}</span>
      </a>
    </li>
  )
}

import type { Metadata } from 'next'
import { PageEnd } from '@/components/page-end'
import { PageTools } from '@/components/page-tools'
import { Playground } from '@/components/playground'
import { version } from '@/site.config.mjs'

export const metadata: Metadata = {
  title: 'Playground',
  description:
    'Gravity, bounce, friction and more to tune, slow motion and single steps, and the code for your settings.',
  alternates: { canonical: '/playground', types: { 'text/markdown': '/playground.md' } },
}

export default function PlaygroundPage() {
  return (
    <main id="content" className="mx-auto w-full max-w-[88rem] flex-1 px-4 pt-10 pb-20 sm:px-6">
      <h1 className="font-semibold text-4xl tracking-[-0.03em]">Playground</h1>
      <p className="mt-3 max-w-2xl text-pretty text-lg text-muted-foreground leading-relaxed">
        Tune the props, watch the contacts, take the code. The address holds your settings: share it, and
        others start from them. “Copy this pile” gives an address that plays what you did, step for step.
      </p>
      <Playground version={version} />
      <PageTools className="mt-10" twin="/playground.md" source="app/playground/page.tsx" />
      <PageEnd path="/playground" />
    </main>
  )
}

import Link from 'next/link'
import { Command } from '@/components/command'
import { HeroStage } from '@/components/hero-stage'
import { ArrowIcon } from '@/components/icons'
import { siteUrl } from '@/site.config.mjs'

export default function Home() {
  return (
    <main id="content" className="mx-auto w-full max-w-[88rem] flex-1 px-4 pb-20 sm:px-6">
      <section className="relative isolate mt-4 overflow-hidden rounded-3xl border bg-stage sm:mt-6">
        <HeroStage />
        <div className="pointer-events-none relative flex min-h-[min(46rem,calc(100svh-6.5rem))] flex-col items-center px-5 pt-12 pb-96 text-center sm:pt-20 sm:pb-64">
          <h1 className="text-balance font-semibold text-5xl tracking-[-0.045em] sm:text-7xl">
            Words with weight
          </h1>
          <p className="mt-5 max-w-xl text-pretty text-lg text-muted-foreground leading-relaxed">
            A React component whose children drop in, tumble and settle into a pile. Its own rigid-body
            solver, in the one file you copy.
          </p>
          <div className="pointer-events-auto mt-8 flex w-full max-w-xl flex-col items-center gap-4">
            <div className="w-full">
              <Command label="add gravity-stack" run={`shadcn@latest add ${siteUrl}/r/gravity-stack.json`} />
            </div>
            <Link
              href="/docs/gravity-stack"
              className="group inline-flex items-center gap-2 rounded-full bg-foreground px-5 py-2.5 font-medium text-background text-sm"
            >
              Read the docs
              <ArrowIcon className="transition-transform group-hover:translate-x-0.5" />
            </Link>
          </div>
        </div>
      </section>
    </main>
  )
}

import type { ReactNode } from 'react'
import { Code } from '@/components/code-block'
import { Command } from '@/components/command'
import { Hero } from '@/components/hero'
import { ArrowIcon } from '@/components/icons'
import { costOf60 } from '@/lib/bench'
import { heroEffects, heroSnippets } from '@/lib/hero-snippets'
import { componentSize } from '@/lib/size'
import { siteUrl } from '@/site.config.mjs'

const snippets = Object.fromEntries(
  heroEffects.map((effect) => [effect, <Code key={effect} code={heroSnippets[effect]} />]),
) as Record<(typeof heroEffects)[number], ReactNode>

export default function Home() {
  const cost = costOf60()
  return (
    <main id="content" className="mx-auto w-full max-w-[80rem] flex-1 px-4 pb-24 sm:px-6">
      <div className="mt-4 sm:mt-6">
        <Hero snippets={snippets}>
          <div className="flex min-h-[min(42rem,calc(100svh-15rem))] flex-col items-center px-5 pt-10 pb-80 text-center max-sm:motion-reduce:pb-[28rem] sm:pt-14 sm:pb-52 max-sm:[@media(scripting:none)]:pb-[28rem]">
            <h1 className="text-balance font-semibold text-5xl tracking-[-0.045em] sm:text-7xl">
              Words with weight
            </h1>
            <p className="mt-4 max-w-lg text-pretty text-muted-foreground leading-relaxed sm:text-lg">
              A React component whose children drop in, tumble and settle into a pile. Its own rigid-body
              solver, in the one file you copy.
            </p>
            <div className="mt-6 flex w-full max-w-xl flex-col items-center gap-4">
              <div className="w-full">
                <Command
                  label="add gravity-stack"
                  run={`shadcn@latest add ${siteUrl}/r/gravity-stack.json`}
                />
              </div>
              <a
                href="/docs/gravity-stack"
                className="group inline-flex items-center gap-2 rounded-full bg-foreground px-5 py-2.5 font-medium text-background text-sm"
              >
                Read the docs
                <ArrowIcon className="transition-transform group-hover:translate-x-0.5" />
              </a>
            </div>
          </div>
        </Hero>
      </div>
      <dl className="mt-16 grid grid-cols-[minmax(0,1fr)] gap-x-10 gap-y-10 sm:grid-cols-2 lg:grid-cols-4">
        <Fact figure={`${componentSize()} kB`} title="the whole component">
          Minified and compressed, solver and all, beside React, Motion and{' '}
          <code className="font-mono">cn</code>.
        </Fact>
        <Fact figure="1" title="file, yours once copied">
          It reads as if you had written it: a room for each job, every number with its unit and its reason.
        </Fact>
        <Fact figure="0" title="frames at rest">
          Chips that lie still sleep, and the loop ends with the last of them. Off screen nothing runs at all.
        </Fact>
        {cost ? (
          <Fact figure={`${cost.micros} µs`} title="a frame, 60 chips awake">
            Measured on {cost.cpu}, beside every other engine and against exact answers.{' '}
            <a href="/benchmarks" className="underline underline-offset-4">
              Benchmarks
            </a>
          </Fact>
        ) : (
          <Fact figure="4" title="shapes, one family">
            Pill, disc, card or box: a child collides as it is drawn, from its measured size and corner
            radius.
          </Fact>
        )}
      </dl>
      <ul className="mt-20 grid grid-cols-[minmax(0,1fr)] gap-4 md:grid-cols-3">
        <Way href="/playground" title="Playground">
          Turn every prop, step through the fall, take the code.
        </Way>
        <Way href="/docs/how-it-works" title="How it works">
          Six ideas, each with a figure that runs the solver under your fingers.
        </Way>
        <Way href="/docs/accessibility" title="Accessibility">
          Reduced motion, keyboard, screen reader, touch, paper: criterion by criterion.
        </Way>
      </ul>
    </main>
  )
}

function Fact({ figure, title, children }: { figure: string; title: string; children: ReactNode }) {
  return (
    <div>
      <dt className="flex flex-col-reverse font-medium">
        {title}
        <span className="mb-1 font-semibold text-4xl tabular-nums tracking-[-0.03em]">{figure}</span>
      </dt>
      <dd className="mt-2 text-pretty text-muted-foreground text-sm leading-relaxed">{children}</dd>
    </div>
  )
}

function Way({ href, title, children }: { href: string; title: string; children: ReactNode }) {
  return (
    <li>
      <a
        href={href}
        className="group block h-full rounded-2xl border bg-panel p-6 transition-colors hover:border-foreground/40"
      >
        <span className="flex items-center justify-between font-medium">
          {title}
          <ArrowIcon className="text-muted-foreground transition-transform group-hover:translate-x-0.5" />
        </span>
        <span className="mt-2 block text-pretty text-muted-foreground text-sm leading-relaxed">
          {children}
        </span>
      </a>
    </li>
  )
}

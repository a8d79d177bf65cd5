'use client'

import { useRef } from 'react'
import { GravityStack } from '@/components/ui/gravity-stack'

const words = [
  'plan',
  'sketch',
  'write',
  'review',
  'ship',
  'measure',
  'listen',
  'repeat',
  'rest',
  'begin again',
]
const tints = [
  'bg-teal-300 text-teal-950',
  'bg-orange-200 text-orange-950',
  'bg-neutral-900 text-neutral-50 dark:bg-neutral-200 dark:text-neutral-950',
]

/**
 * The first screen of a site. The stage lies under all of it, and heading and button are what the chips land
 * on: pass your own elements to `obstacles`.
 */
export function GravityHero() {
  const title = useRef<HTMLHeadingElement>(null)
  const action = useRef<HTMLAnchorElement>(null)
  return (
    <section className="relative isolate min-h-[40rem] bg-neutral-50 text-neutral-950 dark:bg-neutral-950 dark:text-neutral-50">
      <GravityStack className="absolute inset-0 h-full" stagger={110} obstacles={[title, action]}>
        {words.map((word, index) => (
          <span
            key={word}
            className={`rounded-full px-4 py-2 font-medium text-sm sm:px-5 sm:text-base ${tints[index % tints.length]}`}
          >
            {word}
          </span>
        ))}
      </GravityStack>
      {/* What lies over the stage lets pointers through to the chips, but for the link. */}
      <div className="pointer-events-none relative flex flex-col items-center px-6 pt-40 text-center sm:pt-48">
        <h1
          ref={title}
          className="max-w-64 text-balance px-2 font-semibold text-4xl tracking-tight sm:max-w-md sm:text-6xl"
        >
          Work that finds its place
        </h1>
        <a
          ref={action}
          href="/start"
          className="pointer-events-auto mt-10 rounded-full bg-teal-700 px-6 py-3 font-medium text-white hover:bg-teal-800"
        >
          Start for free
        </a>
      </div>
    </section>
  )
}

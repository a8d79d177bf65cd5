'use client'

import { useState } from 'react'
import { GravityStack } from '@/components/ui/gravity-stack'

const interests = [
  'Architecture',
  'Baking',
  'Birds',
  'Ceramics',
  'Cycling',
  'Film',
  'Gardens',
  'Jazz',
  'Maps',
  'Photography',
  'Poetry',
  'Space',
  'Swimming',
  'Typography',
]

const least = 3

/** A step of an onboarding: pick what you like from the pile. What is picked is listed above it, straight. */
export function GravityInterests() {
  const [picked, setPicked] = useState<string[]>([])
  const toggle = (interest: string) =>
    setPicked(
      picked.includes(interest) ? picked.filter((other) => other !== interest) : [...picked, interest],
    )
  const missing = least - picked.length

  return (
    <section
      aria-labelledby="interests"
      className="bg-white px-4 py-12 text-neutral-950 sm:px-6 dark:bg-neutral-950 dark:text-neutral-50"
    >
      <div className="mx-auto max-w-xl overflow-hidden rounded-3xl border border-neutral-200 bg-neutral-50 dark:border-neutral-800 dark:bg-neutral-900">
        <div className="px-6 pt-7">
          <p className="text-neutral-600 text-sm dark:text-neutral-400">Step 2 of 3</p>
          <h2 id="interests" className="mt-1 font-semibold text-2xl tracking-tight">
            What do you like?
          </h2>
          <p
            role="status"
            className="mt-2 min-h-10 text-pretty text-neutral-600 text-sm dark:text-neutral-400"
          >
            {picked.length > 0 ? picked.join(', ') : 'Pick three or more, and your first page is about them.'}
          </p>
        </div>
        <GravityStack className="h-80" stagger={70} bounce={0.25}>
          {interests.map((interest) => (
            <button
              key={interest}
              type="button"
              aria-pressed={picked.includes(interest)}
              onClick={() => toggle(interest)}
              className="rounded-full border border-neutral-400 bg-white px-4 py-2.5 font-medium text-sm focus-visible:-outline-offset-4 aria-pressed:border-transparent aria-pressed:bg-teal-300 aria-pressed:text-teal-950 dark:border-neutral-600 dark:bg-neutral-800"
            >
              {interest}
            </button>
          ))}
        </GravityStack>
        <div className="flex items-center justify-between gap-4 border-neutral-200 border-t px-6 py-4 dark:border-neutral-800">
          <a
            href="/welcome"
            className="text-neutral-600 text-sm underline-offset-4 hover:underline dark:text-neutral-400"
          >
            Skip
          </a>
          <button
            type="button"
            disabled={missing > 0}
            className="rounded-full bg-neutral-950 px-5 py-2.5 font-medium text-sm text-white disabled:bg-neutral-300 disabled:text-neutral-700 dark:bg-white dark:text-neutral-950 dark:disabled:bg-neutral-700 dark:disabled:text-neutral-300"
          >
            {missing > 0 ? `${missing} more` : 'Continue'}
          </button>
        </div>
      </div>
    </section>
  )
}

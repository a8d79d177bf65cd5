'use client'

import { type FormEvent, useState } from 'react'
import { GravityStack } from '@/components/ui/gravity-stack'

const topics = [
  'Releases',
  'Case studies',
  'Events',
  'Tutorials',
  'Interviews',
  'Research',
  'Jobs',
  'Bad puns',
]

/** A form whose checkboxes lie in a pile. Tab goes from one to the next; Space or a press checks it. */
export function GravityNewsletter() {
  const [thanks, setThanks] = useState('')

  function subscribe(event: FormEvent<HTMLFormElement>) {
    event.preventDefault()
    const form = new FormData(event.currentTarget)
    const chosen = form.getAll('topics')
    // Send it to your own service here.
    setThanks(
      `Thank you! We’ll write to ${form.get('email')} about ${chosen.length > 0 ? chosen.join(', ') : 'everything'}.`,
    )
  }

  return (
    <section
      aria-labelledby="newsletter"
      className="bg-white px-4 py-12 text-neutral-950 sm:px-6 dark:bg-neutral-950 dark:text-neutral-50"
    >
      <form
        onSubmit={subscribe}
        className="mx-auto max-w-2xl overflow-hidden rounded-3xl border border-neutral-200 bg-neutral-50 dark:border-neutral-800 dark:bg-neutral-900"
      >
        <div className="px-6 pt-8 sm:px-8">
          <h2 id="newsletter" className="font-semibold text-2xl tracking-tight">
            Once a month, only what you like
          </h2>
          <div className="mt-5 flex flex-wrap gap-3">
            <label className="min-w-56 flex-1">
              <span className="sr-only">Email address</span>
              <input
                type="email"
                name="email"
                required
                autoComplete="email"
                placeholder="you@example.com"
                className="h-11 w-full rounded-full border border-neutral-500 bg-white px-4 text-base placeholder:text-neutral-500 dark:border-neutral-500 dark:bg-neutral-950 dark:placeholder:text-neutral-400"
              />
            </label>
            <button
              type="submit"
              className="h-11 rounded-full bg-neutral-950 px-6 font-medium text-sm text-white hover:bg-neutral-800 dark:bg-white dark:text-neutral-950 dark:hover:bg-neutral-200"
            >
              Subscribe
            </button>
          </div>
          <p
            role="status"
            className="mt-3 min-h-5 text-pretty text-emerald-800 text-sm dark:text-emerald-300"
          >
            {thanks}
          </p>
        </div>
        <fieldset className="mt-2">
          <legend className="px-6 font-medium text-sm sm:px-8">Topics</legend>
          <GravityStack className="h-64" stagger={90}>
            {topics.map((topic) => (
              <label
                key={topic}
                className="relative flex cursor-pointer items-center gap-2 rounded-full border border-neutral-500 bg-white px-4 py-2.5 font-medium text-sm has-checked:border-emerald-700 has-checked:bg-emerald-200 has-checked:text-emerald-950 has-focus-visible:outline-2 has-focus-visible:-outline-offset-4 dark:bg-neutral-800 dark:has-checked:bg-emerald-300"
              >
                <input
                  type="checkbox"
                  name="topics"
                  value={topic}
                  className="size-4 accent-emerald-800 outline-none"
                />
                {topic}
              </label>
            ))}
          </GravityStack>
        </fieldset>
      </form>
    </section>
  )
}

'use client'

import { useState } from 'react'
import { GravityStack } from '@/components/ui/gravity-stack'

const articles: [title: string, tags: string[]][] = [
  ['A form that people finish', ['forms', 'writing']],
  ['Dark mode without mud', ['colour', 'css']],
  ['Grids that bend', ['css', 'layout']],
  ['Keyboard first, mouse second', ['access', 'forms']],
  ['Motion that says something', ['motion', 'css']],
  ['Names for colours', ['colour', 'writing']],
  ['The empty state is a page', ['layout', 'writing']],
  ['What a screen reader hears', ['access', 'writing']],
]

const tags = [...new Set(articles.flatMap(([, tags]) => tags))].sort()

/** Filters that fall into a tray as they are chosen. A press on one in the tray takes it out again. */
export function GravityFilters() {
  const [chosen, setChosen] = useState(['css'])
  const toggle = (tag: string) =>
    setChosen(chosen.includes(tag) ? chosen.filter((other) => other !== tag) : [...chosen, tag])
  const found = articles.filter(([, tags]) => chosen.every((tag) => tags.includes(tag)))

  return (
    <section
      aria-labelledby="articles"
      className="bg-white text-neutral-950 dark:bg-neutral-950 dark:text-neutral-50"
    >
      <div className="mx-auto grid max-w-5xl gap-8 px-6 py-12 md:grid-cols-2">
        <div>
          <h2 id="articles" className="font-semibold text-3xl tracking-tight">
            Articles
          </h2>
          <fieldset className="mt-5 flex flex-wrap gap-2">
            <legend className="sr-only">Filter by topic</legend>
            {tags.map((tag) => (
              <button
                key={tag}
                type="button"
                aria-pressed={chosen.includes(tag)}
                onClick={() => toggle(tag)}
                className="rounded-full border border-neutral-400 px-3.5 py-1.5 text-sm hover:bg-neutral-100 aria-pressed:border-transparent aria-pressed:bg-violet-700 aria-pressed:text-white dark:border-neutral-600 dark:aria-pressed:bg-violet-300 dark:aria-pressed:text-violet-950 dark:hover:bg-neutral-900"
              >
                {tag}
              </button>
            ))}
          </fieldset>
          <GravityStack className="mt-5 h-44 rounded-3xl bg-neutral-100 dark:bg-neutral-900" stagger={0}>
            {chosen.map((tag) => (
              <button
                key={tag}
                type="button"
                aria-label={`Take ${tag} out of the filter`}
                onClick={() => toggle(tag)}
                className="rounded-full bg-violet-300 px-5 py-2.5 font-medium text-violet-950 focus-visible:-outline-offset-4"
              >
                {tag} <span aria-hidden="true">×</span>
              </button>
            ))}
          </GravityStack>
        </div>
        <div>
          <p role="status" className="text-neutral-600 text-sm dark:text-neutral-400">
            {found.length === 1 ? '1 article' : `${found.length} articles`}
          </p>
          <ul className="mt-3 divide-y divide-neutral-200 border-neutral-200 border-y dark:divide-neutral-800 dark:border-neutral-800">
            {found.map(([title, tags]) => (
              <li key={title} className="py-3">
                <a href="/articles" className="font-medium underline-offset-4 hover:underline">
                  {title}
                </a>
                <p className="text-neutral-600 text-sm dark:text-neutral-400">{tags.join(', ')}</p>
              </li>
            ))}
          </ul>
        </div>
      </div>
    </section>
  )
}

'use client'

import { useState } from 'react'
import { GravityStack } from '@/components/ui/gravity-stack'

const emojis: [emoji: string, name: string, count: number][] = [
  ['👏', 'Applause', 12],
  ['💛', 'Love', 31],
  ['💡', 'Good idea', 8],
  ['😂', 'Funny', 5],
  ['🤯', 'Mind blown', 3],
]

/** The stage holds so many at most; then the oldest makes way. */
const most = 40

/** Reactions below an article: each press drops one onto the pile of those before it. */
export function GravityReactions() {
  const [counts, setCounts] = useState(emojis.map(([, , count]) => count))
  const [drops, setDrops] = useState([0, 1, 1, 2, 0, 3].map((which, id) => ({ id, which })))

  function react(which: number) {
    setCounts(counts.map((count, index) => (index === which ? count + 1 : count)))
    setDrops([...drops, { id: (drops.at(-1)?.id ?? 0) + 1, which }].slice(-most))
  }

  return (
    <section
      aria-labelledby="reactions"
      className="bg-white px-4 py-12 text-neutral-950 sm:px-6 dark:bg-neutral-950 dark:text-neutral-50"
    >
      <div className="mx-auto max-w-2xl overflow-hidden rounded-3xl border border-neutral-200 bg-neutral-50 dark:border-neutral-800 dark:bg-neutral-900">
        <div aria-hidden="true">
          <GravityStack className="h-64" bounce={0.4} stagger={80}>
            {drops.map(({ id, which }) => (
              <span
                key={id}
                className="grid size-12 place-items-center rounded-full bg-white text-2xl leading-none shadow-sm ring-1 ring-neutral-200 dark:bg-neutral-800 dark:ring-neutral-700"
              >
                {emojis[which][0]}
              </span>
            ))}
          </GravityStack>
        </div>
        <div className="flex flex-wrap items-center justify-between gap-x-6 gap-y-3 border-neutral-200 border-t px-5 py-4 dark:border-neutral-800">
          <h2 id="reactions" className="font-medium text-sm">
            What did you think?
          </h2>
          <div className="flex flex-wrap gap-2">
            {emojis.map(([emoji, name], which) => (
              <button
                key={name}
                type="button"
                onClick={() => react(which)}
                className="flex items-center gap-1.5 rounded-full border border-neutral-400 px-3 py-1.5 text-sm tabular-nums hover:bg-neutral-200 dark:border-neutral-600 dark:hover:bg-neutral-800"
              >
                <span aria-hidden="true">{emoji}</span>
                <span className="sr-only">{name}, </span>
                {counts[which]}
              </button>
            ))}
          </div>
        </div>
      </div>
    </section>
  )
}

'use client'

import { useState } from 'react'
import { GravityStack } from '@/components/ui/gravity-stack'

const tags = [
  'accessibility',
  'animation',
  'design',
  'forms',
  'layout',
  'performance',
  'state',
  'testing',
  'types',
]

/**
 * Added children drop onto the pile. Removed ones vanish, and what lay on them falls. The others stay in
 * place.
 */
export function GravityStackTagCloudDemo() {
  const [chosen, setChosen] = useState(tags.slice(0, 6))

  const toggle = (tag: string) =>
    setChosen(chosen.includes(tag) ? chosen.filter((other) => other !== tag) : [...chosen, tag])

  return (
    <div className="flex flex-col">
      <fieldset className="flex flex-wrap gap-2 p-4">
        <legend className="sr-only">Tags</legend>
        {tags.map((tag) => (
          <button
            key={tag}
            type="button"
            aria-pressed={chosen.includes(tag)}
            onClick={() => toggle(tag)}
            className="rounded-md border border-neutral-400 px-2.5 py-1 text-sm aria-pressed:border-neutral-900 aria-pressed:bg-neutral-900 aria-pressed:text-white dark:border-neutral-600 dark:aria-pressed:border-white dark:aria-pressed:bg-white dark:aria-pressed:text-neutral-900"
          >
            {tag}
          </button>
        ))}
      </fieldset>
      <GravityStack className="h-64" stagger={80}>
        {chosen.map((tag) => (
          <span key={tag} className="rounded-full bg-indigo-300 px-5 py-2.5 font-medium text-indigo-950">
            #{tag}
          </span>
        ))}
      </GravityStack>
    </div>
  )
}

'use client'

import { useState } from 'react'
import { GravityStack } from '@/components/ui/gravity-stack'

const people = [
  {
    name: 'Amara Bello',
    from: 'Halden Ferries',
    quote: 'We stopped printing the timetable wall. Nobody has missed a boat since, except me.',
    look: 'size-24 text-3xl bg-rose-300 text-rose-950',
  },
  {
    name: 'Jonas Lind',
    from: 'Kilnworks',
    quote: 'Three potteries, one plan. I check it with clay on my hands.',
    look: 'size-20 text-2xl bg-amber-300 text-amber-950',
  },
  {
    name: 'Mei Tan',
    from: 'Orbit Radio',
    quote: 'It does what a whiteboard does, and it is still there on Monday.',
    look: 'size-28 text-4xl bg-sky-300 text-sky-950',
  },
  {
    name: 'Carlos Reis',
    from: 'Maison Vert',
    quote: 'My gardeners hate software. They ask me for this one.',
    look: 'size-20 text-2xl bg-emerald-300 text-emerald-950',
  },
  {
    name: 'Ida Holm',
    from: 'Salt & Pine',
    quote: 'Set up before the kettle had boiled. I timed it.',
    look: 'size-24 text-3xl bg-violet-300 text-violet-950',
  },
]

const initials = (name: string) => name.replace(/(\S)\S*\s*/g, '$1')

/** Avatars that roll: a press on one shows what that person says. Put a picture in place of the initials. */
export function GravityTestimonials() {
  const [person, setPerson] = useState(people[0])

  return (
    <section
      aria-labelledby="voices"
      className="bg-white text-neutral-950 dark:bg-neutral-950 dark:text-neutral-50"
    >
      <div className="mx-auto grid max-w-5xl items-center gap-8 px-6 py-12 md:grid-cols-2 md:gap-14">
        <div>
          <h2 id="voices" className="text-neutral-600 text-sm dark:text-neutral-400">
            Pick a face, hear a voice
          </h2>
          <figure className="mt-4 min-h-52 sm:min-h-56" aria-live="polite">
            <blockquote className="text-pretty font-medium text-2xl leading-snug tracking-tight sm:text-3xl">
              “{person.quote}”
            </blockquote>
            <figcaption className="mt-4 text-neutral-600 dark:text-neutral-400">
              {person.name}, {person.from}
            </figcaption>
          </figure>
        </div>
        <GravityStack
          className="h-80 rounded-3xl bg-neutral-100 dark:bg-neutral-900"
          bounce={0.45}
          friction={0.6}
        >
          {people.map((one) => (
            <button
              key={one.name}
              type="button"
              aria-label={`${initials(one.name)}, ${one.name}`}
              aria-pressed={one === person}
              onClick={() => setPerson(one)}
              className={`rounded-full font-semibold focus-visible:-outline-offset-4 aria-pressed:ring-4 aria-pressed:ring-current aria-pressed:ring-inset ${one.look}`}
            >
              {initials(one.name)}
            </button>
          ))}
        </GravityStack>
      </div>
    </section>
  )
}

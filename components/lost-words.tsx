import type { ComponentType } from 'react'
import { GravityStack } from './ui/gravity-stack'

const all = ['This', 'page', 'fell', 'down', 'and', 'nobody', 'picked', 'it', 'up.']

function Words() {
  return (
    <GravityStack className="pointer-events-none absolute inset-0 h-full *:pointer-events-auto">
      {all.map((word) => (
        <span
          key={word}
          className="rounded-2xl bg-foreground px-5 py-3 font-semibold text-2xl text-background sm:px-7 sm:py-4 sm:text-4xl"
        >
          {word}
        </span>
      ))}
    </GravityStack>
  )
}

/** What falls on the page for pages that are not there. */
export const lost: Record<string, ComponentType> = { words: Words }

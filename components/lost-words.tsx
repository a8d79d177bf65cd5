'use client'

import { lazy } from 'react'

// Every page carries its 404 with it; the component comes only where it falls.
const GravityStack = lazy(() => import('./ui/gravity-stack').then((file) => ({ default: file.GravityStack })))

const words = ['This', 'page', 'fell', 'down', 'and', 'nobody', 'picked', 'it', 'up.']

export function LostWords() {
  return (
    <GravityStack className="pointer-events-none absolute inset-0 h-full *:pointer-events-auto">
      {words.map((word) => (
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

'use client'

import { type ComponentType, lazy } from 'react'

// A page's figures are one file for the browser, which other pages don't load. Every page loads its 404 page.
const files = {
  ideas: async () => (await import('./ideas')).ideas,
  lost: async () => (await import('../lost-words')).lost,
  stability: async () => (await import('./stability')).stability,
}

const shown: Record<string, ComponentType> = {}

/** The figure of that name in one of the files. */
export function LiveFigure({ from, name }: { from: keyof typeof files; name: string }) {
  shown[name] ??= lazy(async () => ({ default: (await files[from]())[name] }))
  const Figure = shown[name]
  return <Figure />
}

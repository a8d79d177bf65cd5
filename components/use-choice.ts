'use client'

import { useSyncExternalStore } from 'react'
import { type Choice, choices, save } from '@/lib/preferences'

const changed = 'gravity-stack:choice'

// The script in <head> hears the last two first, and marks <html> anew.
const events = [changed, 'pageshow', 'storage']

function subscribe(notify: () => void) {
  for (const event of events) window.addEventListener(event, notify)
  return () => {
    for (const event of events) window.removeEventListener(event, notify)
  }
}

/** A remembered choice, shared by every switch of its kind on the page. */
export function useChoice(kind: Choice) {
  const [first] = choices[kind]
  const value = useSyncExternalStore(
    subscribe,
    () => document.documentElement.getAttribute(`data-${kind}`) ?? first,
    () => first,
  )
  const choose = (next: string) => {
    document.documentElement.setAttribute(`data-${kind}`, next)
    save(kind, next)
    window.dispatchEvent(new Event(changed))
  }
  return [value, choose] as const
}

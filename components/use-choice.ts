'use client'

import { useSyncExternalStore } from 'react'
import { type Choice, choices, save } from '@/lib/preferences'

const changed = 'gravity-stack:choice'

function subscribe(notify: () => void) {
  window.addEventListener(changed, notify)
  return () => window.removeEventListener(changed, notify)
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

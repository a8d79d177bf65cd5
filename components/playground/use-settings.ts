import { useEffect, useRef, useState } from 'react'
import { fromQuery, type Settings, toQuery } from '@/lib/playground'

/** ms without a change before the address is written: Safari refuses the hundredth time in half a minute. */
const addressDelay = 300

/** The settings that the address holds, once it is known, and how to change them and it. */
export function useSettings() {
  const [settings, setSettings] = useState<Settings>()
  const writing = useRef<ReturnType<typeof setTimeout>>(undefined)

  // The address is known in the browser only; until then the stage is empty.
  useEffect(() => {
    // Unless someone was quicker: a change counts from the moment the page can hear it.
    setSettings((known) => known ?? fromQuery(location.search))
    return () => clearTimeout(writing.current)
  }, [])

  function change(next: Partial<Settings>) {
    const changed = { ...(settings ?? fromQuery(location.search)), ...next }
    setSettings(changed)
    clearTimeout(writing.current)
    writing.current = setTimeout(() => {
      const query = toQuery(changed)
      try {
        history.replaceState(history.state, '', query ? `?${query}` : location.pathname)
      } catch {
        // Too often for this browser: the next change brings the address up to date.
      }
    }, addressDelay)
  }

  return [settings, change] as const
}

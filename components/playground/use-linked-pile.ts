import { useEffect, useState } from 'react'
import { fromFragment, type PileRecord } from '@/lib/pile-link'

/**
 * The recorded pile that the address holds: `unread` before that is known, `broken` where it can't be played.
 */
export function useLinkedPile() {
  const [linked, setLinked] = useState<PileRecord | 'unread' | 'broken' | undefined>('unread')

  useEffect(() => {
    const read = () => fromFragment(location.hash).then(setLinked, () => setLinked('broken'))
    read()
    addEventListener('hashchange', read)
    return () => removeEventListener('hashchange', read)
  }, [])

  return {
    linked,
    /** From here on there is a pile of one's own. */
    leave() {
      if (!linked || linked === 'unread') return
      setLinked(undefined)
      history.replaceState(history.state, '', location.pathname + location.search)
    },
  }
}

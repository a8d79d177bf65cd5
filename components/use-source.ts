import { useState } from 'react'
import { at } from '@/lib/address'

/**
 * A file of /source as HTML, highlighted when the site was built. It is fetched when somebody asks for it.
 */
export function useSource(name: string) {
  const [html, setHtml] = useState<string>()
  const [state, setState] = useState<'idle' | 'fetching' | 'failed'>('idle')

  async function load() {
    if (html || state === 'fetching') return
    setState('fetching')
    try {
      const response = await fetch(at(`/source/${name}.html.txt`))
      if (!response.ok) throw new Error(response.statusText)
      setHtml(await response.text())
    } catch {
      setState('failed')
    }
  }

  return { html, state, load }
}

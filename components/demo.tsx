'use client'

import { type ComponentType, lazy, useEffect, useRef } from 'react'
import { hydrateRoot } from 'react-dom/client'

/**
 * The files of registry/examples, each one of its own for the browser. A template for their names would list
 * each of them twice in the script.
 */
const examples: Record<string, () => Promise<Record<string, ComponentType>>> = {
  'gravity-stack-actions-demo': () => import('@/registry/examples/gravity-stack-actions-demo'),
  'gravity-stack-avatars-demo': () => import('@/registry/examples/gravity-stack-avatars-demo'),
  'gravity-stack-demo': () => import('@/registry/examples/gravity-stack-demo'),
  'gravity-stack-elevation-demo': () => import('@/registry/examples/gravity-stack-elevation-demo'),
  'gravity-stack-footer-demo': () => import('@/registry/examples/gravity-stack-footer-demo'),
  'gravity-stack-links-demo': () => import('@/registry/examples/gravity-stack-links-demo'),
  'gravity-stack-push-demo': () => import('@/registry/examples/gravity-stack-push-demo'),
  'gravity-stack-rising-demo': () => import('@/registry/examples/gravity-stack-rising-demo'),
  'gravity-stack-shapes-demo': () => import('@/registry/examples/gravity-stack-shapes-demo'),
  'gravity-stack-shelves-demo': () => import('@/registry/examples/gravity-stack-shelves-demo'),
  'gravity-stack-tag-cloud-demo': () => import('@/registry/examples/gravity-stack-tag-cloud-demo'),
  'gravity-stack-tilt-demo': () => import('@/registry/examples/gravity-stack-tilt-demo'),
  'gravity-stack-tinted-demo': () => import('@/registry/examples/gravity-stack-tinted-demo'),
}

async function load(name: string) {
  const [Example] = Object.values(await examples[name]())
  return Example
}

const onServer = typeof window === 'undefined'

const rendered: Record<string, ComponentType> = {}

/**
 * The example of that name; another `drop` mounts it anew. The page leaves the server's markup as it is, and
 * the example comes alive in a root of its own when it is about to be seen: until then it costs no script.
 */
export function Demo({ name, drop }: { name: string; drop: number }) {
  const box = useRef<HTMLDivElement>(null)
  const render = useRef<(drop: number) => void>(null)

  useEffect(() => {
    const element = box.current!
    const near = new IntersectionObserver(
      async ([entry]) => {
        if (!entry.isIntersecting) return
        const Example = await load(name)
        near.disconnect()
        if (render.current) return
        const root = hydrateRoot(element, <Example />)
        render.current = (drop) => root.render(<Example key={drop} />)
      },
      { rootMargin: '200px' },
    )
    near.observe(element)
    return () => near.disconnect()
  }, [name])

  useEffect(() => render.current?.(drop), [drop])

  if (onServer) {
    rendered[name] ??= lazy(async () => ({ default: await load(name) }))
    const Example = rendered[name]
    return (
      <div ref={box}>
        <Example />
      </div>
    )
  }
  // biome-ignore lint/security/noDangerouslySetInnerHtml: keeps the server's markup
  return <div ref={box} suppressHydrationWarning dangerouslySetInnerHTML={{ __html: '' }} />
}

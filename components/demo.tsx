'use client'

import { type ComponentType, lazy, useEffect, useRef } from 'react'
import { hydrateRoot, type Root } from 'react-dom/client'

/** Every file of registry/examples by its name, each in a file of its own for the browser. */
export const examples: Record<string, () => Promise<ComponentType>> = {
  'gravity-stack-actions-demo': async () =>
    (await import('@/registry/examples/gravity-stack-actions-demo')).GravityStackActionsDemo,
  'gravity-stack-avatars-demo': async () =>
    (await import('@/registry/examples/gravity-stack-avatars-demo')).GravityStackAvatarsDemo,
  'gravity-stack-demo': async () => (await import('@/registry/examples/gravity-stack-demo')).GravityStackDemo,
  'gravity-stack-elevation-demo': async () =>
    (await import('@/registry/examples/gravity-stack-elevation-demo')).GravityStackElevationDemo,
  'gravity-stack-footer-demo': async () =>
    (await import('@/registry/examples/gravity-stack-footer-demo')).GravityStackFooterDemo,
  'gravity-stack-links-demo': async () =>
    (await import('@/registry/examples/gravity-stack-links-demo')).GravityStackLinksDemo,
  'gravity-stack-shapes-demo': async () =>
    (await import('@/registry/examples/gravity-stack-shapes-demo')).GravityStackShapesDemo,
  'gravity-stack-tag-cloud-demo': async () =>
    (await import('@/registry/examples/gravity-stack-tag-cloud-demo')).GravityStackTagCloudDemo,
  'gravity-stack-tinted-demo': async () =>
    (await import('@/registry/examples/gravity-stack-tinted-demo')).GravityStackTintedDemo,
}

const onServer = typeof window === 'undefined'

const rendered: Record<string, ComponentType> = onServer
  ? Object.fromEntries(
      Object.entries(examples).map(([name, load]) => [name, lazy(async () => ({ default: await load() }))]),
    )
  : {}

/**
 * An example of the registry by its name; another `drop` mounts it anew. The page leaves the server's markup as it
 * is, and the example comes alive in a root of its own when it is about to be seen: until then it costs no script.
 */
export function Demo({ name, drop }: { name: string; drop: number }) {
  const box = useRef<HTMLDivElement>(null)
  const root = useRef<Root>(null)
  const example = useRef<ComponentType>(null)
  const latest = useRef(drop)
  latest.current = drop

  useEffect(() => {
    const near = new IntersectionObserver(
      async ([entry]) => {
        if (!entry.isIntersecting) return
        near.disconnect()
        const Example = await examples[name]()
        if (!box.current || root.current) return
        example.current = Example
        root.current = hydrateRoot(box.current, <Example key={latest.current} />)
      },
      { rootMargin: '200px' },
    )
    near.observe(box.current!)
    return () => near.disconnect()
  }, [name])

  useEffect(() => {
    const Example = example.current
    if (Example) root.current!.render(<Example key={drop} />)
  }, [drop])

  if (onServer) {
    const Example = rendered[name]
    return (
      <div ref={box}>
        <Example />
      </div>
    )
  }
  // biome-ignore lint/security/noDangerouslySetInnerHtml: what stands there from the server is kept, not replaced
  return <div ref={box} suppressHydrationWarning dangerouslySetInnerHTML={{ __html: '' }} />
}

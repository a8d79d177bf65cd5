'use client'

import dynamic from 'next/dynamic'
import type { ComponentType } from 'react'

// Each in a file of its own for the browser, so that a page brings only the demos that it shows.
/** Every file of registry/examples by its name. */
export const demos: Record<string, ComponentType> = {
  'gravity-stack-actions-demo': dynamic(() =>
    import('@/registry/examples/gravity-stack-actions-demo').then((file) => file.GravityStackActionsDemo),
  ),
  'gravity-stack-avatars-demo': dynamic(() =>
    import('@/registry/examples/gravity-stack-avatars-demo').then((file) => file.GravityStackAvatarsDemo),
  ),
  'gravity-stack-demo': dynamic(() =>
    import('@/registry/examples/gravity-stack-demo').then((file) => file.GravityStackDemo),
  ),
  'gravity-stack-elevation-demo': dynamic(() =>
    import('@/registry/examples/gravity-stack-elevation-demo').then((file) => file.GravityStackElevationDemo),
  ),
  'gravity-stack-footer-demo': dynamic(() =>
    import('@/registry/examples/gravity-stack-footer-demo').then((file) => file.GravityStackFooterDemo),
  ),
  'gravity-stack-links-demo': dynamic(() =>
    import('@/registry/examples/gravity-stack-links-demo').then((file) => file.GravityStackLinksDemo),
  ),
  'gravity-stack-shapes-demo': dynamic(() =>
    import('@/registry/examples/gravity-stack-shapes-demo').then((file) => file.GravityStackShapesDemo),
  ),
  'gravity-stack-tag-cloud-demo': dynamic(() =>
    import('@/registry/examples/gravity-stack-tag-cloud-demo').then((file) => file.GravityStackTagCloudDemo),
  ),
  'gravity-stack-tinted-demo': dynamic(() =>
    import('@/registry/examples/gravity-stack-tinted-demo').then((file) => file.GravityStackTintedDemo),
  ),
}

export function Demo({ name }: { name: string }) {
  const Found = demos[name]
  return <Found />
}

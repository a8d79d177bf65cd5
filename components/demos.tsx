import type { ComponentType } from 'react'
import { GravityStackActionsDemo } from '@/registry/examples/gravity-stack-actions-demo'
import { GravityStackAvatarsDemo } from '@/registry/examples/gravity-stack-avatars-demo'
import { GravityStackDemo } from '@/registry/examples/gravity-stack-demo'
import { GravityStackElevationDemo } from '@/registry/examples/gravity-stack-elevation-demo'
import { GravityStackFooterDemo } from '@/registry/examples/gravity-stack-footer-demo'
import { GravityStackLinksDemo } from '@/registry/examples/gravity-stack-links-demo'
import { GravityStackShapesDemo } from '@/registry/examples/gravity-stack-shapes-demo'
import { GravityStackTagCloudDemo } from '@/registry/examples/gravity-stack-tag-cloud-demo'
import { GravityStackTintedDemo } from '@/registry/examples/gravity-stack-tinted-demo'

/** Every file of registry/examples by its name. */
export const demos: Record<string, ComponentType> = {
  'gravity-stack-actions-demo': GravityStackActionsDemo,
  'gravity-stack-avatars-demo': GravityStackAvatarsDemo,
  'gravity-stack-demo': GravityStackDemo,
  'gravity-stack-elevation-demo': GravityStackElevationDemo,
  'gravity-stack-footer-demo': GravityStackFooterDemo,
  'gravity-stack-links-demo': GravityStackLinksDemo,
  'gravity-stack-shapes-demo': GravityStackShapesDemo,
  'gravity-stack-tag-cloud-demo': GravityStackTagCloudDemo,
  'gravity-stack-tinted-demo': GravityStackTintedDemo,
}

export function Demo({ name }: { name: string }) {
  const Found = demos[name]
  return <Found />
}

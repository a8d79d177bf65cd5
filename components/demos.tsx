import type { ComponentType } from 'react'
import { GravityStackDemo } from '@/registry/examples/gravity-stack-demo'
import { GravityStackElevationDemo } from '@/registry/examples/gravity-stack-elevation-demo'
import { GravityStackTintedDemo } from '@/registry/examples/gravity-stack-tinted-demo'

/** Every file of registry/examples by its name. */
export const demos: Record<string, ComponentType> = {
  'gravity-stack-demo': GravityStackDemo,
  'gravity-stack-elevation-demo': GravityStackElevationDemo,
  'gravity-stack-tinted-demo': GravityStackTintedDemo,
}

'use client'

import { type ComponentProps, lazy } from 'react'

// Every page carries its 404 with it; the component comes only where it falls.
const GravityStack = lazy(() => import('./ui/gravity-stack').then((file) => ({ default: file.GravityStack })))

export function LostWords(props: ComponentProps<typeof GravityStack>) {
  return <GravityStack {...props} />
}

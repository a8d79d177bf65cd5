'use client'

import { lazy } from 'react'

const onServer =
  typeof window === 'undefined'
    ? {
        ScenePlot: lazy(async () => ({ default: (await import('./plots')).ScenePlot })),
        SizePlot: lazy(async () => ({ default: (await import('./plots')).SizePlot })),
      }
    : undefined

// As high as the drawing, and left out of layout and paint until it is near.
const box = 'aspect-[380/270] [content-visibility:auto] print:[content-visibility:visible]'

/**
 * The plot of a scene, or of the costs by number of chips. It is drawn on the server alone, or the page would
 * bring each plot twice: as markup, and as what React makes the markup from. In the browser React keeps the
 * markup that is there.
 */
export function Drawn({ scene, measure = 0 }: { scene?: string; measure?: number }) {
  if (onServer) {
    const { ScenePlot, SizePlot } = onServer
    return <div className={box}>{scene ? <ScenePlot scene={scene} measure={measure} /> : <SizePlot />}</div>
  }
  // biome-ignore lint/security/noDangerouslySetInnerHtml: keeps the server's markup
  return <div className={box} suppressHydrationWarning dangerouslySetInnerHTML={{ __html: '' }} />
}

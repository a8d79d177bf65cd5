'use client'

import { type ComponentType, lazy } from 'react'

/** In a file of its own for the browser, so that a page brings only the figures that it shows. */
function figure(load: () => Promise<ComponentType>) {
  const Figure = lazy(async () => ({ default: await load() }))
  return () => <Figure />
}

export const FlightFigure = figure(async () => (await import('./flight')).FlightFigure)
export const FrictionFigure = figure(async () => (await import('./friction')).FrictionFigure)
export const HardScenesFigure = figure(async () => (await import('./hard')).HardScenesFigure)
export const ImpactFigure = figure(async () => (await import('./impact')).ImpactFigure)
export const IslandsFigure = figure(async () => (await import('./islands')).IslandsFigure)
export const SagFigure = figure(async () => (await import('./sag')).SagFigure)
export const ScenesFigure = figure(async () => (await import('./scenes')).ScenesFigure)
export const SubstepsFigure = figure(async () => (await import('./substeps')).SubstepsFigure)

'use client'

import { type ComponentType, lazy } from 'react'

// A page's figures are one file for the browser, which other pages don't bring.
const ideas = async () => (await import('./ideas')).ideas
const stability = async () => (await import('./stability')).stability

function figure(figures: () => Promise<Record<string, ComponentType>>, name: string) {
  const Figure = lazy(async () => ({ default: (await figures())[name] }))
  return () => <Figure />
}

export const FlightFigure = figure(ideas, 'flight')
export const FrictionFigure = figure(ideas, 'friction')
export const ImpactFigure = figure(ideas, 'impact')
export const IslandsFigure = figure(ideas, 'islands')
export const SagFigure = figure(ideas, 'sag')
export const SubstepsFigure = figure(ideas, 'substeps')
export const HardScenesFigure = figure(stability, 'hard')
export const ScenesFigure = figure(stability, 'known')

'use client'

import dynamic from 'next/dynamic'

// Each in a file of its own for the browser, so that a page brings only the figures that it shows.
export const FlightFigure = dynamic(() => import('./flight').then((file) => file.FlightFigure))
export const FrictionFigure = dynamic(() => import('./friction').then((file) => file.FrictionFigure))
export const HardScenesFigure = dynamic(() => import('./hard').then((file) => file.HardScenesFigure))
export const ImpactFigure = dynamic(() => import('./impact').then((file) => file.ImpactFigure))
export const IslandsFigure = dynamic(() => import('./islands').then((file) => file.IslandsFigure))
export const SagFigure = dynamic(() => import('./sag').then((file) => file.SagFigure))
export const ScenesFigure = dynamic(() => import('./scenes').then((file) => file.ScenesFigure))
export const SubstepsFigure = dynamic(() => import('./substeps').then((file) => file.SubstepsFigure))

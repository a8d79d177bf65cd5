import type { ComponentType } from 'react'
import { FlightFigure } from './flight'
import { FrictionFigure } from './friction'
import { ImpactFigure } from './impact'
import { IslandsFigure } from './islands'
import { SagFigure } from './sag'
import { SubstepsFigure } from './substeps'
import { UprightFigure } from './upright'

/** The figures of How it works. */
export const ideas: Record<string, ComponentType> = {
  flight: FlightFigure,
  friction: FrictionFigure,
  impact: ImpactFigure,
  islands: IslandsFigure,
  sag: SagFigure,
  substeps: SubstepsFigure,
  upright: UprightFigure,
}

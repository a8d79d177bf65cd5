import type { ComponentType } from 'react'
import { HardScenesFigure } from './hard'
import { ScenesFigure } from './scenes'

/** The figures of Stability. */
export const stability: Record<string, ComponentType> = { hard: HardScenesFigure, known: ScenesFigure }

import { type HardFigures, hardUnits, hardWords } from '@/scenes/hard'

/** A figure's words and unit; a share has none. */
export function named(figure: keyof HardFigures) {
  const [measure, unit] = [hardWords[figure], hardUnits[figure]]
  return unit.startsWith('of ') ? { measure: `${measure}, share`, unit: '' } : { measure, unit }
}

import { figure } from '@/lib/figure'

/** A figure with its unit, on one line; a time that never comes is said so. */
export function shortFigure(value: number, unit = ''): string {
  if (value === Number.POSITIVE_INFINITY) return 'never'
  return unit ? `${figure(value)}\u00a0${unit}` : figure(value)
}

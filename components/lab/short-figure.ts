/** Three digits; powers of ten where it is tiny; a time that never comes is said so. */
export function shortFigure(value: number): string {
  if (value === Number.POSITIVE_INFINITY) return 'never,'
  return value !== 0 && Math.abs(value) < 1e-3 ? value.toExponential(0) : String(Number(value.toPrecision(3)))
}

/** Three digits, powers of ten where it is tiny, with its unit; a time that never comes is said so. */
export function shortFigure(value: number, unit = ''): string {
  if (value === Number.POSITIVE_INFINITY) return 'never'
  const digits =
    value !== 0 && Math.abs(value) < 1e-3 ? value.toExponential(0) : String(Number(value.toPrecision(3)))
  return unit ? `${digits} ${unit}` : digits
}

/** Three significant digits; two and a power of ten, on one line, where zeros would have to be counted. */
export function figure(value: number | null | undefined): string {
  if (value === null || value === undefined) return '–'
  if (!Number.isFinite(value)) return '∞'
  const size = Math.abs(value)
  if (size === 0 || (size >= 1e-3 && size < 1e5)) {
    return value.toLocaleString('en', { maximumSignificantDigits: 3 })
  }
  const [digit, power] = value.toExponential(1).split('e').map(Number)
  const digits = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹']
  const raised = `${power < 0 ? '⁻' : ''}${[...String(Math.abs(power))].map((digit) => digits[Number(digit)]).join('')}`
  return digit === 1 ? `10${raised}` : `${digit.toFixed(1)}\u00a0·\u00a010${raised}`
}

/** A figure with its unit, on one line; a time that never comes is said so. */
export function shortFigure(value: number, unit = ''): string {
  if (value === Number.POSITIVE_INFINITY) return 'never'
  return unit ? `${figure(value)}\u00a0${unit}` : figure(value)
}

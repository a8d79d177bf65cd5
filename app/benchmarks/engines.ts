/** How each engine looks in every plot: a colour for the eye, a shape for those who see colours otherwise. */
type Look = {
  title: string
  shape: 'circle' | 'square' | 'triangle' | 'diamond' | 'cross'
  hollow?: boolean
}

export const looks: Record<string, Look> = {
  'gravity-stack': { title: 'Gravity Stack', shape: 'circle' },
  'box2d3-wasm-simd': { title: 'Box2D v3, wasm with SIMD', shape: 'square' },
  'box2d3-wasm': { title: 'Box2D v3, wasm', shape: 'square', hollow: true },
  rapier: { title: 'Rapier', shape: 'triangle' },
  'rapier-simd': { title: 'Rapier with SIMD', shape: 'triangle', hollow: true },
  'phaser-box2d': { title: 'Phaser Box2D', shape: 'diamond' },
  planck: { title: 'Planck', shape: 'diamond', hollow: true },
  'matter-js': { title: 'Matter', shape: 'circle', hollow: true },
  'p2-es': { title: 'p2-es', shape: 'cross' },
  'circle-chains': { title: 'Circle chains', shape: 'cross', hollow: true },
}

export const engineOrder = Object.keys(looks)

/** The settings' names as a reader meets them. */
export function settingTitle(setting: Record<string, number>) {
  const words = Object.entries(setting).map(([knob, value]) => {
    if (knob === 'hertz') return value >= 1e4 ? 'stiffest contacts' : `${value} Hz contacts`
    if (knob === 'trueInertia') return 'true inertia'
    if (knob === 'stiffness') return `stiffness ${value.toExponential(0).replace('+', '')}`
    if (knob === 'velocity') return `${value} velocity passes`
    if (knob === 'position') return `${value} position passes`
    const word = knob === 'substeps' ? 'sub-steps' : knob
    return `${value} ${value === 1 ? word.replace(/s$/, '') : word}`
  })
  return words.join(', ') || 'default'
}

/** Three significant digits; two and a power of ten, on one line, where zeros would have to be counted. */
export function figure(value: number | null | undefined): string {
  if (value === null || value === undefined) return '–'
  if (!Number.isFinite(value)) return '∞'
  if (value === 0) return '0'
  const size = Math.abs(value)
  if (size >= 1e-3 && size < 1e5) {
    const text = value.toPrecision(3)
    return text.includes('e')
      ? Math.round(value).toLocaleString('en')
      : Number(text).toLocaleString('en', { maximumSignificantDigits: 3 })
  }
  const [digit, power] = value.toExponential(1).split('e').map(Number)
  const digits = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹']
  const raised = `${power < 0 ? '⁻' : ''}${[...String(Math.abs(power))].map((digit) => digits[Number(digit)]).join('')}`
  return digit === 1 ? `10${raised}` : `${digit.toFixed(1)}\u00a0·\u00a010${raised}`
}

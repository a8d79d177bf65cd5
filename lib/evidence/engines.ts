import { figure } from '../figure'

/** How each engine looks in every plot: a colour for the eye, a shape for those who see colours otherwise. */
type Look = {
  title: string
  shape: 'circle' | 'square' | 'triangle' | 'diamond' | 'cross' | 'plus'
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
  'circle-chains': { title: 'Circle chains', shape: 'plus' },
}

export const engineOrder = Object.keys(looks)

/** The settings' names as a reader meets them. */
export function settingTitle(setting: Record<string, number>) {
  const words = Object.entries(setting).map(([knob, value]) => {
    if (knob === 'hertz') return value >= 1e4 ? 'stiffest contacts' : `${value} Hz contacts`
    if (knob === 'trueInertia') return 'true inertia'
    if (knob === 'stiffness') return `stiffness\u00a0${figure(value)}`
    if (knob === 'velocity') return `${value} velocity passes`
    if (knob === 'position') return `${value} position passes`
    const word = knob === 'substeps' ? 'sub-steps' : knob
    return `${value} ${value === 1 ? word.replace(/s$/, '') : word}`
  })
  return words.join(', ') || 'default'
}

import type { Engine } from './engine'

// Loaded one by one: a process that measures one engine holds no other engine's code.
const loaders: Record<string, () => Promise<Engine>> = {
  'gravity-stack': async () => (await import('./ours')).ours,
  'circle-chains': async () => (await import('./circle-chains')).circleChains,
  'matter-js': async () => (await import('./matter')).matter,
  planck: async () => (await import('./planck')).planck,
  'p2-es': async () => (await import('./p2')).p2es,
  rapier: async () => (await import('./rapier')).rapierPlain,
  'rapier-simd': async () => (await import('./rapier')).rapierSimd,
  'box2d3-wasm': async () => (await import('./box2d-wasm')).box2dWasm,
  'box2d3-wasm-simd': async () => (await import('./box2d-wasm')).box2dSimd,
  'phaser-box2d': async () => (await import('./phaser-box2d')).phaserBox2d,
}

export const engineNames = Object.keys(loaders)

/** The engine's name, settings and packages; `ours` is short for gravity-stack. */
export function describeEngine(name: string) {
  const load = loaders[name === 'ours' ? 'gravity-stack' : name]
  if (!load) throw new Error(`no engine "${name}"; there are ${engineNames.join(', ')}`)
  return load()
}

/** The engine, ready to start scenes. */
export async function loadEngine(name: string) {
  const engine = await describeEngine(name)
  await engine.load()
  return engine
}

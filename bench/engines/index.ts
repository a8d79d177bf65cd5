import { ours } from '../publish/report'
import type { Engine } from './engine'

/** Each engine's module, loaded late: a process that measures one engine holds no other engine's code. */
const engines: Record<string, [module: string, load: () => Promise<Engine>]> = {
  'gravity-stack': ['ours', async () => (await import('./ours')).ours],
  'circle-chains': ['circle-chains', async () => (await import('./circle-chains')).circleChains],
  'matter-js': ['matter', async () => (await import('./matter')).matter],
  planck: ['planck', async () => (await import('./planck')).planck],
  'p2-es': ['p2', async () => (await import('./p2')).p2es],
  rapier: ['rapier', async () => (await import('./rapier')).rapierPlain],
  'rapier-simd': ['rapier', async () => (await import('./rapier')).rapierSimd],
  'box2d3-wasm': ['box2d-wasm', async () => (await import('./box2d-wasm')).box2dWasm],
  'box2d3-wasm-simd': ['box2d-wasm', async () => (await import('./box2d-wasm')).box2dSimd],
  'phaser-box2d': ['phaser-box2d', async () => (await import('./phaser-box2d')).phaserBox2d],
}

export const engineNames = Object.keys(engines)

function known(name: string) {
  const engine = engines[name === 'ours' ? ours : name]
  if (!engine) throw new Error(`no engine "${name}"; there are ${engineNames.join(', ')}`)
  return engine
}

/** The engine's name, settings and packages; `ours` is short for gravity-stack. */
export const describeEngine = (name: string) => known(name)[1]()

/** The module in this folder that an engine is in. */
export const moduleOf = (name: string) => known(name)[0]

/** The engine, ready to start scenes. */
export async function loadEngine(name: string) {
  const engine = await describeEngine(name)
  await engine.load()
  return engine
}

// Bytes that a page has to load for each engine: its imports bundled, minified and gzipped, with WebAssembly.
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { gzipSync } from 'node:zlib'
import { root } from '../build/root'
import { script } from '../build/script'

export type Bytes = { name: string; minified: number; gzip: number }

const box2d = (flavour: string) =>
  join(root, `node_modules/box2d3-wasm/build/dist/es/${flavour}/Box2D.${flavour}`)

/** The component with Motion's part, as its row in the table of all engines. */
const component = `export * from './components/ui/gravity-stack'`

const imports: { name: string; code: string; wasm?: string }[] = [
  { name: 'gravity-stack', code: `export { createWorld } from './registry/gravity-stack/world'` },
  { name: 'gravity-stack, component and all', code: component },
  { name: 'circle-chains', code: `export { circleChains } from './bench/engines/circle-chains'` },
  { name: 'matter-js', code: `import Matter from 'matter-js'; export default Matter` },
  { name: 'planck', code: `export { World, Box, Circle, Settings, Vec2 } from 'planck'` },
  {
    name: 'p2-es',
    code: `export { World, Body, Box, Capsule, Circle, GSSolver, SAPBroadphase } from 'p2-es'`,
  },
  { name: 'rapier', code: `import R from '@dimforge/rapier2d-compat'; export default R` },
  { name: 'rapier-simd', code: `import R from '@dimforge/rapier2d-simd-compat'; export default R` },
  {
    name: 'box2d3-wasm',
    code: `export { default } from ${JSON.stringify(`${box2d('compat')}.mjs`)}`,
    wasm: `${box2d('compat')}.wasm`,
  },
  {
    name: 'box2d3-wasm-simd',
    code: `export { default } from ${JSON.stringify(`${box2d('deluxe')}.mjs`)}`,
    wasm: `${box2d('deluxe')}.wasm`,
  },
  {
    name: 'phaser-box2d',
    code: `export { ${[
      'b2CreateWorldArray',
      'b2CreateWorld',
      'b2DefaultWorldDef',
      'b2DefaultBodyDef',
      'b2DefaultShapeDef',
      'b2CreateBody',
      'b2DestroyBody',
      'b2CreatePolygonShape',
      'b2CreateCapsuleShape',
      'b2CreateCircleShape',
      'b2MakeBox',
      'b2MakeRoundedBox',
      'b2MakeRot',
      'b2World_Step',
      'b2Body_GetPosition',
      'b2Body_GetRotation',
    ].join(', ')} } from './node_modules/phaser-box2d/dist/PhaserBox2D.js'`,
  },
]

/** React and `cn` are on the page already; Node's own modules are only reached for outside a browser. */
const elsewhere = /^(react|react-dom|cn|module|fs|path|url|worker_threads)$|^(react\/|node:)/

const bundle = (code: string, folder = root) =>
  script(code, folder, 'esm', { platform: 'browser', external: elsewhere })

/** What the component in `folder` weighs, minified and gzipped. */
export const componentBytes = async (folder = root) =>
  gzipSync(await bundle(component, folder), { level: 9 }).length

export async function engineBytes(): Promise<Bytes[]> {
  const rows: Bytes[] = []
  for (const { name, code, wasm } of imports) {
    const built = await bundle(code).catch((error: Error) =>
      console.error(`${name} is not weighed: ${error.message}`),
    )
    if (!built) continue
    const minified = Buffer.from(built)
    const binary = wasm ? readFileSync(wasm) : Buffer.alloc(0)
    rows.push({
      name,
      minified: minified.length + binary.length,
      gzip: gzipSync(minified, { level: 9 }).length + (wasm ? gzipSync(binary, { level: 9 }).length : 0),
    })
  }
  return rows
}

import { cornerRadius } from '../../scenes/exact-distance'
import { frame, numbersPerChip } from '../../scenes/scene'
import { type Engine, pixelsPerMetre as ppm, walls } from './engine'

// biome-ignore lint/suspicious/noExplicitAny: one adapter for two builds with types apart
type Box2D = any

// The package's entry picks the SIMD build where Node can run it. Both builds are measured, so files are
// named.
const builds = {
  // @ts-expect-error no types beside the file
  plain: () => import('../../node_modules/box2d3-wasm/build/dist/es/compat/Box2D.compat.mjs'),
  // @ts-expect-error no types beside the file
  simd: () => import('../../node_modules/box2d3-wasm/build/dist/es/deluxe/Box2D.deluxe.mjs'),
}

/** The engine clamps contact stiffness to a quarter of the sub-step rate; "stiff" asks for all of that. */
const stiff = 1e4

function box2d(name: string, build: keyof typeof builds): Engine {
  let b2: Box2D
  return {
    name,
    packages: ['box2d3-wasm'],
    settings: [
      { substeps: 4 },
      { substeps: 2 },
      { substeps: 8 },
      { substeps: 16 },
      { substeps: 4, hertz: stiff },
      { substeps: 8, hertz: stiff },
      { substeps: 16, hertz: stiff },
      { substeps: 32, hertz: stiff },
    ],
    accurate: { substeps: 8, hertz: stiff },
    ...(name === 'box2d3-wasm' ? { sameBitsAs: 'box2d3-wasm-simd' } : {}),
    async load() {
      const { default: factory } = (await builds[build]()) as { default: () => Promise<Box2D> }
      b2 ??= await factory()
    },
    start(scene, chips, setting, sleep) {
      const { conditions } = scene
      const worldDef = b2.b2DefaultWorldDef()
      worldDef.gravity.Set(0, conditions.gravity / ppm)
      worldDef.enableSleep = sleep
      worldDef.restitutionThreshold = conditions.bounceThreshold / ppm
      if (setting.hertz) worldDef.contactHertz = setting.hertz
      const world = b2.b2CreateWorld(worldDef)
      const shapeDef = b2.b2DefaultShapeDef()
      shapeDef.material.friction = conditions.friction
      shapeDef.material.restitution = conditions.bounce
      for (const wall of walls(scene)) {
        const bodyDef = b2.b2DefaultBodyDef()
        bodyDef.position.Set(wall.x / ppm, wall.y / ppm)
        const body = b2.b2CreateBody(world, bodyDef)
        b2.b2CreatePolygonShape(body, shapeDef, b2.b2MakeBox(wall.halfWidth / ppm, wall.halfHeight / ppm))
      }
      const bodies = chips.map((chip) => {
        const bodyDef = b2.b2DefaultBodyDef()
        bodyDef.type = b2.b2BodyType.b2_dynamicBody
        bodyDef.position.Set(chip.x / ppm, chip.y / ppm)
        bodyDef.rotation = b2.b2MakeRot(chip.angle)
        bodyDef.linearVelocity.Set((chip.vx ?? 0) / ppm, (chip.vy ?? 0) / ppm)
        bodyDef.angularVelocity = chip.spin ?? 0
        bodyDef.linearDamping = conditions.linearDamping
        bodyDef.angularDamping = conditions.angularDamping
        const body = b2.b2CreateBody(world, bodyDef)
        const r = cornerRadius(chip) / ppm
        const a = chip.width / 2 / ppm - r
        const b = chip.height / 2 / ppm - r
        shapeDef.density = chip.density ?? 1
        if (a < 1e-6 && b < 1e-6) {
          const circle = new b2.b2Circle()
          circle.center.Set(0, 0)
          circle.radius = r
          b2.b2CreateCircleShape(body, shapeDef, circle)
        } else if (a < 1e-6 || b < 1e-6) {
          const capsule = new b2.b2Capsule()
          capsule.center1.Set(-a, -b)
          capsule.center2.Set(a, b)
          capsule.radius = r
          b2.b2CreateCapsuleShape(body, shapeDef, capsule)
        } else {
          const polygon = r > 0 ? b2.b2MakeRoundedBox(a, b, r) : b2.b2MakeBox(a, b)
          b2.b2CreatePolygonShape(body, shapeDef, polygon)
        }
        return body
      })
      return {
        step: () => b2.b2World_Step(world, frame, setting.substeps),
        // Reading properties of its objects costs more than a step: position, cosine and sine are read from
        // memory.
        read(out) {
          bodies.forEach((body, i) => {
            const transform = b2.b2Body_GetTransform(body)
            const velocity = b2.b2Body_GetLinearVelocity(body)
            const memory = new Float32Array(b2.HEAPU8.buffer)
            const at = transform.$$.ptr / 4
            const moves = velocity.$$.ptr / 4
            const k = i * numbersPerChip
            out[k] = memory[at] * ppm
            out[k + 1] = memory[at + 1] * ppm
            out[k + 2] = Math.atan2(memory[at + 3], memory[at + 2])
            out[k + 3] = memory[moves] * ppm
            out[k + 4] = memory[moves + 1] * ppm
            out[k + 5] = b2.b2Body_GetAngularVelocity(body)
            transform.delete()
            velocity.delete()
          })
        },
        free: () => b2.b2DestroyWorld(world),
      }
    },
  }
}

export const box2dWasm = box2d('box2d3-wasm', 'plain')
export const box2dSimd = box2d('box2d3-wasm-simd', 'simd')

import { cornerRadius } from '../../scenes/exact-distance'
import { frame, numbersPerChip } from '../../scenes/scene'
import { type Engine, pixelsPerMetre as ppm, walls } from './engine'

/** The engine clamps contact stiffness to a quarter of the sub-step rate; "stiff" asks for all of that. */
const stiff = 1e4

// biome-ignore lint/suspicious/noExplicitAny: the package ships no types
let b2: any
// biome-ignore lint/suspicious/noExplicitAny: the package ships no types
let world: any

export const phaserBox2d: Engine = {
  name: 'phaser-box2d',
  packages: ['phaser-box2d'],
  settings: [
    { substeps: 4 },
    { substeps: 2 },
    { substeps: 8 },
    { substeps: 4, hertz: stiff },
    { substeps: 8, hertz: stiff },
    { substeps: 16, hertz: stiff },
    { substeps: 32, hertz: stiff },
  ],
  accurate: { substeps: 8, hertz: stiff },
  brief: true,
  async load() {
    // @ts-expect-error no types in the package, and its "main" names a file that is not there
    b2 ??= await import('../../node_modules/phaser-box2d/dist/PhaserBox2D.js')
    b2.b2CreateWorldArray()
  },
  start(scene, chips, setting, sleep) {
    const { conditions } = scene
    // Only 32 worlds can ever be made and none is given back: one world serves all, emptied after each run.
    if (!world) {
      const worldDef = b2.b2DefaultWorldDef()
      world = b2.b2CreateWorld(worldDef)
    }
    b2.b2World_EnableSleeping(world, sleep)
    b2.b2World_SetGravity(world, new b2.b2Vec2(0, conditions.gravity / ppm))
    b2.b2World_SetRestitutionThreshold(world, conditions.bounceThreshold / ppm)
    // 10 and 5 m/s are the default damping ratio and push-out.
    b2.b2World_SetContactTuning(world, setting.hertz ?? 30, 10, 5)
    const shapeDef = b2.b2DefaultShapeDef()
    shapeDef.friction = conditions.friction
    shapeDef.restitution = conditions.bounce
    const fixed = walls(scene).map((wall) => {
      const bodyDef = b2.b2DefaultBodyDef()
      bodyDef.position = new b2.b2Vec2(wall.x / ppm, wall.y / ppm)
      const body = b2.b2CreateBody(world, bodyDef)
      b2.b2CreatePolygonShape(body, shapeDef, b2.b2MakeBox(wall.halfWidth / ppm, wall.halfHeight / ppm))
      return body
    })
    const bodies = chips.map((chip) => {
      const bodyDef = b2.b2DefaultBodyDef()
      bodyDef.type = b2.b2BodyType.b2_dynamicBody
      bodyDef.position = new b2.b2Vec2(chip.x / ppm, chip.y / ppm)
      bodyDef.rotation = b2.b2MakeRot(chip.angle)
      bodyDef.linearVelocity = new b2.b2Vec2((chip.vx ?? 0) / ppm, (chip.vy ?? 0) / ppm)
      bodyDef.angularVelocity = chip.spin ?? 0
      bodyDef.linearDamping = conditions.linearDamping
      bodyDef.angularDamping = conditions.angularDamping
      const body = b2.b2CreateBody(world, bodyDef)
      const r = cornerRadius(chip) / ppm
      const a = chip.width / 2 / ppm - r
      const b = chip.height / 2 / ppm - r
      shapeDef.density = chip.density ?? 1
      if (a < 1e-6 && b < 1e-6) {
        b2.b2CreateCircleShape(body, shapeDef, new b2.b2Circle(new b2.b2Vec2(0, 0), r))
      } else if (a < 1e-6 || b < 1e-6) {
        const capsule = new b2.b2Capsule()
        capsule.center1 = new b2.b2Vec2(-a, -b)
        capsule.center2 = new b2.b2Vec2(a, b)
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
      read(out) {
        bodies.forEach((body, i) => {
          const p = b2.b2Body_GetPosition(body)
          const v = b2.b2Body_GetLinearVelocity(body)
          const angle = b2.b2Rot_GetAngle(b2.b2Body_GetRotation(body))
          const spin = b2.b2Body_GetAngularVelocity(body)
          out.set([p.x * ppm, p.y * ppm, angle, v.x * ppm, v.y * ppm, spin], i * numbersPerChip)
        })
      },
      free() {
        for (const body of [...bodies, ...fixed]) b2.b2DestroyBody(body)
      },
    }
  },
}

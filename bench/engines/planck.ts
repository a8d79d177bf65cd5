import { type Body, Box, Circle, Settings, Vec2, World } from 'planck'
import { cornerRadius } from '../../scenes/exact-distance'
import { massOf } from '../../scenes/references'
import { frame, numbersPerChip } from '../../scenes/scene'
import { type Engine, pixelsPerMetre as ppm, walls } from './engine'

export const planck: Engine = {
  name: 'planck',
  packages: ['planck'],
  settings: [
    { substeps: 1, velocity: 8, position: 3 },
    { substeps: 1, velocity: 20, position: 10 },
    { substeps: 2, velocity: 8, position: 3 },
    { substeps: 4, velocity: 2, position: 1 },
    { substeps: 4, velocity: 8, position: 3 },
    { substeps: 8, velocity: 4, position: 2 },
    { substeps: 16, velocity: 8, position: 3 },
  ],
  accurate: { substeps: 4, velocity: 8, position: 3 },
  brief: true,
  async load() {},
  start(scene, chips, { substeps, velocity, position }, sleep) {
    const { conditions } = scene
    Settings.velocityThreshold = conditions.bounceThreshold / ppm
    const world = new World({ gravity: Vec2(0, conditions.gravity / ppm), allowSleep: sleep })
    // Its boxes have a skin outside their corners. It is taken off here, so that they are as large as all
    // others.
    const skin = Settings.polygonRadius
    const surface = { friction: conditions.friction, restitution: conditions.bounce }
    for (const wall of walls(scene)) {
      const body = world.createBody({ position: Vec2(wall.x / ppm, wall.y / ppm) })
      const shape = new Box(wall.halfWidth / ppm - skin, wall.halfHeight / ppm - skin)
      body.createFixture({ shape, ...surface })
    }
    const bodies = chips.map((chip) => {
      const body: Body = world.createBody({
        type: 'dynamic',
        position: Vec2(chip.x / ppm, chip.y / ppm),
        angle: chip.angle,
        linearVelocity: Vec2((chip.vx ?? 0) / ppm, (chip.vy ?? 0) / ppm),
        angularVelocity: chip.spin ?? 0,
        linearDamping: conditions.linearDamping,
        angularDamping: conditions.angularDamping,
      })
      // No rounded shapes here: a rounded chip is one or two boxes with a circle at each corner.
      const r = cornerRadius(chip) / ppm
      const a = chip.width / 2 / ppm - r
      const b = chip.height / 2 / ppm - r
      const add = (shape: Box | Circle) => body.createFixture({ shape, density: 1, ...surface })
      if (a > 0) add(new Box(r > 0 ? a : a - skin, b + r - skin))
      if (b > 0 && r > 0) add(new Box(a + r - skin, b))
      if (r > 0) {
        for (const x of a > 0 ? [-a, a] : [0])
          for (const y of b > 0 ? [-b, b] : [0]) add(new Circle(Vec2(x, y), r))
      }
      const { mass, inertia } = massOf(chip)
      body.setMassData({ mass: mass / ppm ** 2, I: inertia / ppm ** 4, center: Vec2(0, 0) })
      return body
    })
    return {
      step() {
        for (let i = 0; i < substeps; i++) world.step(frame / substeps, velocity, position)
      },
      read(out) {
        bodies.forEach((body, i) => {
          const p = body.getPosition()
          const v = body.getLinearVelocity()
          out.set(
            [p.x * ppm, p.y * ppm, body.getAngle(), v.x * ppm, v.y * ppm, body.getAngularVelocity()],
            i * numbersPerChip,
          )
        })
      },
      free() {},
    }
  },
}

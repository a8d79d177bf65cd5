import * as p2 from 'p2-es'
import { cornerRadius } from '../../scenes/exact-distance'
import { massOf } from '../../scenes/references'
import { frame, numbersPerChip } from '../../scenes/scene'
import { type Engine, pixelsPerMetre as ppm, walls } from './engine'

export const p2es: Engine = {
  name: 'p2-es',
  packages: ['p2-es'],
  settings: [
    { substeps: 1, iterations: 10 },
    { substeps: 1, iterations: 50 },
    { substeps: 2, iterations: 10 },
    { substeps: 4, iterations: 10 },
    { substeps: 8, iterations: 10 },
    { substeps: 8, iterations: 10, stiffness: 1e7 },
    { substeps: 16, iterations: 10, stiffness: 1e7 },
  ],
  accurate: { substeps: 8, iterations: 10, stiffness: 1e7 },
  brief: true,
  async load() {},
  start(scene, chips, { substeps, iterations, stiffness }, sleep) {
    const { conditions } = scene
    const world = new p2.World({
      gravity: [0, conditions.gravity / ppm],
      solver: new p2.GSSolver({ iterations, tolerance: 0 }),
      broadphase: new p2.SAPBroadphase(),
    })
    if (sleep) world.sleepMode = p2.World.BODY_SLEEPING
    world.defaultContactMaterial.friction = conditions.friction
    world.defaultContactMaterial.restitution = conditions.bounce
    if (stiffness) world.setGlobalStiffness(stiffness)
    for (const wall of walls(scene)) {
      const body = new p2.Body({ mass: 0, position: [wall.x / ppm, wall.y / ppm] })
      body.addShape(new p2.Box({ width: (2 * wall.halfWidth) / ppm, height: (2 * wall.halfHeight) / ppm }))
      world.addBody(body)
    }
    const bodies = chips.map((chip) => {
      const { mass, inertia } = massOf(chip)
      const body = new p2.Body({
        mass: mass / ppm ** 2,
        position: [chip.x / ppm, chip.y / ppm],
        velocity: [(chip.vx ?? 0) / ppm, (chip.vy ?? 0) / ppm],
        angle: chip.angle,
        angularVelocity: chip.spin ?? 0,
        // Shares lost in a second, not rates.
        damping: -Math.expm1(-conditions.linearDamping),
        angularDamping: -Math.expm1(-conditions.angularDamping),
      })
      const r = cornerRadius(chip) / ppm
      const a = chip.width / 2 / ppm - r
      const b = chip.height / 2 / ppm - r
      if (a <= 0 && b <= 0) body.addShape(new p2.Circle({ radius: r }))
      else if (b <= 0) body.addShape(new p2.Capsule({ length: 2 * a, radius: r }))
      else if (a <= 0) body.addShape(new p2.Capsule({ length: 2 * b, radius: r }), [0, 0], Math.PI / 2)
      else {
        // No rounded boxes here: two boxes and a circle at each corner.
        body.addShape(new p2.Box({ width: 2 * a, height: 2 * (b + r) }))
        if (r > 0) {
          body.addShape(new p2.Box({ width: 2 * (a + r), height: 2 * b }))
          for (const x of [-a, a])
            for (const y of [-b, b]) body.addShape(new p2.Circle({ radius: r }), [x, y])
        }
      }
      // The package inverts the inertia of a body of mass 1; give it the true one.
      body.inertia = inertia / ppm ** 4
      body.invInertia = 1 / body.inertia
      body.updateSolveMassProperties()
      world.addBody(body)
      return body
    })
    return {
      step() {
        for (let i = 0; i < substeps; i++) world.step(frame / substeps)
      },
      read(out) {
        bodies.forEach((body, i) => {
          const [x, y] = body.position
          const [vx, vy] = body.velocity
          const state = [x * ppm, y * ppm, body.angle, vx * ppm, vy * ppm, body.angularVelocity]
          out.set(state, i * numbersPerChip)
        })
      },
      free: () => world.clear(),
    }
  },
}

import Matter from 'matter-js'
import { cornerRadius } from '../../scenes/exact-distance'
import { massOf } from '../../scenes/references'
import { frame, numbersPerChip } from '../../scenes/scene'
import { type Engine, walls } from './engine'

const milliseconds = 1000 * frame

export const matter: Engine = {
  name: 'matter-js',
  packages: ['matter-js'],
  settings: [
    { substeps: 1, velocity: 4, position: 6 },
    { substeps: 1, velocity: 10, position: 10 },
    { substeps: 2, velocity: 4, position: 6 },
    { substeps: 4, velocity: 4, position: 6 },
    { substeps: 8, velocity: 4, position: 6 },
    { substeps: 8, velocity: 10, position: 10 },
    // Its bodies have four times the inertia of their shape unless told otherwise.
    { substeps: 4, velocity: 4, position: 6, trueInertia: 1 },
  ],
  accurate: { substeps: 8, velocity: 10, position: 10 },
  brief: true,
  async load() {},
  start(scene, chips, { substeps, velocity, position, trueInertia }, sleep) {
    const { conditions } = scene
    const engine = Matter.Engine.create({
      velocityIterations: velocity,
      positionIterations: position,
      enableSleeping: sleep,
    })
    // Pixels and milliseconds: gravity is y · scale in px/ms².
    engine.gravity.y = 1
    engine.gravity.scale = conditions.gravity / 1e6
    const surface = { friction: conditions.friction, restitution: conditions.bounce }
    for (const wall of walls(scene)) {
      const options = { isStatic: true, ...surface }
      const body = Matter.Bodies.rectangle(wall.x, wall.y, 2 * wall.halfWidth, 2 * wall.halfHeight, options)
      Matter.Composite.add(engine.world, body)
    }
    const bodies = chips.map((chip) => {
      const radius = cornerRadius(chip)
      // Air drag is a share of the velocity lost in 1/60 s, the same for spin.
      const frictionAir = conditions.linearDamping * frame
      const options = { ...surface, frictionAir, density: 0.001 * (chip.density ?? 1) }
      const round = radius === chip.width / 2 && radius === chip.height / 2
      const body = round
        ? Matter.Bodies.circle(chip.x, chip.y, radius, options)
        : Matter.Bodies.rectangle(chip.x, chip.y, chip.width, chip.height, {
            ...options,
            ...(radius > 0 ? { chamfer: { radius } } : {}),
          })
      if (trueInertia) {
        const { mass, inertia } = massOf(chip)
        Matter.Body.setMass(body, mass / 1000)
        Matter.Body.setInertia(body, inertia / 1000)
      }
      Matter.Body.setAngle(body, chip.angle)
      Matter.Body.setVelocity(body, { x: (chip.vx ?? 0) * frame, y: (chip.vy ?? 0) * frame })
      Matter.Body.setAngularVelocity(body, (chip.spin ?? 0) * frame)
      Matter.Composite.add(engine.world, body)
      return body
    })
    return {
      step() {
        for (let i = 0; i < substeps; i++) Matter.Engine.update(engine, milliseconds / substeps)
      },
      read(out) {
        bodies.forEach((body, i) => {
          const v = Matter.Body.getVelocity(body)
          const { x, y } = body.position
          const spin = Matter.Body.getAngularVelocity(body) / frame
          out.set([x, y, body.angle, v.x / frame, v.y / frame, spin], i * numbersPerChip)
        })
      },
      free: () => Matter.Engine.clear(engine),
    }
  },
}

import type Rapier from '@dimforge/rapier2d-compat'
import { cornerRadius } from '../../scenes/exact-distance'
import { massOf } from '../../scenes/references'
import { frame, numbersPerChip } from '../../scenes/scene'
import { type Engine, pixelsPerMetre as ppm, walls } from './engine'

type Api = typeof Rapier

const builds = {
  'rapier2d-compat': async () => (await import('@dimforge/rapier2d-compat')).default,
  'rapier2d-simd-compat': async () =>
    (await import('@dimforge/rapier2d-simd-compat')).default as unknown as Api,
}

function rapier(name: string, build: keyof typeof builds): Engine {
  let api: Api
  return {
    name,
    packages: [`@dimforge/${build}`],
    settings: [
      { iterations: 4 },
      { iterations: 2 },
      { iterations: 8 },
      { iterations: 4, hertz: 60 },
      { iterations: 8, hertz: 120 },
      { iterations: 16, hertz: 240 },
      { iterations: 32, hertz: 480 },
      // Smaller frames are its other way to smaller steps.
      { iterations: 4, frames: 4 },
      { iterations: 4, frames: 4, hertz: 240 },
    ],
    accurate: { iterations: 8, hertz: 120 },
    ...(build === 'rapier2d-compat' ? { brief: true } : {}),
    async load() {
      api ??= await builds[build]()
      await api.init()
    },
    start(scene, chips, { iterations, hertz, frames = 1 }, sleep) {
      const { conditions } = scene
      const world = new api.World({ x: 0, y: conditions.gravity / ppm })
      world.timestep = frame / frames
      world.integrationParameters.numSolverIterations = iterations
      if (hertz) world.integrationParameters.contact_natural_frequency = hertz
      const dress = <T extends Rapier.ColliderDesc>(collider: T) =>
        collider.setFriction(conditions.friction).setRestitution(conditions.bounce)
      for (const wall of walls(scene)) {
        const body = world.createRigidBody(
          api.RigidBodyDesc.fixed().setTranslation(wall.x / ppm, wall.y / ppm),
        )
        world.createCollider(
          dress(api.ColliderDesc.cuboid(wall.halfWidth / ppm, wall.halfHeight / ppm)),
          body,
        )
      }
      const bodies = chips.map((chip) => {
        const body = world.createRigidBody(
          api.RigidBodyDesc.dynamic()
            .setTranslation(chip.x / ppm, chip.y / ppm)
            .setRotation(chip.angle)
            .setLinvel((chip.vx ?? 0) / ppm, (chip.vy ?? 0) / ppm)
            .setAngvel(chip.spin ?? 0)
            .setLinearDamping(conditions.linearDamping)
            .setAngularDamping(conditions.angularDamping)
            .setCanSleep(sleep),
        )
        const r = cornerRadius(chip) / ppm
        const a = chip.width / 2 / ppm - r
        const b = chip.height / 2 / ppm - r
        const shape =
          a <= 1e-6 && b <= 1e-6
            ? api.ColliderDesc.ball(r)
            : a <= 1e-6
              ? api.ColliderDesc.capsule(b, r)
              : b <= 1e-6
                ? api.ColliderDesc.capsule(a, r).setRotation(Math.PI / 2)
                : r > 0
                  ? api.ColliderDesc.roundCuboid(a, b, r)
                  : api.ColliderDesc.cuboid(a, b)
        const { mass, inertia } = massOf(chip)
        // Its own figures for capsules are off by a per cent.
        dress(shape).setMassProperties(mass / ppm ** 2, { x: 0, y: 0 }, inertia / ppm ** 4)
        world.createCollider(shape, body)
        return body
      })
      return {
        step() {
          for (let i = 0; i < frames; i++) world.step()
        },
        read(out) {
          bodies.forEach((body, i) => {
            const p = body.translation()
            const v = body.linvel()
            const state = [p.x * ppm, p.y * ppm, body.rotation(), v.x * ppm, v.y * ppm, body.angvel()]
            out.set(state, i * numbersPerChip)
          })
        },
        free: () => world.free(),
      }
    },
  }
}

export const rapierPlain = rapier('rapier', 'rapier2d-compat')
export const rapierSimd = rapier('rapier-simd', 'rapier2d-simd-compat')

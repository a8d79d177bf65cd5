import { createWorld } from '../../registry/gravity-stack/world'
import { frame, numbersPerChip } from '../../scenes/scene'
import type { Engine } from './engine'

export const ours: Engine = {
  name: 'gravity-stack',
  packages: [],
  settings: [{}, { substeps: 2 }, { substeps: 4 }, { substeps: 8 }, { substeps: 16 }, { substeps: 32 }],
  accurate: { substeps: 16 },
  async load() {},
  start(scene, chips, setting, sleep) {
    const world = createWorld({
      width: scene.width,
      height: scene.height,
      ...scene.conditions,
      sleep,
      ...(setting.substeps ? { substeps: setting.substeps } : {}),
    })
    const ids = chips.map((chip) => world.add(chip))
    return {
      step: () => world.step(frame),
      read(out) {
        ids.forEach((id, i) => {
          const { x, y, angle, vx, vy, spin } = world.read(id)
          out.set([x, y, angle, vx, vy, spin], i * numbersPerChip)
        })
      },
      free() {},
      work: () => ({ ...world.stats }),
    }
  },
}

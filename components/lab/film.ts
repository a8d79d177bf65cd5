import { createWorld } from '@/registry/gravity-stack/world'
import { Film, frame, numbersPerChip, type Scene } from '@/scenes/scene'

/** A named scene through the component's solver, every frame kept, as the benchmark runs it. */
export function filmOf(scene: Scene, seed = 1): Film {
  const film = new Film(scene, scene.build(seed))
  const { width, height } = scene
  const world = createWorld({ width, height, ...scene.conditions, sleep: false })
  const ids = film.chips.map((chip) => world.add(chip))
  for (let n = 1; n <= film.frames; n++) {
    world.step(frame)
    const now = film.at(n)
    ids.forEach((id, i) => {
      const { x, y, angle, vx, vy, spin } = world.read(id)
      now.set([x, y, angle, vx, vy, spin], i * numbersPerChip)
    })
  }
  return film
}

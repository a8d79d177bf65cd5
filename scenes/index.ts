import { exactScenes } from './exact'
import { pileScenes } from './piles'
import type { Scene } from './scene'

/** Every named scene, in the order the tables print them. */
export const scenes: Scene[] = [...exactScenes, ...pileScenes]

export function sceneNamed(name: string) {
  const scene = scenes.find((candidate) => candidate.name === name)
  if (!scene) throw new Error(`no scene "${name}"; there are ${scenes.map((s) => s.name).join(', ')}`)
  return scene
}

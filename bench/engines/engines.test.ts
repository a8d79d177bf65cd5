import { expect, it } from 'vitest'
import { sceneNamed } from '../../scenes'
import { simulateScene } from '../accuracy/trajectory'
import { sourcesOf } from '../build/sources'
import { describeEngine, engineNames, loadEngine, moduleOf } from '.'

it('a build that shares another one’s errors moves every chip by the same bits', async () => {
  const all = await Promise.all(engineNames.map(describeEngine))
  const twins = all.filter(({ sameBitsAs }) => sameBitsAs)
  expect(twins.map(({ name }) => name)).toEqual(['box2d3-wasm'])
  for (const { name, sameBitsAs, settings, accurate } of twins) {
    const [one, other] = [await loadEngine(name), await loadEngine(String(sameBitsAs))]
    expect(other.settings).toEqual(settings)
    for (const setting of [settings[0], accurate]) {
      const trajectories = [one, other].map(
        (engine) => simulateScene(engine, sceneNamed('pour-mixed-60'), setting).trajectory,
      )
      expect(trajectories[0].data).toEqual(trajectories[1].data)
    }
  }
})

it.each(engineNames)(
  'the errors of %s are kept for as long as no module that they depend on changes',
  async (name) => {
    const sources = await sourcesOf([`bench/engines/${moduleOf(name)}`])
    const { default: _, ...all } = await import(`./${moduleOf(name)}.ts`)
    expect(Object.values(all)).toContain(await describeEngine(name))
    const solver = ['world.ts', 'solver/contact-solver.ts', 'solver/state.ts']
    for (const file of solver)
      expect(sources.includes(`registry/gravity-stack/${file}`), file).toBe(name === 'gravity-stack')
  },
)

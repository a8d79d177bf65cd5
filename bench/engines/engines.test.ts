import { expect, it } from 'vitest'
import { sceneNamed } from '../../scenes'
import { filmScene } from '../accuracy/trajectory'
import { describeEngine, engineNames, loadEngine } from '.'

it('a build whose films stand for another moves every chip by the same bits', async () => {
  const all = await Promise.all(engineNames.map(describeEngine))
  const twins = all.filter(({ sameBitsAs }) => sameBitsAs)
  expect(twins.map(({ name }) => name)).toEqual(['box2d3-wasm'])
  for (const { name, sameBitsAs, settings, accurate } of twins) {
    const [one, other] = [await loadEngine(name), await loadEngine(String(sameBitsAs))]
    expect(other.settings).toEqual(settings)
    for (const setting of [settings[0], accurate]) {
      const films = [one, other].map((engine) => filmScene(engine, sceneNamed('pour-mixed-60'), setting).film)
      expect(films[0].data).toEqual(films[1].data)
    }
  }
})

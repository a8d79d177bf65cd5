// Prints how wrong an engine is, scene by scene, beside the target.
//   npx tsx bench/errors.ts [--engine ours,planck] [--substeps 4,8,16] [--scene stack] [--seeds 3] [--all]
// --scene takes parts of names. Without --all and --scene the piles of 250 and 1000 chips are left out.
import { parseArgs } from 'node:util'
import { scenes } from '../scenes'
import { sceneErrors } from './accuracy/trajectory'
import { loadEngine } from './engines'
import { type Setting, settingName } from './engines/engine'
import { short } from './publish/write'

const { values: options } = parseArgs({
  options: {
    engine: { type: 'string', default: 'ours' },
    substeps: { type: 'string' },
    scene: { type: 'string' },
    seeds: { type: 'string', default: '12' },
    all: { type: 'boolean', default: false },
  },
})

const wanted = options.scene?.split(',')
const large = /-(250|1000)$/
const chosen = scenes.filter((scene) =>
  wanted ? wanted.some((part) => scene.name.includes(part)) : options.all || !large.test(scene.name),
)

for (const name of options.engine.split(',')) {
  const engine = await loadEngine(name)
  const settings: Setting[] = options.substeps
    ? options.substeps.split(',').map((substeps) => ({ ...engine.settings[0], substeps: Number(substeps) }))
    : [engine.settings[0]]
  console.log(`\n${engine.name}`)
  const width = Math.max(13, ...settings.map((setting) => settingName(setting).length + 2))
  const heading = settings.map((setting) => settingName(setting).padStart(width)).join('')
  console.log(
    `${'scene'.padEnd(18)}${'measure'.padEnd(17)}${'unit'.padEnd(9)}${'target'.padStart(8)}${heading}`,
  )
  for (const scene of chosen) {
    const columns = settings.map((setting) => {
      try {
        return sceneErrors(engine, scene, setting, Number(options.seeds))
      } catch (error) {
        console.error(`${engine.name} on ${scene.name}: ${error instanceof Error ? error.stack : error}`)
        return scene.measures.map(() => Number.NaN)
      }
    })
    scene.measures.forEach((measure, i) => {
      const cells = columns.map((errors) => {
        const good = measure.target === undefined ? ' ' : errors[i] <= measure.target ? '✓' : '✗'
        return `${short(errors[i])} ${good}`.padStart(width)
      })
      const label = i === 0 ? scene.name : ''
      const target = measure.target === undefined ? '' : short(measure.target)
      console.log(
        label.padEnd(18) +
          measure.name.padEnd(17) +
          measure.unit.padEnd(9) +
          target.padStart(8) +
          cells.join(''),
      )
    })
  }
}
process.exit(0)

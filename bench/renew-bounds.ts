// Makes today's errors and work counts the bounds that `npm test` holds the solver to:
//   npx tsx bench/renew-bounds.ts
// and prints what changed.
import { readFileSync, writeFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { scenes } from '../scenes'
import { type Bounds, measureScene } from './accuracy/regression'

const file = fileURLToPath(new URL('./accuracy/bounds.json', import.meta.url))
const before: Bounds = JSON.parse(readFileSync(file, 'utf8'))
const after: Bounds = {}

/** Two digits, rounded up: a bound, not a fingerprint. */
function roundUp(value: number) {
  if (value === 0) return value
  if (!Number.isFinite(value)) throw new Error('a solver that loses chips sets no bounds')
  // Less than this is rounding, and may come out otherwise after any change.
  if (value < 1e-9) return 1e-9
  const unit = 10 ** (Math.floor(Math.log10(value)) - 1)
  return Number((Math.ceil(value / unit) * unit).toPrecision(2))
}

for (const scene of scenes) {
  const { name } = scene
  const { errors, work } = measureScene(scene)
  const bounds = Object.fromEntries(Object.entries(errors).map(([key, value]) => [key, roundUp(value)]))
  after[name] = { errors: bounds, work }
  for (const kind of ['errors', 'work'] as const) {
    for (const [key, value] of Object.entries(after[name][kind])) {
      const was = before[name]?.[kind][key]
      if (was !== value) console.log(`${name}, ${key}: ${was ?? 'new'} → ${value}`)
    }
  }
}
writeFileSync(file, `${JSON.stringify(after, null, 2)}\n`)

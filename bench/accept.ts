// Accepts today's errors and work counts as the bounds that `npm test` holds the solver to:
//   npx tsx bench/accept.ts
// and prints what changed.
import { existsSync, readFileSync, writeFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { type Bounds, gated, measureScene } from './gate'

const file = fileURLToPath(new URL('./bounds.json', import.meta.url))
const before: Bounds = existsSync(file) ? JSON.parse(readFileSync(file, 'utf8')) : {}
const after: Bounds = {}

/** Two digits, rounded up: a bound, not a fingerprint. */
function roundUp(value: number) {
  if (!Number.isFinite(value)) throw new Error('a solver that loses chips is nothing to accept')
  if (value === 0) return 0
  const unit = 10 ** (Math.floor(Math.log10(value)) - 1)
  return Number((Math.ceil(value / unit) * unit).toPrecision(2))
}

for (const scene of gated) {
  const { errors, work } = measureScene(scene)
  const bounds = Object.fromEntries(Object.entries(errors).map(([name, value]) => [name, roundUp(value)]))
  after[scene.name] = { errors: bounds, work }
  const old = before[scene.name]
  for (const kind of ['errors', 'work'] as const) {
    for (const [name, value] of Object.entries(after[scene.name][kind])) {
      const was = old?.[kind][name]
      if (was !== value) console.log(`${scene.name}, ${name}: ${was ?? 'new'} → ${value}`)
    }
  }
}
writeFileSync(file, `${JSON.stringify(after, null, 2)}\n`)

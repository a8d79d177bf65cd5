// Plays a pile of the playground again, from the address that “Copy this pile” gives.
//   npx tsx bench/replay.ts LINK
// It ends with an error where the pile comes out otherwise: by another version of the solver, or for a reason
// to look for.
import { createReplay } from '../components/lab/recorder'
import { fromFragment } from '../lib/pile-link'
import { version } from '../site.config.mjs'

const link = process.argv[2]
const record = link ? await fromFragment(link.slice(link.indexOf('#'))) : undefined
if (!record)
  throw new Error('Give the address of a pile: npx tsx bench/replay.ts "https://…/playground#pile=…"')

const replay = createReplay(record)
const { world } = replay.pile
while (!replay.over) replay.step()
const { width, height } = record.options
console.log(
  `${record.shapes.length} chips on ${width} × ${height} px, ${record.steps} steps, ${record.acts.length} acts`,
)
console.log(`recorded by version ${record.version}, played by ${version}`)
console.log(`${world.hash()}: ${replay.same ? 'the same pile' : `not the recorded ${record.hash}`}`)
process.exit(replay.same ? 0 : 1)

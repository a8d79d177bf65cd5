// Looks for what the solver gets wrong as it comes, and right with more sub-steps:
//   npx tsx bench/convergence.ts [--scenes 1000 --seed 1 --chips 12]
// Random scenes are stopped four times a second and gone on with from there, for six frames, with 6 sub-steps
// and with 32, 64 and 128. Where these three agree on a chip and the 6 do not, it is printed, the worst
// first: a defect, or many hits within one sub-step.
import { parseArgs } from 'node:util'
import fc from 'fast-check'
import { createWorld } from '../registry/gravity-stack/world'
import { worstOverlap } from '../scenes/exact-distance'
import { type FuzzScene, sane } from '../scenes/fuzzed'
import { type Chip, frame } from '../scenes/scene'
import { anyScene } from './fuzz/scenes'

const { values } = parseArgs({
  options: {
    scenes: { type: 'string', default: '1000' },
    seed: { type: 'string', default: '1' },
    chips: { type: 'string', default: '12' },
  },
})
const asItComes = 6
const finer = [32, 64, 128]
/** Frames between two states, before the first, and after the last. */
const [every, first, last] = [15, 30, 120]
/**
 * Frames simulated from a state, and those after which runs are compared: an impact may come a moment sooner.
 */
const onward = 6
const compared = 4
/** px/s by which the 6 have to be off in each of these, and the share of it by which the others may be. */
const off = 60
const agreed = 0.08
/** px of overlap from which a state is left out: without its loads, what is crushed parts otherwise. */
const clear = 0.05

type State = ReturnType<ReturnType<typeof createWorld>['read']>

/** px/s between two states of a chip, its corners included. */
const apart = ({ width, height }: Chip, a: State, b: State) =>
  Math.hypot(a.vx - b.vx, a.vy - b.vy) + 0.5 * Math.hypot(width, height) * Math.abs(a.spin - b.spin)

/** Scenes like those that a page makes: others are chaos at any number of sub-steps. */
function usual({ chips, acts, conditions }: FuzzScene) {
  const { gravity, bounce, friction } = conditions
  return (
    acts.length === 0 &&
    chips.length <= Number(values.chips) &&
    gravity >= 500 &&
    gravity <= 6000 &&
    bounce <= 0.6 &&
    friction <= 1
  )
}

function goOn(scene: FuzzScene, states: State[], substeps: number) {
  const world = createWorld({ ...scene, ...scene.conditions, sleep: false, substeps })
  const ids = scene.chips.map((chip, i) => world.add({ ...chip, ...states[i] }))
  return Array.from({ length: onward }, () => {
    world.step(frame)
    return ids.map((id) => world.read(id))
  }).slice(-compared)
}

const found: { error: number; text: string }[] = []
let played = 0
fc.assert(
  fc.property(anyScene, (given) => {
    const number = ++played
    const scene = sane(given)
    if (!usual(scene)) return
    const world = createWorld({ ...scene, ...scene.conditions, sleep: false })
    const ids = scene.chips.map((chip) => world.add(chip))
    for (let k = 1; k <= last; k++) {
      world.step(frame)
      if (k < first || k % every > 0) continue
      const states = ids.map((id) => world.read(id))
      if (worstOverlap(scene.chips, states, scene) > clear) continue
      const coarse = goOn(scene, states, asItComes)
      const fine = finer.map((substeps) => goOn(scene, states, substeps))
      const exact = fine[fine.length - 1]
      scene.chips.forEach((chip, i) => {
        const { width, height, radius, density } = chip
        const error = Math.min(...coarse.map((run, n) => apart(chip, run[i], exact[n][i])))
        const spread = Math.max(
          ...fine.flatMap((runs) => runs.map((run, n) => apart(chip, run[i], exact[n][i]))),
        )
        if (error < off || spread > agreed * error) return
        const says = ({ vx, vy, spin }: State) => `${vx.toFixed(0)}, ${vy.toFixed(0)} at ${spin.toFixed(1)}`
        const text = `scene ${number}, frame ${k}, chip ${i} of ${ids.length} (${width} × ${height}, radius ${radius}, density ${density}): was ${says(states[i])} rad/s; comes to ${says(coarse[0][i])}, where it should to ${says(exact[0][i])}`
        found.push({ error, text })
      })
    }
  }),
  { seed: Number(values.seed), numRuns: Number(values.scenes) },
)
for (const { error, text } of found.sort((a, b) => b.error - a.error))
  console.log(`${error.toFixed(0).padStart(5)} px/s  ${text}`)
console.log(
  `${found.length} states of ${played} scenes in which the chip is off by more than ${off} px/s for ${compared} frames`,
)

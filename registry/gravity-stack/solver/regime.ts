import { speedOf } from './body'
import {
  ITERATIONS,
  LEAST_TOLERANCE,
  MOST_TOLERANCE,
  RELAXATION,
  RESTING_SPEED,
  RESTING_TOLERANCE,
  TOLERANCE,
} from './constants'
import { INV_MASS, type Simulation, STATE } from './state'

/**
 * Chooses how exactly a step is solved, by the fastest point of all that is awake:
 *
 * | regime  | speed, px/s | tolerance, px/s                      | SOR factor |
 * | resting | ≤ 0.4       | 0.003                                | 1          |
 * | moving  | more        | 3 % of it, 0.05 at least, 20 at most | 1.3, or 1  |
 *
 * A moving world has the factor 1 if it has at most 16 contacts, or if its heaviest mass is more than 16
 * times its lightest. Then a sub-step has as many iterations as their ratio says, as a light chip under a
 * heavy one hands an impulse on in tiny parts only. So many over-relaxed iterations may diverge.
 */
export function chooseRegime({ bodies, contacts, regime }: Simulation): void {
  const { state, awake, awakeCount } = bodies
  let speed = 0
  let lightest = 0
  let heaviest = Infinity
  for (let n = 0; n < awakeCount; n++) {
    const inverse = state[awake[n] * STATE + INV_MASS]
    lightest = Math.max(lightest, inverse)
    if (inverse > 0) heaviest = Math.min(heaviest, inverse)
    speed = Math.max(speed, speedOf(bodies, awake[n]))
  }
  regime.resting = speed <= RESTING_SPEED
  regime.tolerance = regime.resting
    ? RESTING_TOLERANCE
    : Math.max(LEAST_TOLERANCE, Math.min(MOST_TOLERANCE, TOLERANCE * speed))
  regime.massRatio = lightest / heaviest
  const overRelaxed = !regime.resting && contacts.nearCount > ITERATIONS && regime.massRatio <= ITERATIONS
  regime.relaxation = overRelaxed ? RELAXATION : 1
}

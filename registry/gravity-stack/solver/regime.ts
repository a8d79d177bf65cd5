import { speedOf } from './body'
import { ITERATIONS, LEAST_TOLERANCE, MOST_TOLERANCE, RELAXATION, SLOW_CONTACT, TOLERANCE } from './constants'
import { INV_MASS, type Simulation, STATE } from './state'

/**
 * Chooses how exactly a step is solved, by the fastest point of all that is awake. The tolerance is 3 % of
 * its speed, within 0.05 and 20 px/s. What is faster than 10 px/s is over-relaxed: a slow pile settles in
 * fewer visits without it. As many contacts as iterations or fewer converge anyway, and are not over-relaxed
 * either.
 *
 * Where masses differ a sub-step has as many iterations as their ratio says, as a light chip under a heavy
 * one hands an impulse on in tiny parts only.
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
  regime.tolerance = Math.max(LEAST_TOLERANCE, Math.min(MOST_TOLERANCE, TOLERANCE * speed))
  regime.relaxation = speed <= SLOW_CONTACT || contacts.nearCount <= ITERATIONS ? 1 : RELAXATION
  regime.massRatio = lightest / heaviest
}

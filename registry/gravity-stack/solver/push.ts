import { capSpeed, isStatic, setPose, setShape } from './body'
import { MAX_TOSS, PUSH_SAMPLES } from './constants'
import { checkContacts } from './contact'
import { ARM_BX, ARM_BY, COUNT, collide, MANIFOLD_NX, MANIFOLD_NY, manifold, WIDEST } from './manifold'
import { wake } from './sleep'
import { FIRST_CHIP, INV_INERTIA, INV_MASS, PUSHER, type Simulation, SPIN, STATE, VX, VY } from './state'

/**
 * Push: a disc of `radius` px goes from (x, y) by (goX, goY) in `seconds`. Each chip in its way gets the
 * impulse along the normal with which it moves as fast there as the disc does, though never faster than a
 * toss. Between two pushes there is no disc, so that it presses nothing against a wall, and nothing has to
 * lie beside it.
 */
export function pushBodies(
  simulation: Simulation,
  radius: number,
  x: number,
  y: number,
  goX: number,
  goY: number,
  seconds: number,
): void {
  const { bodies, contacts } = simulation
  const { alive, held, state } = bodies
  const way = Math.sqrt(goX * goX + goY * goY)
  const rate = Math.min(1 / seconds, MAX_TOSS / way)
  const samples = Math.ceil(Math.min((2 * way) / radius, PUSH_SAMPLES))
  setShape(bodies, PUSHER, 2 * radius, 2 * radius, radius, Infinity)
  for (let n = 1; n <= samples; n++) {
    setPose(bodies, PUSHER, x + (n / samples) * goX, y + (n / samples) * goY, 0)
    for (let i = FIRST_CHIP; i < bodies.count; i++) {
      if (!alive[i] || held[i] || isStatic(bodies, i)) continue
      manifold[WIDEST] = 0
      collide(bodies, PUSHER, i)
      if (manifold[COUNT] === 0) continue
      const s = i * STATE
      const nx = manifold[MANIFOLD_NX]
      const ny = manifold[MANIFOLD_NY]
      const arm = manifold[ARM_BX] * ny - manifold[ARM_BY] * nx
      const approach =
        nx * (rate * goX - state[s + VX]) + ny * (rate * goY - state[s + VY]) - arm * state[s + SPIN]
      if (!(approach > 0)) continue
      const impulse = approach / (state[s + INV_MASS] + state[s + INV_INERTIA] * arm * arm)
      state[s + VX] += nx * state[s + INV_MASS] * impulse
      state[s + VY] += ny * state[s + INV_MASS] * impulse
      state[s + SPIN] += arm * state[s + INV_INERTIA] * impulse
      capSpeed(state, s, MAX_TOSS)
      simulation.revision++
      wake(simulation, i)
      checkContacts(contacts, i)
    }
  }
}

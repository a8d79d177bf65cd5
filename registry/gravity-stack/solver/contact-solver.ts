import { SLOW_CONTACT, STICTION } from './constants'
import {
  ARM_NA,
  ARM_NB,
  ARM_TA,
  ARM_TB,
  CONTACT,
  CONTACTS_VISITED,
  COUPLING_K,
  INDEX,
  INV_DET,
  INV_INERTIA,
  INV_MASS,
  NORMAL_IMPULSE,
  NORMAL_K,
  NORMAL_X,
  NORMAL_Y,
  type Regime,
  SECOND,
  type Simulation,
  SPIN,
  STATE,
  TANGENT_BIAS,
  TANGENT_IMPULSE,
  TANGENT_MASS,
  VELOCITY_BIAS,
  VX,
  VY,
} from './state'

/**
 * One Gauss–Seidel iteration over the first `count` live contacts: both normals of a manifold together (the
 * 2×2 block of the complementarity problem, by cases), then friction in the interval ±μ·impulse.
 *
 * Every contact has a turn, counted on from `start`. It is visited if its last turn, or one since, changed a
 * velocity of one of its bodies by more than the tolerance. Returns the last turn that changed any, `start`
 * if none did.
 */
export function iterate(simulation: Simulation, regime: Regime, count: number, start: number): number {
  const { bodies, contacts, friction } = simulation
  const { tolerance, relaxation } = regime
  // A world without air drag, as exact test scenes use, has Coulomb friction without stiction.
  const stiction = simulation.air.fade < 1 ? STICTION : 0
  const atRest = friction * (1 + stiction)
  const loss = (friction * stiction) / SLOW_CONTACT
  const { state: s, changed } = bodies
  const { data: d, live, pair, points } = contacts
  let latest = start
  let turn = start
  let visits = 0
  for (let n = 0; n < count; n++) {
    turn++
    const last = turn - count
    const c = live[n] & INDEX
    const bodyA = pair[2 * c] & INDEX
    const bodyB = pair[2 * c + 1] & INDEX
    // Neither body changed since the contact's last turn: one branch tests both signs.
    if (((changed[bodyA] - last) & (changed[bodyB] - last)) < 0) continue
    visits++
    const k = c * CONTACT
    const k2 = k + SECOND
    const a = bodyA * STATE
    const b = bodyB * STATE
    const nx = d[k + NORMAL_X]
    const ny = d[k + NORMAL_Y]
    let spinA = s[a + SPIN]
    let spinB = s[b + SPIN]
    const vx = s[b + VX] - s[a + VX]
    const vy = s[b + VY] - s[a + VY]
    const iia = s[a + INV_INERTIA]
    const iib = s[b + INV_INERTIA]
    const speed = nx * vx + ny * vy
    const na1 = d[k + ARM_NA]
    const nb1 = d[k + ARM_NB]
    const old1 = d[k + NORMAL_IMPULSE]
    const k11 = d[k + NORMAL_K]
    const w1 = speed + nb1 * spinB - na1 * spinA + d[k + VELOCITY_BIAS]
    let sum = Math.max(0, old1 - (relaxation * w1) / k11)
    let normal = sum - old1
    let change = Math.abs(normal) * k11
    if (points[c] === 1) {
      if (normal === 0 && sum === 0) continue
      d[k + NORMAL_IMPULSE] = sum
      spinA -= iia * na1 * normal
      spinB += iib * nb1 * normal
    } else {
      const na2 = d[k2 + ARM_NA]
      const nb2 = d[k2 + ARM_NB]
      const old2 = d[k2 + NORMAL_IMPULSE]
      const k12 = d[k + COUPLING_K]
      const k22 = d[k2 + NORMAL_K]
      const det = d[k + INV_DET]
      const w2 = speed + nb2 * spinB - na2 * spinA + d[k2 + VELOCITY_BIAS]
      // Velocities that zero impulses would leave: q + K·p ≥ 0 with p ≥ 0, one of each zero.
      const q1 = w1 - k11 * old1 - k12 * old2
      const q2 = w2 - k12 * old1 - k22 * old2
      let p1 = det * (k12 * q2 - k22 * q1)
      let p2 = det * (k12 * q1 - k11 * q2)
      if (det === 0) {
        // The two points are nearly one: they take turns.
        p1 = sum
        p2 = Math.max(0, old2 - (w2 + k12 * normal) / k22)
      } else {
        if (p1 < 0 || p2 < 0) {
          p1 = -q1 / k11
          p2 = 0
          if (p1 < 0 || q2 + k12 * p1 < 0) {
            p1 = 0
            p2 = -q2 / k22
            if (p2 < 0 || q1 + k12 * p2 < 0) p2 = 0
          }
        }
        p1 = Math.max(0, old1 + relaxation * (p1 - old1))
        p2 = Math.max(0, old2 + relaxation * (p2 - old2))
      }
      sum = p1 + p2
      if (sum === 0 && old1 + old2 === 0) continue
      d[k + NORMAL_IMPULSE] = p1
      d[k2 + NORMAL_IMPULSE] = p2
      p1 -= old1
      p2 -= old2
      normal = p1 + p2
      change = Math.abs(p1) * k11 + Math.abs(p2) * k22
      spinA -= iia * (na1 * p1 + na2 * p2)
      spinB += iib * (nb1 * p1 + nb2 * p2)
    }
    const ima = s[a + INV_MASS]
    // Bit masks, as no CPU could predict a branch here. A static body never counts as changed.
    const changes = -(change > tolerance)
    changed[bodyA] += (turn - changed[bodyA]) & changes & -(ima > 0)
    changed[bodyB] += (turn - changed[bodyB]) & changes
    latest += (turn - latest) & changes
    const ta = d[k + ARM_TA]
    const tb = d[k + ARM_TB]
    const oldT = d[k + TANGENT_IMPULSE]
    const slip = nx * vy - ny * vx + tb * spinB - ta * spinA - d[k + TANGENT_BIAS]
    const limit = sum * Math.max(friction, atRest - loss * Math.abs(slip))
    const newT = Math.max(-limit, Math.min(limit, oldT - relaxation * d[k + TANGENT_MASS] * slip))
    d[k + TANGENT_IMPULSE] = newT
    const t = newT - oldT
    const x = nx * normal - ny * t
    const y = ny * normal + nx * t
    const imb = s[b + INV_MASS]
    s[a + VX] -= ima * x
    s[a + VY] -= ima * y
    s[a + SPIN] = spinA - iia * ta * t
    s[b + VX] += imb * x
    s[b + VY] += imb * y
    s[b + SPIN] = spinB + iib * tb * t
  }
  simulation.work[CONTACTS_VISITED] += visits
  return latest
}

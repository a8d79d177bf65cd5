import {
  type Air,
  ANGLE,
  BRAKE,
  CORE,
  capSpeed,
  DRIFT_ANGLE,
  DRIFT_X,
  DRIFT_Y,
  EXTENT,
  extents,
  farWall,
  HORIZON,
  HX,
  HY,
  halfExtents,
  INDEX,
  INV_INERTIA,
  INV_MASS,
  KICK_SPIN,
  KICK_X,
  KICK_Y,
  MOTION,
  NEVER,
  PUSH_SPIN,
  PUSH_X,
  PUSH_Y,
  RADIUS,
  SHAPE,
  SPIN,
  STATE,
  TRAVEL,
  VX,
  VY,
  X,
  Y,
} from './body'
import { COUNT, DISTANCE, GAP_NOW, LEAD, RATE_NOW, touch, WIDEST } from './collide'
import {
  AHEAD,
  BALANCE,
  BALANCE_GAIN,
  CLOSING_SHARE,
  CRUSHED,
  DEEP,
  GRAVITY,
  IMPACT_ROUNDS,
  IMPACT_ROUNDS_DULL,
  LIVELY,
  LIVELY_BOUNCE,
  MARGIN,
  MAX_PUSH,
  MAX_SPEED,
  MISJUDGED,
  PARTINGS,
  PUSH,
  PUSH_LAST,
  RELAXATION,
  ROCKING_SHARE,
  ROLLING,
  ROLLING_SHARE,
  SLOP,
  SLOW,
  STRAIGHTENING,
  SWEEPS_CRUSHED,
  WALL_GIVE,
  WALL_REFRESH,
  WEDGED,
} from './constants'
import {
  BASE,
  CLEAR,
  CLOSING,
  CONTACT,
  DRAG,
  DUE,
  FROM_A,
  FROM_B,
  FROM_X,
  FROM_Y,
  FURTHEST,
  gainOf,
  gapBound,
  INV_DET,
  K,
  K12,
  LOAD,
  MASS,
  MASS_T,
  MEASURED,
  measure,
  NA,
  NB,
  NX,
  NY,
  POINTS,
  probe,
  type Scene,
  SECOND,
  TA,
  TB,
  VISITED,
} from './contacts'
import { clearImpacts, enterAgain, enterImpact, type Impacts, resolve } from './impacts'

/**
 * Gravity, drag and warm start for the bodies `list[from..to)`: velocities at the end of the sub-step were it not for the sweep.
 * Those that move, or were moved, are marked as stirred for the first sweep.
 */
export function kick(scene: Scene, list: Int32Array, from: number, to: number, air: Air, spinAir: Air): void {
  const { state, motion, shape, stirred, moved, footing } = scene.bodies
  const { gravity, tolerance } = scene
  const half = 0.5 * scene.h
  // What nothing brakes in the air rolls for ever as well: so it is measured.
  const rolling = spinAir.fade < 1 ? ROLLING : 0
  for (let a = from; a < to; a++) {
    const i = list[a] & INDEX
    const s = i * STATE
    const m = i * MOTION
    const vx = state[s + VX]
    const vy = state[s + VY]
    const spin = state[s + SPIN]
    const pushX = motion[m + PUSH_X]
    const pushY = motion[m + PUSH_Y]
    const pushSpin = motion[m + PUSH_SPIN]
    // Smooth forces act evenly through the sub-step, so half their change of velocity counts for the way: exact for
    // constant ones. What the sweep adds counts in full.
    motion[m + DRIFT_X] = air.reach * vx + half * pushX
    motion[m + DRIFT_Y] = air.reach * vy + gravity * air.fall + half * pushY
    const toX = air.fade * vx + pushX
    const toY = air.fade * vy + gravity * air.reach + pushY
    // As friction it holds what it can: its last value is where it starts from, else a chip on a slope would creep.
    const push = rolling * (Math.abs(pushX) + Math.abs(pushY))
    const extent = shape[i * SHAPE + EXTENT]
    // What is slow is held better, with the lever of the disc that its corner is: else a slope as steep as the resistance is strong
    // lets it roll as slowly as drag likes.
    const corner = (0.5 * push * shape[i * SHAPE + RADIUS] * state[s + INV_INERTIA]) / state[s + INV_MASS]
    const slow = corner * Math.max(0, 1 - (Math.abs(spin) * extent) / SLOW)
    const grip = push / extent + slow
    let toSpin = spinAir.fade * spin + pushSpin
    let brake = motion[m + BRAKE] * footing[i]
    brake = Math.max(
      -grip,
      Math.min(grip, brake - (footing[i] || ROCKING_SHARE) * ROLLING_SHARE * (toSpin + brake)),
    )
    motion[m + BRAKE] = brake
    toSpin += brake
    motion[m + DRIFT_ANGLE] = spinAir.reach * spin + half * (pushSpin + brake)
    state[s + VX] = motion[m + KICK_X] = toX
    state[s + VY] = motion[m + KICK_Y] = toY
    state[s + SPIN] = motion[m + KICK_SPIN] = toSpin
    const speed = Math.abs(toX) + Math.abs(toY) + extent * Math.abs(toSpin)
    stirred[i] = speed > tolerance || moved[i] > 0 ? 0 : NEVER
  }
}

/**
 * What the contacts `list[from..to)` ask of the coming sub-step. Those that have moved are measured again (a
 * wall at every move, a touching pair after `REFRESH`, others when they may meet); those that will hit join the impacts;
 * the others learn how fast they may close. Those that touch, or are about to, are written into `live` from `from` on;
 * returns where they end.
 */
export function prepare(
  scene: Scene,
  impacts: Impacts,
  list: Int32Array,
  live: Int32Array,
  from: number,
  to: number,
): number {
  const { bodies, contacts, h } = scene
  const d = contacts.data
  const s = bodies.state
  const { motion, shape, moved } = bodies
  const pair = contacts.pair
  const ahead = AHEAD * h
  const enough = scene.threshold - Math.abs(scene.gravity) * h
  let end = from
  impacts.first = impacts.phase
  for (let n = from; n < to; n++) {
    const c = list[n] & INDEX
    const k = c * CONTACT
    const bodyA = pair[2 * c] & INDEX
    const bodyB = pair[2 * c + 1] & INDEX
    const touching = d[k + POINTS] > 0
    const ma = bodyA * MOTION
    const mb = bodyB * MOTION
    if (touching) {
      if (d[k + DUE] > -Infinity && moved[bodyA] + moved[bodyB] === 0) {
        live[end++] = c
        continue
      }
    } else if (motion[ma + HORIZON] + motion[mb + HORIZON] + MARGIN < d[k + DUE]) continue
    const a = bodyA * STATE
    const b = bodyB * STATE
    const vx = s[b + VX] - s[a + VX]
    const vy = s[b + VY] - s[a + VY]
    const spinA = s[a + SPIN]
    const spinB = s[b + SPIN]
    const travel = motion[ma + TRAVEL] + motion[mb + TRAVEL]
    if (!touching || travel > d[k + DUE]) {
      const coreA = shape[bodyA * SHAPE + CORE]
      const coreB = shape[bodyB * SHAPE + CORE]
      const shift =
        Math.abs(s[b + X] - s[a + X] - d[k + FROM_X]) +
        Math.abs(s[b + Y] - s[a + Y] - d[k + FROM_Y]) +
        coreA * Math.abs(s[a + ANGLE] - d[k + FROM_A]) +
        coreB * Math.abs(s[b + ANGLE] - d[k + FROM_B])
      const near =
        MARGIN + ahead * (Math.abs(vx) + Math.abs(vy) + coreA * Math.abs(spinA) + coreB * Math.abs(spinB))
      const loose = bodyA > 0 ? scene.loose : WALL_REFRESH
      const spare = touching ? loose - shift : d[k + CLEAR] - shift
      // Where the two move alike, less of their travel counts.
      d[k + DUE] = travel + spare
      if (touching ? spare < 0 : spare < near) {
        touch[WIDEST] = near
        touch[LEAD] = h
        measure(scene, c)
        touch[LEAD] = 0
        scene.work[MEASURED]++
        if (touch[COUNT] > 0) d[k + DUE] = travel + loose
        else d[k + DUE] = travel + touch[DISTANCE]
      }
      if (d[k + POINTS] === 0) continue
    }
    // What an impact asks first, for both points at once, and generously: nearly every contact fails here.
    const speed = d[k + NX] * vx + d[k + NY] * vy + enough
    const first = speed + d[k + NB] * spinB - d[k + NA] * spinA
    const second = speed + d[k + SECOND + NB] * spinB - d[k + SECOND + NA] * spinA
    if (Math.min(first, d[k + POINTS] > 1 ? second : first) < 0) {
      enterImpact(impacts, scene, c, nearing(scene, c))
      if (d[k + POINTS] === 0) continue
    }
    live[end++] = c
    close(scene, c)
  }
  return impacts.foundCount > 0 ? bounce(scene, impacts, list, live, from, to) : end
}

/** Resolves the impacts that `prepare` found among the contacts `list[from..to)`; lists those that now touch in `live` and returns where they end. */
function bounce(
  scene: Scene,
  impacts: Impacts,
  list: Int32Array,
  live: Int32Array,
  from: number,
  to: number,
): number {
  const { contacts } = scene
  const { data: d, pair } = contacts
  const rounds = scene.bounce < LIVELY_BOUNCE ? IMPACT_ROUNDS_DULL : IMPACT_ROUNDS
  for (let again = 1; ; again++) {
    const last = again === rounds
    resolve(impacts, scene, last)
    const { mark, phase } = impacts
    if (!last) clearImpacts(impacts)
    let end = from
    for (let n = from; n < to; n++) {
      const c = list[n]
      const k = c * CONTACT
      const a = pair[2 * c]
      const b = pair[2 * c + 1]
      // A body that the next round will reach has been marked for that already.
      if (mark[a] >= phase || mark[b] >= phase) {
        // What an impact sends off, or stops, may hit another within the same sub-step, and what has been put off may hit still.
        if (!last && (contacts.mark[c] === phase - 1 || d[k + LOAD] + d[k + SECOND + LOAD] === 0)) {
          const near = nearing(scene, c)
          if (d[k + POINTS] > 0 || gapBound(scene, c) < near) enterAgain(impacts, scene, c, near)
        } else if (d[k + POINTS] === 1) {
          // Struck into a spin, the other end may come down.
          touch[WIDEST] = nearing(scene, c)
          measure(scene, c)
        }
        if (d[k + POINTS] > 0) close(scene, c)
      }
      if (d[k + POINTS] > 0) live[end++] = c
    }
    if (last || impacts.foundCount === 0) return end
  }
}

/** px, gap of contact `c` that its bodies may close in the sub-step. */
function nearing(scene: Scene, c: number): number {
  const { state, shape } = scene.bodies
  const { pair } = scene.contacts
  const a = pair[2 * c]
  const b = pair[2 * c + 1]
  const way =
    Math.abs(state[b * STATE + VX] - state[a * STATE + VX]) +
    Math.abs(state[b * STATE + VY] - state[a * STATE + VY]) +
    shape[a * SHAPE + CORE] * Math.abs(state[a * STATE + SPIN]) +
    shape[b * SHAPE + CORE] * Math.abs(state[b * STATE + SPIN])
  return MARGIN + AHEAD * scene.h * way
}

/**
 * How fast the gaps of contact `c` may close in the coming sub-step; one that carries a load closes slowly: less chatter.
 * Overlap that the last move has left is taken out of the poses in passing.
 */
function close(scene: Scene, c: number): void {
  const { bodies, contacts, h } = scene
  const s = bodies.state
  const d = contacts.data
  const k = (c & INDEX) * CONTACT
  const a = (contacts.pair[2 * c] & INDEX) * STATE
  const b = (contacts.pair[2 * c + 1] & INDEX) * STATE
  const across = d[k + NX] * (s[b + X] - s[a + X]) + d[k + NY] * (s[b + Y] - s[a + Y])
  const loaded = d[k + LOAD] + d[k + SECOND + LOAD] > 0
  d[k + FURTHEST] = 2
  for (let p = k, n = d[k + POINTS]; n > 0; n--, p += SECOND) {
    const gap = d[p + BASE] + across + d[p + NB] * s[b + ANGLE] - d[p + NA] * s[a + ANGLE]
    let closing = 0
    if (gap > 0) {
      closing = (d[p + LOAD] > 0 ? CLOSING_SHARE * gap : gap) / h
      if (!loaded) {
        // The gap closes with the mean velocity of the sub-step, half of what it gains behind the one at its end.
        closing -= 0.5 * gainOf(scene, c, p)
        // No faster apart than this: the push of a chip that was crushed is over by then, and would be given back doubled.
        if (closing < -LIVELY) closing = -LIVELY
      }
    }
    d[p + CLOSING] = closing
    if (gap < -SLOP) part(scene, c, p, true)
    // What is crushed asks for more than there can be: taken further still, it would be shot away.
    if (gap < -CRUSHED) {
      d[k + FURTHEST] = 1
      scene.relaxation = scene.lively ? Math.min(scene.relaxation, RELAXATION) : 1
      if (scene.lively) scene.sweeps = Math.max(scene.sweeps, SWEEPS_CRUSHED)
    }
  }
}

/**
 * One Gauss–Seidel sweep over the contacts `list[from..to)`: both normals of a manifold together (the 2×2 block of the
 * complementarity problem, by cases), then friction in the interval ±μ·load, each taken further by the scene's relaxation.
 * Every contact has its turn, counted from `start`. It is visited if its last turn, or one since, has changed one of its bodies by more
 * than the tolerance; the `latest` turn that changed any goes in, and out.
 */
export function sweep(
  scene: Scene,
  list: Int32Array,
  from: number,
  to: number,
  start: number,
  latest: number,
): number {
  const { bodies, contacts, friction, stiction, tolerance, relaxation: widest } = scene
  const s = bodies.state
  const d = contacts.data
  const pair = contacts.pair
  const stirred = bodies.stirred
  const lap = to - from + 1
  const atRest = friction * (1 + stiction)
  const loss = (friction * stiction) / SLOW
  let turn = start
  let rows = 0
  for (let i = from; i < to; i++) {
    turn++
    const last = turn - lap
    if (latest < last) break
    const c = list[i] & INDEX
    const bodyA = pair[2 * c] & INDEX
    const bodyB = pair[2 * c + 1] & INDEX
    // Both before its last turn: the sign of the two at once, one branch instead of two.
    if (((stirred[bodyA] - last) & (stirred[bodyB] - last)) < 0) continue
    rows++
    const k = c * CONTACT
    const k2 = k + SECOND
    const a = bodyA * STATE
    const b = bodyB * STATE
    const nx = d[k + NX]
    const ny = d[k + NY]
    const relaxation = Math.min(widest, d[k + FURTHEST])
    let spinA = s[a + SPIN]
    let spinB = s[b + SPIN]
    const vxA = s[a + VX]
    const vyA = s[a + VY]
    const vxB = s[b + VX]
    const vyB = s[b + VY]
    const vx = vxB - vxA
    const vy = vyB - vyA
    const iia = s[a + INV_INERTIA]
    const iib = s[b + INV_INERTIA]
    const speed = nx * vx + ny * vy
    const na1 = d[k + NA]
    const nb1 = d[k + NB]
    const l1 = d[k + LOAD]
    const w1 = speed + nb1 * spinB - na1 * spinA + d[k + CLOSING]
    let load: number
    let normal: number
    let change: number
    if (d[k + POINTS] === 1) {
      // ½(x + |x|) is max(0, x) without a branch, which nobody could predict here.
      load = l1 - relaxation * w1 * d[k + MASS]
      load = 0.5 * (load + Math.abs(load))
      normal = load - l1
      if (normal === 0 && load === 0) continue
      change = Math.abs(normal) * d[k + K]
      d[k + LOAD] = load
      spinA -= iia * na1 * normal
      spinB += iib * nb1 * normal
    } else {
      const na2 = d[k2 + NA]
      const nb2 = d[k2 + NB]
      const l2 = d[k2 + LOAD]
      const w2 = speed + nb2 * spinB - na2 * spinA + d[k2 + CLOSING]
      const k11 = d[k + K]
      const k12 = d[k + K12]
      const k22 = d[k2 + K]
      const det = d[k + INV_DET]
      // Velocities that zero impulses would leave: q + K·p ≥ 0 with p ≥ 0, one of each zero.
      const q1 = w1 - k11 * l1 - k12 * l2
      const q2 = w2 - k12 * l1 - k22 * l2
      let p1: number
      let p2: number
      if (det > 0) {
        p1 = det * (k12 * q2 - k22 * q1)
        p2 = det * (k12 * q1 - k11 * q2)
      } else {
        // The two points are nearly one: they take turns.
        p1 = l1 - w1 * d[k + MASS]
        if (p1 < 0) p1 = 0
        p2 = l2 - (w2 + k12 * (p1 - l1)) * d[k2 + MASS]
        if (p2 < 0) p2 = 0
      }
      if (p1 < 0 || p2 < 0) {
        p1 = -q1 * d[k + MASS]
        p2 = 0
        if (p1 < 0 || q2 + k12 * p1 < 0) {
          p1 = 0
          p2 = -q2 * d[k2 + MASS]
          if (p2 < 0 || q1 + k12 * p2 < 0) p2 = 0
        }
      }
      // Both of two points that are nearly one, taken further, would go twice as far.
      const further = det > 0 ? relaxation : 1
      p1 = l1 + further * (p1 - l1)
      p2 = l2 + further * (p2 - l2)
      if (p1 < 0) p1 = 0
      if (p2 < 0) p2 = 0
      load = p1 + p2
      if (load === 0 && l1 + l2 === 0) continue
      d[k + LOAD] = p1
      d[k2 + LOAD] = p2
      p1 -= l1
      p2 -= l2
      normal = p1 + p2
      change = Math.abs(p1) * k11 + Math.abs(p2) * k22
      spinA -= iia * (na1 * p1 + na2 * p2)
      spinB += iib * (nb1 * p1 + nb2 * p2)
    }
    // Nobody could predict a branch here. The stage itself never moves.
    const stirs = -(change > tolerance)
    stirred[bodyA] += (turn - stirred[bodyA]) & stirs & -(bodyA > 0)
    stirred[bodyB] += (turn - stirred[bodyB]) & stirs
    latest += (turn - latest) & stirs
    let t = 0
    if (friction > 0) {
      const ta = d[k + TA]
      const tb = d[k + TB]
      const old = d[k + DRAG]
      const slip = nx * vy - ny * vx + tb * spinB - ta * spinA
      // As with what rolls: on a slope as steep as friction is strong, drag alone would say how slowly it slides.
      const limit = load * Math.max(friction, atRest - loss * Math.abs(slip))
      t = old - Math.min(relaxation, RELAXATION) * d[k + MASS_T] * slip
      if (t > limit) t = limit
      else if (t < -limit) t = -limit
      d[k + DRAG] = t
      t -= old
      spinA -= iia * ta * t
      spinB += iib * tb * t
    }
    const x = nx * normal - ny * t
    const y = ny * normal + nx * t
    const ima = s[a + INV_MASS]
    const imb = s[b + INV_MASS]
    s[a + VX] = vxA - ima * x
    s[a + VY] = vyA - ima * y
    s[a + SPIN] = spinA
    s[b + VX] = vxB + imb * x
    s[b + VY] = vyB + imb * y
    s[b + SPIN] = spinB
  }
  scene.work[VISITED] += rows
  return latest
}

/**
 * Moves the bodies `list[from..to)` through the sub-step, and keeps what the sweep changed as the next warm start.
 * Returns how many of them move, or gain speed by what the warm start and gravity give.
 */
export function move(scene: Scene, list: Int32Array, from: number, to: number): number {
  const { state, motion, shape } = scene.bodies
  const { gravity, h } = scene
  const least = BALANCE_GAIN * h
  const misjudged = MISJUDGED * Math.max(1, Math.abs(gravity) / GRAVITY)
  let active = 0
  for (let a = from; a < to; a++) {
    const i = list[a] & INDEX
    const s = i * STATE
    const m = i * MOTION
    const vx = state[s + VX]
    const vy = state[s + VY]
    const spin = state[s + SPIN]
    const dvx = vx - motion[m + KICK_X]
    const dvy = vy - motion[m + KICK_Y]
    const dSpin = spin - motion[m + KICK_SPIN]
    const extent = shape[i * SHAPE + EXTENT]
    // Where the warm start was far off, as after an impact, nothing acted evenly: it counts in full as well.
    const whole = Math.abs(dvx) + Math.abs(dvy) + extent * Math.abs(dSpin) > misjudged ? 0.5 * h : 0
    state[s + X] += motion[m + DRIFT_X] + h * dvx + whole * motion[m + PUSH_X]
    state[s + Y] += motion[m + DRIFT_Y] + h * dvy + whole * motion[m + PUSH_Y]
    state[s + ANGLE] += motion[m + DRIFT_ANGLE] + h * dSpin + whole * motion[m + PUSH_SPIN]
    const pushX = motion[m + PUSH_X] + dvx
    const pushY = motion[m + PUSH_Y] + dvy
    motion[m + PUSH_X] = pushX
    motion[m + PUSH_Y] = pushY
    motion[m + PUSH_SPIN] += dSpin
    // Both sums are made: one that is made first when a body comes to rest throws the compiled code away.
    const speed = Math.abs(vx) + Math.abs(vy) + extent * Math.abs(spin)
    const gain = Math.abs(pushX) + Math.abs(pushY + gravity * h)
    if (Math.max(speed - BALANCE, gain - least) > 0) active++
    capSpeed(state, s, MAX_SPEED)
  }
  return active
}

/** Pushes the bodies of a point of contact `c` apart along its normal, with `lazy` only if they don't part by themselves. */
function part(scene: Scene, c: number, p: number, lazy: boolean): number {
  const { bodies, contacts } = scene
  probe(scene, c, p)
  const gap = touch[GAP_NOW] + SLOP
  if (gap > 0 || (lazy && gap + touch[RATE_NOW] * scene.h > 0)) return 0
  const s = bodies.state
  const d = contacts.data
  const k = c * CONTACT
  const a = contacts.pair[2 * c] * STATE
  const b = contacts.pair[2 * c + 1] * STATE
  const push = Math.min((lazy ? -PUSH : -PUSH_LAST) * gap, MAX_PUSH) * d[p + MASS]
  const pa = s[a + INV_MASS] * push
  const pb = s[b + INV_MASS] * push
  s[a + X] -= d[k + NX] * pa
  s[a + Y] -= d[k + NY] * pa
  s[a + ANGLE] -= s[a + INV_INERTIA] * d[p + NA] * push
  s[b + X] += d[k + NX] * pb
  s[b + Y] += d[k + NY] * pb
  s[b + ANGLE] += s[b + INV_INERTIA] * d[p + NB] * push
  return gap < -DEEP ? 1 : 0
}

/**
 * One sweep that pushes overlapping poses apart and never touches a velocity, so that correcting adds no energy.
 * Returns how many points it found deeper than rest leaves them.
 */
export function separate(scene: Scene, list: Int32Array, from: number, to: number): number {
  const d = scene.contacts.data
  let deep = 0
  for (let i = from; i < to; i++) {
    const k = list[i] * CONTACT
    for (let p = k, n = d[k + POINTS]; n > 0; n--, p += SECOND) deep += part(scene, list[i], p, false)
  }
  return deep
}

/** Side by side between what gives way to nothing there is no room: of the two chips among the contacts `list[from..to)` that are deepest in one another, if any are wedged, the higher goes up. */
export function liftWedged(scene: Scene, list: Int32Array, from: number, to: number): void {
  const { bodies, contacts } = scene
  let worst = -1
  let least = -WEDGED
  for (let i = from; i < to; i++) {
    const c = list[i]
    if (contacts.wall[c] > 0) continue
    const k = c * CONTACT
    for (let p = k, n = contacts.data[k + POINTS]; n > 0; n--, p += SECOND) {
      probe(scene, c, p)
      if (touch[GAP_NOW] >= least) continue
      least = touch[GAP_NOW]
      worst = c
    }
  }
  if (worst < 0) return
  const { state } = bodies
  const a = contacts.pair[2 * worst] * STATE + Y
  const b = contacts.pair[2 * worst + 1] * STATE + Y
  state[state[a] < state[b] ? a : b] -= MAX_PUSH
}

/** Walls give way to nothing: a chip that others have pressed into one is put back. */
export function keepInside({ bodies, walls }: Scene, i: number): void {
  const { state, shape } = bodies
  const s = i * STATE
  const far = shape[i * SHAPE + EXTENT]
  const atX = state[s + X]
  const atY = state[s + Y]
  if (atX >= far && atX <= walls.width - far && atY <= walls.height - far) return
  halfExtents(bodies, i, WALL_GIVE, 0)
  const ex = extents[X]
  state[s + X] = Math.min(Math.max(atX, ex), Math.max(ex, farWall(shape, i, walls.width) - ex))
  state[s + Y] = Math.min(atY, walls.height - extents[Y])
}

/**
 * Parts what is awake, which nothing else would part in time: the first `count` contacts of `list` are pushed apart and measured
 * again, until none is deeper than rest leaves them or that is enough for a step. Returns whether it moved anything.
 */
export function straighten(scene: Scene, list: Int32Array, count: number): boolean {
  const { bodies, contacts, walls } = scene
  const { awake, awakeCount, shape } = bodies
  let rounds = 0
  for (let visits = STRAIGHTENING; visits > 0; visits -= count) {
    // Walls that have moved are seen all the same.
    for (let i = 0; i < count; i++) {
      const c = list[i]
      touch[WIDEST] = MARGIN
      if (contacts.wall[c] > 2) {
        const s = contacts.pair[2 * c + 1] * SHAPE
        if (2 * (Math.max(shape[s + HX], shape[s + HY]) + shape[s + RADIUS]) > walls.width + 2) {
          // What is longer than the stage is wide would be pushed to and fro: the left wall alone holds it. It may find no
          // room at all, and would take as long in every step.
          touch[WIDEST] = -Infinity
          visits = Math.min(visits, STRAIGHTENING / 8)
        }
      }
      measure(scene, c)
    }
    let passes = 0
    const most = Math.min(PARTINGS, visits / count)
    while (passes < most && separate(scene, list, 0, count) > 0) passes++
    if (passes === 0) break
    for (let n = 0; n < awakeCount; n++) keepInside(scene, awake[n])
    visits -= passes * count
    rounds++
  }
  return rounds > 0
}

// Exact answers in closed form or from ODEs integrated to 1e-10. y is down, angles and spins are clockwise.
import { cornerRadius, type Shape } from './exact-distance'

/** Mass and moment of inertia of a rectangle swept by its corner radius, for a density of mass per px². */
export function massOf(shape: Shape & { density?: number }) {
  const r = cornerRadius(shape)
  const a = shape.width / 2 - r
  const b = shape.height / 2 - r
  const density = shape.density ?? 1
  const plate = (hx: number, hy: number, cx: number, cy: number) => {
    const mass = 4 * hx * hy * density
    return [mass, mass * ((hx * hx + hy * hy) / 3 + cx * cx + cy * cy)]
  }
  const parts = [
    plate(a, b, 0, 0),
    plate(r / 2, b, a + r / 2, 0),
    plate(r / 2, b, a + r / 2, 0),
    plate(a, r / 2, 0, b + r / 2),
    plate(a, r / 2, 0, b + r / 2),
  ]
  // The four corners: quarter discs, whose centroid lies 4r/(3π) from the corner's centre on each axis.
  const disc = Math.PI * r * r * density
  const out = (4 * r) / (3 * Math.PI)
  parts.push([disc, disc * (r * r * 0.5 - 2 * out * out + (a + out) ** 2 + (b + out) ** 2)])
  return {
    mass: parts.reduce((sum, [mass]) => sum + mass, 0),
    inertia: parts.reduce((sum, [, inertia]) => sum + inertia, 0),
  }
}

/** Distance covered and speed reached after t seconds from speed v under acceleration g with drag c (1/s). */
export function flight(v: number, g: number, c: number, t: number) {
  if (c === 0) return { moved: v * t + (g * t * t) / 2, speed: v + g * t }
  const top = g / c
  const left = (v - top) * Math.exp(-c * t)
  return { moved: top * t + ((v - top) * -Math.expm1(-c * t)) / c, speed: top + left }
}

/** Arm from a body's centre to the contact, and what stands against an impulse there. */
type Striker = { mass: number; inertia: number; rx: number; ry: number; vx: number; vy: number; spin: number }

/**
 * A body strikes a fixed plane whose normal (nx, ny) points at it: Newton's restitution on the normal,
 * Coulomb's bound on the tangent, both met at once by the velocity after the impact.
 */
export function strike(body: Striker, nx: number, ny: number, e: number, friction: number) {
  const { mass, inertia, rx, ry } = body
  const tx = -ny
  const ty = nx
  const un = (body.vx - body.spin * ry) * nx + (body.vy + body.spin * rx) * ny
  const ut = (body.vx - body.spin * ry) * tx + (body.vy + body.spin * rx) * ty
  const armN = rx * ny - ry * nx
  const armT = rx * ty - ry * tx
  const knn = 1 / mass + (armN * armN) / inertia
  const ktt = 1 / mass + (armT * armT) / inertia
  const knt = (armN * armT) / inertia
  const wanted = -(1 + e) * un
  const det = knn * ktt - knt * knt
  let jn = (wanted * ktt + ut * knt) / det
  let jt = (-ut * knn - wanted * knt) / det
  if (Math.abs(jt) > friction * jn) {
    const slide = Math.sign(jt) * friction
    jn = wanted / (knn + slide * knt)
    jt = slide * jn
  }
  return {
    vx: body.vx + (jn * nx + jt * tx) / mass,
    vy: body.vy + (jn * ny + jt * ty) / mass,
    spin: body.spin + (armN * jn + armT * jt) / inertia,
  }
}

/**
 * Where a disc that bounces between a floor and two walls is after `seconds`: flights and impacts in turn.
 */
export function bouncingDisc(
  start: { x: number; y: number; vx: number; vy: number; spin: number; radius: number },
  stage: { width: number; height: number },
  options: { gravity: number; bounce: number; friction: number },
  seconds: number,
) {
  const { radius } = start
  const { mass, inertia } = massOf({ width: 2 * radius, height: 2 * radius, radius })
  let { x, y, vx, vy, spin } = start
  let left = seconds
  const g = options.gravity
  for (let hits = 0; hits < 1000; hits++) {
    const floor = stage.height - radius - y
    const drop = vy * vy + 2 * g * Math.max(0, floor)
    const toFloor = g > 0 ? (-vy + Math.sqrt(drop)) / g : vy > 0 ? floor / vy : Number.POSITIVE_INFINITY
    const wall = vx > 0 ? stage.width - radius : radius
    const toWall = vx === 0 ? Number.POSITIVE_INFINITY : (wall - x) / vx
    const dt = Math.min(left, toFloor, toWall)
    x += vx * dt
    y += vy * dt + (g * dt * dt) / 2
    vy += g * dt
    left -= dt
    if (left <= 0) break
    const onFloor = toFloor <= toWall
    if (onFloor) y = stage.height - radius
    else x = wall
    const nx = onFloor ? 0 : -Math.sign(vx)
    const ny = onFloor ? -1 : 0
    const arm = { rx: -nx * radius, ry: -ny * radius }
    const after = strike({ mass, inertia, ...arm, vx, vy, spin }, nx, ny, options.bounce, options.friction)
    vx = after.vx
    vy = after.vy
    spin = after.spin
  }
  return { x, y, vx, vy, spin }
}

/**
 * One pill's round end strikes the flat side of another, both free, without friction: the first flies along
 * the normal without spin, so the impulse is (1 + e)v over the sum of what resists it.
 */
export function pillsImpact(speed: number, arm: number, struck: Shape, striker: Shape, e: number) {
  const a = massOf(struck)
  const b = massOf(striker)
  const impulse = ((1 + e) * speed) / (1 / a.mass + (arm * arm) / a.inertia + 1 / b.mass)
  return {
    struck: { speed: impulse / a.mass, spin: (arm * impulse) / a.inertia },
    striker: { speed: speed - impulse / b.mass },
  }
}

/** One step of the classical Runge–Kutta method for θ'' = f(θ, θ'). */
function rungeKutta(f: (angle: number, spin: number) => number, angle: number, spin: number, h: number) {
  const a1 = f(angle, spin)
  const a2 = f(angle + (h / 2) * spin, spin + (h / 2) * a1)
  const s2 = spin + (h / 2) * a1
  const a3 = f(angle + (h / 2) * s2, spin + (h / 2) * a2)
  const s3 = spin + (h / 2) * a2
  const a4 = f(angle + h * s3, spin + h * a3)
  const s4 = spin + h * a3
  return [angle + (h / 6) * (spin + 2 * s2 + 2 * s3 + s4), spin + (h / 6) * (a1 + 2 * a2 + 2 * a3 + a4)]
}

/**
 * A pill that stands on its round end and topples, rolling on it without slip. θ is the lean from upright;
 * the end's centre moves by rθ, the pill's centre is d away from it, so that M(θ)θ'' = mgd·sinθ +
 * m·r·d·sinθ·θ'², M = m(r² + 2rd·cosθ + d²) + I. `stepsPerSecond` sets the error: a run with half as many
 * differs by less than 1e-10 px.
 */
export function topple(pill: Shape, lean: number, gravity: number, seconds: number, stepsPerSecond = 48_000) {
  const r = cornerRadius(pill)
  const d = pill.height / 2 - r
  const { mass: m, inertia } = massOf(pill)
  const acceleration = (angle: number, spin: number) => {
    const s = Math.sin(angle)
    const inertiaAtFloor = m * (r * r + 2 * r * d * Math.cos(angle) + d * d) + inertia
    return (m * d * s * (gravity + r * spin * spin)) / inertiaAtFloor
  }
  const steps = Math.round(seconds * stepsPerSecond)
  let angle = lean
  let spin = 0
  for (let i = 0; i < steps; i++) [angle, spin] = rungeKutta(acceleration, angle, spin, seconds / steps)
  // What the floor has to supply, to check that it could: tangential and normal acceleration of the centre.
  const spinUp = acceleration(angle, spin)
  const ax = (r + d * Math.cos(angle)) * spinUp - d * Math.sin(angle) * spin * spin
  const ay = d * (Math.sin(angle) * spinUp + Math.cos(angle) * spin * spin)
  return {
    /** sideways travel of the centre since θ = 0, and its height over the floor */
    x: r * angle + d * Math.sin(angle),
    height: r + d * Math.cos(angle),
    angle,
    spin,
    frictionNeeded: Math.abs(ax) / (gravity - ay),
  }
}

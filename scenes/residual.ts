// How far a pile is from the laws of contact, in any engine: the engine's own impulses are not used.
import { chipDistance, cornerRadius, halfExtent, type Pose, type Shape } from './exact-distance'
import { massOf } from './references'
import { frame, type Trajectory } from './scene'

/** px, chips closer than this may press on each other: some engines keep a gap of 1 to 1.5 px. */
const reach = 2

/** A point where body `a` may press on body `b`; b is −1 for the stage. The normal points at a. */
type Contact = { a: number; b: number; px: number; py: number; nx: number; ny: number }

function coreCorners(shape: Shape, pose: Pose) {
  const r = cornerRadius(shape)
  const a = shape.width / 2 - r
  const b = shape.height / 2 - r
  const c = Math.cos(pose.angle)
  const s = Math.sin(pose.angle)
  const xs = a > 0 ? [-a, a] : [0]
  const ys = b > 0 ? [-b, b] : [0]
  return xs.flatMap((x) => ys.map((y) => ({ x: pose.x + c * x - s * y, y: pose.y + s * x + c * y })))
}

/** Contacts of the core corners of chip `a` with the surface of chip `b`. */
function cornersAgainst(
  trajectory: Trajectory,
  poses: Pose[],
  a: number,
  b: number,
  flip: boolean,
): Contact[] {
  const shape = trajectory.chips[b]
  const pose = poses[b]
  const rb = cornerRadius(shape)
  const ra = cornerRadius(trajectory.chips[a])
  const hx = shape.width / 2 - rb
  const hy = shape.height / 2 - rb
  const c = Math.cos(pose.angle)
  const s = Math.sin(pose.angle)
  // The side of b by which the two are least in each other: a corner of a that is inside the core goes out
  // through that.
  const [ax, ay] = halfExtent(trajectory.chips[a], poses[a].angle - pose.angle)
  const x = c * (poses[a].x - pose.x) + s * (poses[a].y - pose.y)
  const y = c * (poses[a].y - pose.y) - s * (poses[a].x - pose.x)
  const sideways = Math.abs(x) - hx - ax > Math.abs(y) - hy - ay
  const way = Math.sign(sideways ? x : y) || 1
  const contacts: Contact[] = []
  for (const corner of coreCorners(trajectory.chips[a], poses[a])) {
    const dx = corner.x - pose.x
    const dy = corner.y - pose.y
    const lx = c * dx + s * dy
    const ly = c * dy - s * dx
    const ox = lx - Math.max(-hx, Math.min(hx, lx))
    const oy = ly - Math.max(-hy, Math.min(hy, ly))
    let distance = Math.hypot(ox, oy)
    let nx = ox / distance
    let ny = oy / distance
    if (distance < 1e-9) {
      distance = sideways ? way * lx - hx : way * ly - hy
      nx = sideways ? way : 0
      ny = sideways ? 0 : way
    }
    if (distance - ra - rb > reach) continue
    const wx = c * nx - s * ny
    const wy = s * nx + c * ny
    const half = (distance + ra - rb) / 2
    const contact = { px: corner.x - wx * half, py: corner.y - wy * half }
    contacts.push(flip ? { a: b, b: a, ...contact, nx: -wx, ny: -wy } : { a, b, ...contact, nx: wx, ny: wy })
  }
  return contacts
}

function contactsOf(trajectory: Trajectory, poses: Pose[]): Contact[] {
  const { chips, scene } = trajectory
  const contacts: Contact[] = []
  for (let i = 0; i < chips.length; i++) {
    const r = cornerRadius(chips[i])
    for (const { x, y } of coreCorners(chips[i], poses[i])) {
      if (y + r > scene.height - reach) contacts.push({ a: i, b: -1, px: x, py: y + r, nx: 0, ny: -1 })
      if (x - r < reach) contacts.push({ a: i, b: -1, px: x - r, py: y, nx: 1, ny: 0 })
      if (x + r > scene.width - reach) contacts.push({ a: i, b: -1, px: x + r, py: y, nx: -1, ny: 0 })
    }
    const [ix, iy] = halfExtent(chips[i], poses[i].angle)
    for (let j = 0; j < i; j++) {
      const [jx, jy] = halfExtent(chips[j], poses[j].angle)
      if (Math.abs(poses[i].x - poses[j].x) > ix + jx + reach) continue
      if (Math.abs(poses[i].y - poses[j].y) > iy + jy + reach) continue
      if (chipDistance(chips[i], poses[i], chips[j], poses[j]) > reach) continue
      contacts.push(
        ...cornersAgainst(trajectory, poses, i, j, false),
        ...cornersAgainst(trajectory, poses, j, i, true),
      )
    }
  }
  return contacts
}

/**
 * Residual of the Signorini–Coulomb problem over frame `k`, in weights of all chips: first the impulses
 * inside the friction cones that come closest to explaining the change of momentum, then what they leave
 * unexplained together with ‖(λₙ − max(0, λₙ − ρuₙ), λₜ − clamp(λₜ − ρuₜ, ±μλₙ))‖ at the velocities u the
 * frame ended with. 0 is a pile at rest in balance; 1 is a weight that nothing carries.
 */
export function contactResidual(trajectory: Trajectory, k: number, sweeps = 4000) {
  const { chips, scene } = trajectory
  const { gravity, friction } = scene.conditions
  const poses = trajectory.poses(k)
  const contacts = contactsOf(trajectory, poses)
  const bodies = chips.map(massOf)
  const n = chips.length
  // The change of velocity still to be explained; impulses take their share out of it. One more row is the
  // stage.
  const left = new Float64Array(3 * (n + 1))
  const now = new Float64Array(3 * (n + 1))
  for (let i = 0; i < n; i++) {
    const before = trajectory.state(k - 1, i)
    const after = trajectory.state(k, i)
    left[3 * i] = after.vx - before.vx
    left[3 * i + 1] = after.vy - before.vy - gravity * frame
    left[3 * i + 2] = after.spin - before.spin
    now[3 * i] = after.vx
    now[3 * i + 1] = after.vy
    now[3 * i + 2] = after.spin
  }
  type Row = { a: number; b: number; x: number; y: number; ta: number; tb: number; mass: number }
  const row = (contact: Contact, x: number, y: number): Row => {
    const { a, px, py } = contact
    const b = contact.b < 0 ? n : contact.b
    const ta = (px - poses[a].x) * y - (py - poses[a].y) * x
    const tb = b === n ? 0 : (px - poses[b].x) * y - (py - poses[b].y) * x
    let inverse = 1 / bodies[a].mass + (ta * ta) / bodies[a].inertia
    if (b < n) inverse += 1 / bodies[b].mass + (tb * tb) / bodies[b].inertia
    return { a: 3 * a, b: 3 * b, x, y, ta, tb, mass: 1 / inverse }
  }
  const speed = (v: Float64Array, { a, b, x, y, ta, tb }: Row) =>
    (v[a] - v[b]) * x + (v[a + 1] - v[b + 1]) * y + v[a + 2] * ta - v[b + 2] * tb
  const take = ({ a, b, x, y, ta, tb }: Row, impulse: number) => {
    if (impulse === 0) return
    const A = bodies[a / 3]
    left[a] -= (x * impulse) / A.mass
    left[a + 1] -= (y * impulse) / A.mass
    left[a + 2] -= (ta * impulse) / A.inertia
    if (b === 3 * n) return
    const B = bodies[b / 3]
    left[b] += (x * impulse) / B.mass
    left[b + 1] += (y * impulse) / B.mass
    left[b + 2] += (tb * impulse) / B.inertia
  }
  const normals = contacts.map((contact) => row(contact, contact.nx, contact.ny))
  const tangents = contacts.map((contact) => row(contact, -contact.ny, contact.nx))
  const pressed = new Float64Array(contacts.length)
  const rubbed = new Float64Array(contacts.length)
  for (let sweep = 0; sweep < sweeps; sweep++) {
    let change = 0
    for (let i = 0; i < contacts.length; i++) {
      const press = Math.max(0, pressed[i] + normals[i].mass * speed(left, normals[i]))
      take(normals[i], press - pressed[i])
      change = Math.max(change, Math.abs(press - pressed[i]) / normals[i].mass)
      pressed[i] = press
      const limit = friction * press
      const rub = rubbed[i] + tangents[i].mass * speed(left, tangents[i])
      const held = Math.max(-limit, Math.min(limit, rub))
      take(tangents[i], held - rubbed[i])
      rubbed[i] = held
    }
    if (change < 1e-9 * gravity * frame) break
  }
  let squares = 0
  let total = 0
  for (let i = 0; i < n; i++) {
    const { mass, inertia } = bodies[i]
    squares += mass * (left[3 * i] ** 2 + left[3 * i + 1] ** 2) + inertia * left[3 * i + 2] ** 2
    total += mass * (gravity * frame) ** 2
  }
  for (let i = 0; i < contacts.length; i++) {
    if (pressed[i] === 0) continue
    const normal = pressed[i] - Math.max(0, pressed[i] - normals[i].mass * speed(now, normals[i]))
    const limit = friction * pressed[i]
    const slipped = rubbed[i] - tangents[i].mass * speed(now, tangents[i])
    const tangent = rubbed[i] - Math.max(-limit, Math.min(limit, slipped))
    squares += normal ** 2 / normals[i].mass + tangent ** 2 / tangents[i].mass
  }
  return Math.sqrt(squares / total)
}

// The method the component's first design described: a chip collides as up to three circles along its length,
// two passes of impulses at 1/120 s, and 80 % of any overlap beyond 0.5 px taken out of the positions, half
// by each side.
import { type Chip, frame, numbersPerChip, type Scene } from '../../scenes/scene'
import type { Engine, Setting } from './engine'

const allowed = 0.5
const share = 0.8

type Body = {
  x: number
  y: number
  angle: number
  vx: number
  vy: number
  spin: number
  inverseMass: number
  inverseInertia: number
  radius: number
  reach: number
  /** offsets of the circles along the chip */
  circles: number[]
}

export const circleChains = {
  name: 'circle-chains',
  packages: [],
  settings: [
    { steps: 2, passes: 2 },
    { steps: 4, passes: 2 },
    { steps: 8, passes: 2 },
    { steps: 8, passes: 8 },
  ],
  accurate: { steps: 8, passes: 8 },
  brief: true,
  async load() {},
  start(scene: Pick<Scene, 'width' | 'height' | 'conditions'>, chips: Chip[], { steps, passes }: Setting) {
    const { gravity, friction, bounce, bounceThreshold, linearDamping, angularDamping } = scene.conditions
    const h = frame / steps
    const bodyOf = (chip: Chip): Body => {
      const radius = Math.min(chip.width, chip.height) / 2
      const half = chip.width > chip.height ? chip.width / 2 - radius : 0
      const mass = chip.width * chip.height * (chip.density ?? 1)
      return {
        x: chip.x,
        y: chip.y,
        angle: chip.angle,
        vx: chip.vx ?? 0,
        vy: chip.vy ?? 0,
        spin: chip.spin ?? 0,
        inverseMass: 1 / mass,
        inverseInertia: 12 / (mass * (chip.width ** 2 + chip.height ** 2)),
        radius,
        reach: half + radius,
        circles: half > 0 ? [-half, 0, half] : [0],
      }
    }
    const bodies = chips.map(bodyOf)

    /** Pushes a off b (or off the stage when there is no b) at a point, along the normal that points at a. */
    function collide(
      a: Body,
      b: Body | null,
      nx: number,
      ny: number,
      overlap: number,
      px: number,
      py: number,
    ) {
      const ax = px - a.x
      const ay = py - a.y
      const bx = b ? px - b.x : 0
      const by = b ? py - b.y : 0
      const approachX = a.vx - a.spin * ay - (b ? b.vx - b.spin * by : 0)
      const approachY = a.vy + a.spin * ax - (b ? b.vy + b.spin * bx : 0)
      const vn = approachX * nx + approachY * ny
      const inverse = a.inverseMass + (b ? b.inverseMass : 0)
      if (vn < 0) {
        const resist = (x: number, y: number) => {
          const armA = ax * y - ay * x
          const armB = bx * y - by * x
          return inverse + armA * armA * a.inverseInertia + (b ? armB * armB * b.inverseInertia : 0)
        }
        const e = -vn > bounceThreshold ? bounce : 0
        const jn = (-(1 + e) * vn) / resist(nx, ny)
        const vt = -approachX * ny + approachY * nx
        const limit = friction * jn
        const jt = Math.max(-limit, Math.min(limit, -vt / resist(-ny, nx)))
        const jx = jn * nx - jt * ny
        const jy = jn * ny + jt * nx
        a.vx += jx * a.inverseMass
        a.vy += jy * a.inverseMass
        a.spin += (ax * jy - ay * jx) * a.inverseInertia
        if (b) {
          b.vx -= jx * b.inverseMass
          b.vy -= jy * b.inverseMass
          b.spin -= (bx * jy - by * jx) * b.inverseInertia
        }
      }
      const push = (share * Math.max(0, overlap - allowed)) / inverse / passes
      a.x += nx * push * a.inverseMass
      a.y += ny * push * a.inverseMass
      if (b) {
        b.x -= nx * push * b.inverseMass
        b.y -= ny * push * b.inverseMass
      }
    }

    function againstStage(a: Body) {
      for (const offset of a.circles) {
        const x = a.x + offset * Math.cos(a.angle)
        const y = a.y + offset * Math.sin(a.angle)
        const floor = y + a.radius - scene.height
        if (floor > 0) collide(a, null, 0, -1, floor, x, scene.height)
        const left = a.radius - x
        if (left > 0) collide(a, null, 1, 0, left, 0, y)
        const right = x + a.radius - scene.width
        if (right > 0) collide(a, null, -1, 0, right, scene.width, y)
      }
    }

    function againstEachOther(a: Body, b: Body) {
      const reach = a.reach + b.reach
      if (Math.abs(a.x - b.x) > reach || Math.abs(a.y - b.y) > reach) return
      const gap = a.radius + b.radius
      for (const i of a.circles) {
        for (const j of b.circles) {
          const dx = a.x + i * Math.cos(a.angle) - b.x - j * Math.cos(b.angle)
          const dy = a.y + i * Math.sin(a.angle) - b.y - j * Math.sin(b.angle)
          const squared = dx * dx + dy * dy
          if (squared >= gap * gap || squared === 0) continue
          const distance = Math.sqrt(squared)
          const nx = dx / distance
          const ny = dy / distance
          const bx = b.x + j * Math.cos(b.angle) + nx * b.radius
          const by = b.y + j * Math.sin(b.angle) + ny * b.radius
          collide(a, b, nx, ny, gap - distance, bx, by)
        }
      }
    }

    return {
      add: (chip: Chip) => bodies.push(bodyOf(chip)),
      step() {
        for (let s = 0; s < steps; s++) {
          for (const a of bodies) {
            a.vy += gravity * h
            const drag = Math.max(0, 1 - linearDamping * h)
            a.vx *= drag
            a.vy *= drag
            a.spin *= Math.max(0, 1 - angularDamping * h)
            a.x += a.vx * h
            a.y += a.vy * h
            a.angle += a.spin * h
          }
          for (let pass = 0; pass < passes; pass++) {
            for (let i = 0; i < bodies.length; i++) {
              againstStage(bodies[i])
              for (let j = i + 1; j < bodies.length; j++) againstEachOther(bodies[i], bodies[j])
            }
          }
        }
      },
      read(out) {
        bodies.forEach((a, i) => {
          out.set([a.x, a.y, a.angle, a.vx, a.vy, a.spin], i * numbersPerChip)
        })
      },
      free() {},
    }
  },
} satisfies Engine

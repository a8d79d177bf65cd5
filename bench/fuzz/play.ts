import { createWorld } from '../../registry/gravity-stack/world'
import { worstOverlap } from '../../scenes/exact-distance'
import { type Check, dragFrames, type FuzzScene, sane } from '../../scenes/fuzzed'
import { massOf } from '../../scenes/references'
import { type Chip, frame } from '../../scenes/scene'
import { hanging, outsideOf } from '../stability/play'

/** s that a scene without an end of its own is played. */
const glimpse = 1.5
/** px of overlap that rest allows; lifting every chip by as much is no energy gained. */
const restOverlap = 0.05
/** px above the floor that a chip may be put to. */
const highestPlace = 1e6
/** px/s, nothing is faster. */
const speedCap = 3600
/** Largest ratio of two masses for which overlap at rest is promised. */
const massRatio = 400

type Failure = { check: Check; frame: number; value: number }

/** What a scene is asked, from what it is: every condition says why a check would be senseless without it. */
function asked(scene: FuzzScene) {
  const { chips, acts, conditions, width } = scene
  const { gravity, bounce, friction, linearDamping, angularDamping } = conditions
  const untouched = acts.length === 0
  const clear = worstOverlap(chips, chips, scene) < 1e-6
  const still = chips.every(({ vx, vy, spin }) => !vx && !vy && !spin)
  const shapes = [...chips, ...acts.flatMap((act) => (act.do === 'reshape' ? [act] : []))]
  const narrowest = Math.min(width, ...acts.flatMap((act) => (act.do === 'resize' ? [act.width] : [])))
  // A chip that can lie across from wall to wall may be wedged there, and must be if it is longer.
  const fits = shapes.every((shape) => Math.hypot(shape.width, shape.height) <= narrowest)
  const masses = shapes.map((shape) => massOf({ density: 1, ...shape }).mass)
  const even = Math.max(...masses) <= massRatio * Math.min(...masses)
  const calm =
    gravity >= 1000 &&
    gravity <= 20_000 &&
    bounce <= 0.5 &&
    friction >= 0.2 &&
    friction <= 2 &&
    linearDamping >= 0.35 &&
    angularDamping >= 1.4 &&
    acts.every((act) => act.do !== 'configure') &&
    // Thrown chips slide and roll for longer than they fly.
    chips.every(({ vx = 0, vy = 0, spin = 0 }) => Math.hypot(vx, vy) <= 600 && Math.abs(spin) <= 20)
  return {
    // What starts in something else is lifted when they part, and a hand or a wall does work.
    energy: untouched && clear && gravity >= 0,
    recovery: untouched && still && gravity >= 0,
    asleep: calm && fits && even,
    overlap: fits && even,
    // Where gravity is turned off what floats stays where it is.
    hanging: gravity > 0 && acts.every((act) => act.do !== 'configure' || act.gravity > 0),
  }
}

/** s after which nothing is in the air any more: flight up and down from the highest start, and bounces. */
export function lastLanding({ chips, acts, conditions, height }: FuzzScene) {
  const { gravity, bounce } = conditions
  const highest = Math.max(
    0,
    ...chips.map(({ y }) => height - y),
    ...acts.map((act) => ('y' in act && Number.isFinite(act.y) ? Math.min(height - act.y, highestPlace) : 0)),
  )
  // A hand lets go at 1800 px/s at most.
  const fastest = Math.max(
    acts.some((act) => act.do === 'drag') ? 1800 : 0,
    ...chips.map(({ vx = 0, vy = 0 }) => Math.hypot(vx, vy)),
  )
  const flight = Math.max(
    (fastest + Math.sqrt(fastest * fastest + 2 * gravity * highest)) / gravity,
    highest / speedCap,
  )
  const acted = Math.max(0, ...acts.map((act) => (act.frame + (act.do === 'drag' ? dragFrames : 0)) * frame))
  return acted + (flight * (1 + bounce)) / (1 - bounce)
}

/**
 * Plays a scene and gives the first thing that went wrong; undefined if all holds. `only` looks at one check.
 * What was asked is put into `made`.
 */
export function playFuzz(given: FuzzScene, only?: Check, made = new Set<Check>()): Failure | undefined {
  const scene = sane(given)
  const { gravity } = scene.conditions
  const ask = asked(scene)
  if (only && only in ask && !ask[only as keyof typeof ask]) return
  const world = createWorld({ width: given.width, height: given.height, ...given.conditions })
  // A density without end makes an obstacle, which stays where it is put, in the floor as well.
  const ids = given.chips.map((chip) =>
    world.add({ ...chip, density: chip.density === Number.POSITIVE_INFINITY ? 1 : chip.density }),
  )
  let chips: (Chip | undefined)[] = [...scene.chips]
  const stage = { width: scene.width, height: scene.height }
  const drags: { until: number; release(): void }[] = []

  const mass = scene.chips.map((chip) => massOf(chip))
  const energy = () =>
    ids.reduce((sum, id, i) => {
      const { y, vx, vy, spin } = world.read(id)
      const moving = (mass[i].mass * (vx * vx + vy * vy) + mass[i].inertia * spin * spin) / 2
      return sum + moving + mass[i].mass * gravity * (scene.height - y)
    }, 0)
  const put = energy()
  const most = 1.001 * put + restOverlap * gravity * mass.reduce((sum, { mass }) => sum + mass, 0)

  const failed = (check: Check, k: number, value: number): Failure | undefined =>
    only === undefined || only === check ? { check, frame: k, value } : undefined
  const acted = Math.max(0, ...scene.acts.map((act) => act.frame + dragFrames))
  const deadline = Math.ceil((lastLanding(scene) + 6) / frame)
  const frames = Math.max(acted + 30, ask.asleep ? deadline : Math.round(glimpse / frame))
  made.add('finite').add('outside')
  for (const check of ['energy', 'recovery', 'asleep'] as const) if (ask[check]) made.add(check)
  for (let k = 1; k <= frames; k++) {
    for (let n = drags.length - 1; n >= 0; n--) if (k >= drags[n].until) drags.splice(n, 1)[0].release()
    for (const [n, act] of scene.acts.entries()) {
      if (act.frame !== k) continue
      const raw = given.acts[n]
      if (act.do === 'resize' && raw.do === 'resize') {
        world.resize(raw.width, raw.height)
        Object.assign(stage, sane({ ...scene, width: raw.width, height: raw.height, chips: [], acts: [] }))
      } else if (act.do === 'configure') world.configure({ gravity: act.gravity })
      else if ('chip' in act) {
        const i = act.chip % Math.max(1, ids.length)
        if (!chips[i]) continue
        if (act.do === 'remove') {
          world.remove(ids[i])
          chips = chips.with(i, undefined)
        } else if (act.do === 'place') world.place(ids[i], { x: act.x, y: act.y })
        else if (act.do === 'reshape' && raw.do === 'reshape') {
          world.reshape(ids[i], raw)
          chips = chips.with(i, { ...chips[i], ...act } as Chip)
        } else if (act.do === 'drag') {
          const { x, y } = world.read(ids[i])
          const grab = world.grab(ids[i], x, y)
          grab.moveTo(x, y, k * frame)
          grab.moveTo(act.x, act.y, (k + 1) * frame)
          drags.push({ until: k + dragFrames, release: grab.release })
        }
      }
    }
    world.step(frame)
    let failure: Failure | undefined
    chips.forEach((chip, i) => {
      if (failure || !chip) return
      const { x, y, angle, vx, vy, spin } = world.read(ids[i])
      if (!Number.isFinite(x + y + angle + vx + vy + spin)) failure = failed('finite', k, i)
      const out = outsideOf(chip, { x, y, angle }, stage)
      if (!(out <= 1)) failure ??= failed('outside', k, out)
      // Until then nothing has fallen far; a chip may be struck by one that did, and leave twice as fast.
      const fallen = 2 * gravity * k * frame
      if (ask.recovery && k <= 15 && !(Math.hypot(vx, vy) <= 1000 + fallen))
        failure ??= failed('recovery', k, Math.hypot(vx, vy) - fallen)
    })
    if (!failure && ask.energy) {
      const now = energy()
      if (!(now <= most)) failure = failed('energy', k, now / put - 1)
    }
    if (failure) return failure
    if (world.resting && k > acted) {
      for (const check of ['overlap', 'hanging'] as const) if (ask[check]) made.add(check)
      return atRest(chips, ids, world, stage, ask, k, failed)
    }
  }
  if (ask.asleep)
    return failed('asleep', frames, ids.filter((id, i) => chips[i] && !world.read(id).asleep).length)
}

function atRest(
  all: (Chip | undefined)[],
  ids: number[],
  world: ReturnType<typeof createWorld>,
  stage: { width: number; height: number },
  ask: ReturnType<typeof asked>,
  k: number,
  failed: (check: Check, k: number, value: number) => Failure | undefined,
) {
  const chips = all.filter((chip) => chip !== undefined)
  const poses = ids.filter((_, i) => all[i]).map((id) => world.read(id))
  if (ask.overlap) {
    const deep = worstOverlap(chips, poses, stage)
    if (!(deep <= restOverlap)) return failed('overlap', k, deep)
  }
  if (ask.hanging) {
    const count = hanging(chips, poses, stage, true)
    if (count > 0) return failed('hanging', k, count)
  }
}

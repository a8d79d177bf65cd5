/** 1/s² · px, s and 1/s as in the component; the rest as Box2D and Rapier set soft contacts by default. */
const gravity = 2600
const substeps = 4
const h = 1 / 60 / substeps
const dampingRatio = 10

/**
 * A column of `count` equal boxes on soft contacts, in one dimension: each contact is a stiff, well damped
 * spring with `hertz` of its own. Returns how far every box has sunk, px, frame by frame, the lowest box
 * first.
 */
export function softStack(count: number, hertz: number, frames: number): number[][] {
  const omega = 2 * Math.PI * hertz
  const a1 = 2 * dampingRatio + h * omega
  const a2 = h * omega * a1
  const a3 = 1 / (1 + a2)
  const sunk = new Array<number>(count).fill(0)
  const speed = new Array<number>(count).fill(0)
  const impulse = new Array<number>(count).fill(0)
  const recording = [[...sunk]]

  // Contact i lies under box i; below box 0 is the floor. Downward counts as positive.
  const below = (values: number[], i: number) => (i > 0 ? values[i - 1] : 0)
  const push = (i: number, by: number) => {
    speed[i] -= by
    if (i > 0) speed[i - 1] += by
  }
  const solve = (soft: boolean) => {
    for (let i = 0; i < count; i++) {
      const mass = i > 0 ? 0.5 : 1
      const gap = below(sunk, i) - sunk[i]
      const approach = below(speed, i) - speed[i]
      const pressed = soft && gap <= 0
      const bias = gap > 0 ? gap / h : pressed ? (omega / a1) * gap : 0
      const change = pressed
        ? -mass * a2 * a3 * (approach + bias) - a3 * impulse[i]
        : -mass * (approach + bias)
      const next = Math.max(0, impulse[i] + change)
      push(i, next - impulse[i])
      impulse[i] = next
    }
  }

  while (recording.length < frames) {
    for (let k = 0; k < substeps; k++) {
      for (let i = 0; i < count; i++) speed[i] += gravity * h
      for (let i = 0; i < count; i++) push(i, impulse[i])
      solve(true)
      for (let i = 0; i < count; i++) sunk[i] += h * speed[i]
      solve(false)
    }
    recording.push([...sunk])
  }
  return recording
}

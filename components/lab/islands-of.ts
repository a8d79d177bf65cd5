import { chipDistance, type Pose, type Shape } from '@/scenes/exact-distance'

/** px, gap below which two chips count as touching here. */
const touch = 0.2

/**
 * Numbers every chip by the lowest chip that it touches directly or through others: equal numbers are an
 * island.
 */
export function islandsOf(shapes: Shape[], poses: Pose[]): number[] {
  const root = poses.map((_, i) => i)
  const find = (i: number): number => (root[i] === i ? i : find(root[i]))
  const reach = poses.map((_, i) => Math.hypot(shapes[i].width, shapes[i].height) / 2)
  for (let i = 0; i < poses.length; i++) {
    for (let j = 0; j < i; j++) {
      if (Math.hypot(poses[i].x - poses[j].x, poses[i].y - poses[j].y) > reach[i] + reach[j] + touch) continue
      if (chipDistance(shapes[i], poses[i], shapes[j], poses[j]) > touch) continue
      const [a, b] = [find(i), find(j)]
      root[Math.max(a, b)] = Math.min(a, b)
    }
  }
  return root.map((_, i) => find(i))
}

import type { Bodies } from './state'

/** Islands: groups of chips that carry one another, which fall asleep together. A forest of disjoint sets. */

/** Root of the group of body `i`, with a shorter way to it for the next time. */
export function findGroup(parent: Int32Array, i: number): number {
  while (parent[i] !== i) i = parent[i] = parent[parent[i]]
  return i
}

/** Joins the groups of bodies `a` and `b`. The result has rested for as long as the one that rested less. */
export function joinGroups({ parent, groupRest }: Bodies, a: number, b: number): void {
  const root = findGroup(parent, a)
  const leaf = findGroup(parent, b)
  parent[leaf] = root
  groupRest[root] = Math.min(groupRest[root], groupRest[leaf])
}

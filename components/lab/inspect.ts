import type { Contact, World } from '@/registry/gravity-stack/world'

type Inspection = {
  touches: Contact['points']
  /** By id: the lowest id among all that touch each other, at any remove. */
  islands: Map<number, number>
  /** Pairs that the broad phase keeps, and those of them that touch. */
  pairs: number
  contacts: number
}

/** Reads from a world what the overlay of the playground draws. */
export function inspect(world: World): Inspection {
  const contacts = world.contacts()
  const islands = new Map(world.ids.map((id) => [id, id]))
  const find = (id: number): number => {
    const next = islands.get(id) ?? id
    return next === id ? id : find(next)
  }
  for (const { a, b } of contacts) {
    // Chips that only touch the same floor, wall or obstacle are apart.
    if (!islands.has(a) || !islands.has(b)) continue
    const [i, j] = [find(a), find(b)]
    islands.set(Math.max(i, j), Math.min(i, j))
  }
  for (const id of islands.keys()) islands.set(id, find(id))
  const { pairs } = world.stats
  return { touches: contacts.flatMap(({ points }) => points), islands, pairs, contacts: contacts.length }
}

/** Mean mass of the chips, in units of density · px². */
export function meanMass(world: World): number {
  const { ids } = world
  const sum = ids.reduce((total, id) => total + world.mass(id).mass, 0)
  return ids.length > 0 ? sum / ids.length : 1
}

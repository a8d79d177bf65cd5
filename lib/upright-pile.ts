import 'server-only'
import { createPile } from '@/components/lab/pile'
import { chips, isUpsideDown, shapes } from '@/components/lab/upright-chips'
import { BOUNCE, FRICTION, GRAVITY } from '@/registry/gravity-stack/solver/constants'
import { uprightTurn } from '@/registry/gravity-stack/stage/look-ahead'

export const uprightStage = { width: 400, height: 232 }
/** Drops among which the one is taken that leaves most words upside down. */
const drops = 40
/** Steps after which a pile counts as one that does not rest. */
const longest = 1200

function fall(seed: number) {
  const options = {
    ...uprightStage,
    gravity: GRAVITY,
    bounce: BOUNCE,
    friction: FRICTION,
    stagger: 130,
    seed,
  }
  const pile = createPile(options, shapes)
  for (let step = 0; step < longest && !pile.resting; step++) pile.step()
  return pile.ids.map((id, i) => {
    const { x, y, angle } = pile.world.read(id)
    return { word: chips[i][0], ...shapes[i], x, y, angle, turn: uprightTurn(shapes[i], angle) }
  })
}

export type LyingChip = ReturnType<typeof fall>[number]

/**
 * A pile at rest, as the component's solver leaves it: for each chip its angle, and the turn that puts its
 * word upright.
 */
export function uprightPile() {
  const piles = Array.from({ length: drops }, (_, i) => fall(1 + i))
  const upsideDown = (pile: LyingChip[]) => pile.filter(isUpsideDown).length
  const pile = piles.reduce((most, other) => (upsideDown(other) > upsideDown(most) ? other : most))
  return { pile, upsideDown: upsideDown(pile) }
}

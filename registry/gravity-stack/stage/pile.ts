import { createWorld, type World } from '../solver/world'
import { applyCornerRadius, type Chip, draw, drawAt, measureRadius, setState } from './chip'
import type { Context } from './context'
import { LONGEST_FRAME } from './frame-loop'
import { launchMotion } from './launch'
import { type LookAhead, uprightTurn } from './look-ahead'
import { addReleased, type Pile, reach } from './release'
import type { ReleaseQueue } from './release-queue'

function reset(chip: Chip) {
  chip.id = -1
  chip.turn = 0
  chip.turned = false
  setState(chip, 'waiting')
}

/** The chips of a stage in their world: how they come into it, are drawn, change and leave. */
export function createPile(
  context: Context,
  queue: ReleaseQueue,
  lookAhead: LookAhead<Chip>,
  changes: MutationObserver,
) {
  const { settings } = context
  let launches = 0
  /** Whether `recover` has run since somebody last did something. */
  let recovered = false

  function drawMoved(id: number, x: number, y: number, bodyAngle: number, asleep: boolean) {
    const chip = pile.chips[id]!
    if (!chip.turned) turnUnseen(chip, y)
    drawAt(chip, x, y, bodyAngle + chip.turn, asleep)
  }

  /** Turns a chip to what will lie upright, in the last frame in which it is sure to be out of sight. */
  function turnUnseen(chip: Chip, y: number) {
    const world = pile.world!
    const fall = LONGEST_FRAME * (world.read(chip.id).vy + (LONGEST_FRAME / 2) * world.scene.pull)
    const bottom = y + chip.reach
    if (bottom + fall < 0) return
    chip.turned = true
    // Before a chip is first drawn it is out of sight as well.
    if (bottom > 0 && !Number.isNaN(chip.x)) return
    chip.turn = uprightTurn(chip, lookAhead.expectedAngle(chip) ?? 0)
  }

  const pile = {
    world: undefined as World | undefined,
    /** The chips in the world, by the ids of their bodies. */
    chips: [] as Chip[],

    /** Begins a drop of all chips, with the clock of the queue at `clock`. */
    begin(clock: number) {
      pile.world = createWorld(context)
      pile.world.configure(settings)
      pile.chips = []
      queue.restart(clock)
      context.chips.forEach((chip) => {
        reset(chip)
        if (chip.width) queue.add(chip)
      })
    },

    /** Lets the time pass until `end`, s on the clock of the queue, with the releases on the way. */
    advance(end: number) {
      const world = pile.world!
      while (queue.chips[0] && queue.chips[0].due <= end) {
        const chip = queue.chips.shift()!
        world.step(chip.due - queue.clock)
        queue.clock = chip.due
        pile.release(chip)
      }
      world.step(end - queue.clock)
      queue.clock = end
    },

    release(chip: Chip) {
      const { radius } = chip
      measureRadius(chip, changes)
      // The look-ahead has released it with another radius.
      if (radius !== chip.radius) queue.revision++
      queue.latest = queue.clock
      chip.id = addReleased(pile as Pile<Chip>, chip)
      chip.x = Number.NaN
    },

    /** Takes a chip out of the world or the queue; returns whether it was in the queue. */
    withdraw(chip: Chip) {
      const waited = queue.remove(chip)
      pile.world?.remove(chip.id)
      delete pile.chips[chip.id]
      reset(chip)
      return waited
    },

    /** Takes over the size (px) that a chip has now, and the corner radius with it. */
    setSize(chip: Chip, width: number, height: number) {
      const sameSize = chip.width === width && chip.height === height
      if (!chip.width) queue.add(chip)
      chip.width = width
      chip.height = height
      chip.reach = reach(width, height)
      // The radius of a chip that waits is read when its turn comes: at first that would be all of them in
      // one frame.
      if (chip.id < 0) {
        chip.radius = Number.NaN
        queue.revision++
        return
      }
      const { radius } = chip
      measureRadius(chip, changes)
      if (sameSize && chip.radius === radius) return
      const world = pile.world!
      // A body of another shape looks different after a turn: it is turned to where its chip is drawn.
      if (chip.turn) world.place(chip.id, { angle: world.read(chip.id).angle + chip.turn })
      chip.turn = 0
      world.reshape(chip.id, chip)
      draw(chip)
      applyCornerRadius(chip)
    },

    draw: () => pile.world!.eachMoved(drawMoved),

    /**
     * Something has another size or place. In a paused stage no time passes, but nothing may stay inside
     * another.
     */
    makeRoom() {
      context.update()
      if (!pile.world || !context.pausing.current) return
      pile.world.makeRoom()
      pile.draw()
    },

    /** Takes hold of a chip at a point, px from its centre. */
    grab(chip: Chip, offX: number, offY: number) {
      pile.touch()
      const { x, y } = pile.world!.read(chip.id)
      return pile.world!.grab(chip.id, x + offX, y + offY)
    },

    /** Sends a chip about `height` px up, which is against gravity. */
    launch(chip: Chip, height: number) {
      pile.touch()
      const world = pile.world!
      world.place(chip.id, launchMotion(launches++, height, world.gravity, chip.angle))
    },

    /** Releases chips anew that lie above a stage whose gravity would not bring them back. */
    recover() {
      // Only once until somebody does something: a full stage would push them out again and again.
      if (settings.gravity.y > Math.abs(settings.gravity.x) || recovered) return
      recovered = true
      pile.chips.forEach((chip) => {
        if (chip.y < -chip.reach) {
          pile.withdraw(chip)
          queue.add(chip)
        }
      })
    },

    /** Lets `recover` run once more, as somebody does something. */
    touch() {
      recovered = false
    },
  }
  return pile
}

export type StagePile = ReturnType<typeof createPile>

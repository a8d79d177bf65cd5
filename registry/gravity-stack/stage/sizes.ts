import type { Children } from './children'
import type { Chip } from './chip'
import type { Context } from './context'
import type { StagePile } from './pile'
import { warn } from './props'

/** What a stage does when sizes change. */
interface SizeEvents {
  /** A chip has lost its size. */
  emptied(chip: Chip): void
  /** The stage has a size; before, it had none if `appeared`. */
  stageSized(appeared: boolean): void
  /** All that a paused stage shows has been brought in line. */
  done(): void
}

/** Watches the sizes of a stage and its chips. */
export function createSizes(
  context: Context,
  { chips, chipAt }: Children,
  pile: StagePile,
  { emptied, stageSized, done }: SizeEvents,
) {
  const { root, view } = context
  /** Nothing is watched while the chips stand in their row. */
  let watching = false
  const observer = new view.ResizeObserver((entries) => {
    for (const { target, contentRect } of entries) {
      const chip = chipAt(target)
      if (chip) setChipSize(chip, contentRect.width, contentRect.height)
      else if (target === root) readStageSize()
    }
    context.update()
    if (!pile.world || !context.pausing.current) return
    // No time passes, but nothing may stay behind a wall or in another chip.
    pile.world.makeRoom()
    pile.draw()
    done()
  })

  function readStageSize() {
    const appeared = !(context.width * context.height)
    context.width = root.clientWidth
    context.height = root.clientHeight
    if (!(context.width * context.height)) return
    stageSized(appeared)
    // A chip that has lost its size while the stage had none had none to lose.
    if (appeared)
      chips.forEach((chip) => {
        if (chip.width && !chip.element.offsetWidth) setChipSize(chip, 0, 0)
      })
  }

  function setChipSize(chip: Chip, width: number, height: number) {
    if (width * height) return pile.setSize(chip, width, height)
    // A chip keeps its place while it is hidden with its stage, and while its content has the whole screen.
    if (!(context.width * context.height) || chip.element.querySelector(':fullscreen')) return
    if (process.env.NODE_ENV !== 'production')
      warn('a chip has no size, so it waits. Give it content, or a width and a height, and it falls.')
    chip.width = 0
    emptied(chip)
  }

  const sizes = {
    /** Watches the stage and its chips, or nothing; returns whether that is new. */
    watch(yes: boolean) {
      if (yes === watching) return false
      watching = yes
      observer.disconnect()
      if (yes) {
        observer.observe(root)
        chips.forEach(sizes.add)
      }
      return true
    },
    add({ element }: Chip) {
      if (watching) observer.observe(element)
    },
    remove: ({ element }: Chip) => observer.unobserve(element),
  }
  return sizes
}

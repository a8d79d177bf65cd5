import type { Chip } from './chip'
import type { Context } from './context'
import type { Focus } from './focus'
import type { StagePile } from './pile'
import { warn } from './props'

/** Watches the sizes of a stage and its chips; calls `resize` when the stage has another. */
export function createSizes(
  context: Context,
  pile: StagePile,
  focus: Focus,
  resize: (appeared: boolean) => void,
  withdraw: (chips: Chip[]) => void,
) {
  const { root, view, chips } = context
  /** Nothing is watched while the chips stand in their row. */
  let watching = false
  const observer = new view.ResizeObserver((entries) => {
    for (const { target, contentRect } of entries) {
      const chip = chips.get(target)
      if (chip) setChipSize(chip, contentRect.width, contentRect.height)
      else readStageSize()
    }
    pile.makeRoom()
    // A chip may have got the focus before it had a size.
    focus.bringIn()
  })

  function readStageSize() {
    const appeared = !context.width
    context.height = root.clientHeight
    context.width = context.height && root.clientWidth
    if (!context.width) return
    resize(appeared)
    // Chips may have lost their size while the stage had none. Those are withdrawn now.
    if (appeared)
      chips.forEach((chip) => {
        if (chip.width && !chip.element.offsetWidth) setChipSize(chip, 0, 0)
      })
  }

  function setChipSize(chip: Chip, width: number, height: number) {
    if (width * height) return pile.setSize(chip, width, height)
    // A chip keeps its place while it is hidden with its stage, and while its content has the whole screen.
    if (!context.width || chip.element.querySelector(':fullscreen')) return
    if (process.env.NODE_ENV !== 'production')
      warn('a chip has no size, so it waits. Give it content, or a width and a height, and it falls.')
    chip.width = 0
    withdraw([chip])
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

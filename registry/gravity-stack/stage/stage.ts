import { chipAt, collectChips } from './children'
import { type Chip, measureRadius } from './chip'
import { createClicks } from './clicks'
import type { Context, View } from './context'
import { createFocus } from './focus'
import { followHover } from './hover'
import { createLifecycle } from './lifecycle'
import { listenUntil } from './listeners'
import { createLookAhead } from './look-ahead'
import { createObstacles } from './obstacles'
import { createPile } from './pile'
import { createPlan } from './plan'
import { createPointers } from './pointers'
import { checkedProps, type Settings, type StageProps, warn } from './props'
import { createReleaseQueue } from './release-queue'
import { createSizes } from './sizes'
import { createVisibility } from './visibility'

/** While one holds, CSS has the chips stand in a row. The markup also asks whether there is script. */
const STILL = 'print, (prefers-reduced-motion: reduce)'
/** px, how high a shake throws at most (D-002). */
const SHAKE = 230

function warnWithoutStyles(root: HTMLElement) {
  if (getComputedStyle(root).position === 'static')
    warn(
      'Tailwind has made no styles for it, so its words lie one over the other. Is Tailwind set up, and does it scan this file?',
    )
}

export type Stage = ReturnType<typeof createStage>

/** `pausing.current` is whether the caller has paused the stage, maybe before there is a stage. */
export function createStage(root: HTMLElement, pausing: { current: boolean }) {
  const page = root.ownerDocument
  const view = page.defaultView as View
  const still = view.matchMedia(STILL)
  const settings = {} as Settings
  const chips = new Map<Element, Chip>()
  const context: Context = { root, view, still, pausing, settings, chips, width: 0, height: 0, update }
  /** Ends all listeners; there from when the stage comes near the view until it is detached. */
  let listening: AbortController | undefined

  const changes = new MutationObserver((records) => {
    for (const { target } of records) restyle(target)
    collect()
    pointers.capture()
    update()
  })
  const queue = createReleaseQueue(settings)
  const lookAhead = createLookAhead<Chip>((chip) => {
    if (Number.isNaN(chip.radius)) measureRadius(chip, changes)
  })
  const pile = createPile(context, queue, lookAhead, changes)
  const obstacles = createObstacles(context, pile)
  const visibility = createVisibility(context, () => {
    if (process.env.NODE_ENV !== 'production') warnWithoutStyles(root)
    changes.observe(root, { childList: true, subtree: true })
    listen()
    collect()
    update()
  })
  const plan = createPlan(context, queue, lookAhead, pile, visibility, obstacles)
  const focus = createFocus(context, pile, () => {
    visibility.start()
    queue.catchUp()
    queue.reschedule()
  })
  const sizes = createSizes(context, pile, focus, resize, withdraw)
  const lifecycle = createLifecycle(context, queue, pile, plan, visibility, focus)
  const clicks = createClicks(context, pile, lifecycle)
  const pointers = createPointers(context, pile, focus, lifecycle, clicks)

  function restyle(target: EventTarget | null) {
    const chip = chipAt(chips, target)
    if (chip?.width) pile.setSize(chip, chip.width, chip.height)
  }

  function collect() {
    const gone = collectChips(root, chips)
    chips.forEach((chip, element) => {
      if (gone.delete(element)) return
      sizes.add(chip)
      // The chip may have come with the focus.
      if (element.matches(':focus-within')) focus.on(element)
    })
    gone.forEach(sizes.remove)
    withdraw(Array.from(gone.values()))
    obstacles.find()
  }

  /** The stage has another size, or had none before. */
  function resize(appeared: boolean) {
    // A stage without a size counts as wholly in view, so the browser tells nothing new when it gets one.
    if (appeared) visibility.checkAgain()
    if (!pile.world) return plan.begin()
    pile.world.resize(context.width, context.height)
    obstacles.measure()
  }

  function withdraw(chips: Chip[]) {
    chips.forEach(pointers.letGo)
    if (chips.filter(pile.withdraw).length) queue.reschedule()
  }

  function listen() {
    listening?.abort()
    listening = new AbortController()
    const on = listenUntil(listening)
    on(still, 'change', update)
    on(page, 'visibilitychange', update)
    on(root, 'transitionend', ({ target }) => {
      restyle(target)
      update()
    })
    focus.listen(on)
    pointers.letGo()
    if (!settings.interactive) return
    pointers.listen(on)
    clicks.listen(on)
    if (settings.push) followHover(on, context, pile, lifecycle)
  }

  /** Brings all in line with what is known. Every event ends here. */
  function update() {
    if (!listening) return
    // Asked here, as Chromium fires no event for a change that was read before: in a tab that is shown again.
    if (sizes.watch(!still.matches)) {
      obstacles.find()
      // A chip that has the focus in the row does not wait for its release.
      if (!still.matches) focus.on(focus.active())
    }
    lifecycle.update()
    if (!lifecycle.isLive()) pointers.letGo()
  }

  return {
    update,

    /** Takes over new props at any time. */
    setProps(props: StageProps) {
      const before = { ...settings }
      Object.assign(settings, checkedProps(props))
      const differ = (...names: (keyof Settings)[]) =>
        names.some((name) => JSON.stringify(settings[name]) !== JSON.stringify(before[name]))
      if (listening) {
        if (differ('interactive', 'push')) listen()
        obstacles.find()
      }
      if (differ('gravity', 'ceiling', 'bounce', 'friction')) pile.world?.configure(settings)
      if (differ('stagger')) queue.reschedule()
      update()
    },

    drop() {
      if (!pile.world || !visibility.wasInView || still.matches) return
      pointers.letGo()
      pausing.current = false
      plan.show()
      plan.begin()
      update()
    },

    shake() {
      if (still.matches || plan.settling) return
      pile.chips.forEach((chip) => {
        pile.launch(chip, SHAKE)
      })
      update()
    },

    /** To be called once the element is on the page, and again after `detach`. */
    attach: visibility.observe,

    /** Lets go of everything outside of the stage. The pile stays, as React only hides some components. */
    detach() {
      visibility.disconnect()
      update()
      pointers.letGo()
      listening?.abort()
      listening = undefined
      plan.end()
      sizes.watch(false)
      obstacles.stop()
      changes.disconnect()
    },
  }
}

import { exposeAngle } from './chip'
import type { Context } from './context'
import type { Focus } from './focus'
import { createFrameLoop } from './frame-loop'
import { SLICE } from './look-ahead'
import type { StagePile } from './pile'
import type { Plan } from './plan'
import { warn } from './props'
import type { ReleaseQueue } from './release-queue'
import { nextState, type StageState } from './state'
import type { Visibility } from './visibility'

/** Owns the state of a stage, and with it what passes the time: frames, a timer, or nothing. */
export function createLifecycle(
  context: Context,
  queue: ReleaseQueue,
  pile: StagePile,
  plan: Plan,
  visibility: Visibility,
  focus: Focus,
) {
  const { root, settings, still, pausing, chips } = context
  let state: StageState = 'static'
  /** Whether the last frame asked for no slice of the plan. */
  let skipped = false
  const loop = createFrameLoop(context.view, (seconds) => {
    const end = performance.now() + SLICE
    pile.advance(queue.clock + seconds)
    pile.draw()
    focus.follow()
    // After a long frame the slice is left out once, so that two long tasks do not meet.
    skipped = !skipped && performance.now() > end
    if (!skipped) plan.request()
    if (!pile.world!.resting) return
    pile.recover()
    context.update()
  })

  /** The next release is due after a time without frames. */
  function arrive() {
    queue.setIdle(false)
    pile.advance(queue.chips[0]!.due)
    context.update()
  }

  function enter(next: StageState) {
    const settled = state === 'running' && next === 'resting'
    state = next
    pile.touch()
    root.setAttribute('data-state', next)
    // Rules for chips use this attribute. With `data-state` each change of state would style all chips anew.
    root.toggleAttribute('data-halted', next === 'static' || next === 'paused')
    if (next === 'resting') {
      pile.chips.forEach(exposeAngle)
      if (process.env.NODE_ENV !== 'production') warnOfLargeChips()
    }
    // After the frame: an error in a callback would end Motion's loop for the whole page.
    if (settled && settings.onSettle) queueMicrotask(settings.onSettle)
  }

  /** Warns only at rest, as a stage that opens is small at first. CSS keeps a chip a pixel narrower. */
  function warnOfLargeChips() {
    const { width, height } = context
    chips.forEach((chip) => {
      if (width * height && (chip.width > width - 2 || chip.height > height))
        warn(
          'a chip is as wide as its stage, or larger than it, so it may jam or be cut off. Make the chip smaller or the stage larger.',
        )
    })
  }

  const lifecycle = {
    /** Running or at rest: people may touch the stage. */
    isLive: () => state === 'running' || state === 'resting',

    update() {
      queue.catchUp()
      const { world } = pile
      const idle = !!world?.resting
      const next = nextState({
        still: still.matches,
        ready: visibility.started && !!world && !plan.settling,
        paused: pausing.current,
        settled: idle && !queue.chips.length,
        shown: visibility.inView && !root.ownerDocument.hidden && context.width > 0,
      })
      const running = next === 'running'
      if (running && !idle) loop.run()
      // Nothing moves before the next release: a timer is enough until then.
      else if (running) loop.wait(arrive, queue.chips[0]!.due - queue.clock)
      else loop.stop()
      queue.setIdle(idle && (running || next === 'resting'))
      plan.enable(!!world && (plan.settling || settings.upright) && (running || next === 'waiting'))
      if (next !== state) enter(next)
    },
  }
  return lifecycle
}

export type Lifecycle = ReturnType<typeof createLifecycle>

import { cornerRadius } from './chip'
import type { Context } from './context'
import type { StagePile } from './pile'
import { pointerMap } from './pointer-map'
import { warn } from './props'
import { EVERY_PERCENT } from './visibility'

/**
 * px (and rad) by which an obstacle may change unnoticed: a page that scrolls rounds places, and is to wake
 * no pile (D-050).
 */
const UNNOTICED = 0.04

/** An element that chips land on. */
interface ObstacleElement {
  /** In the world, or -1, and as what: x, y, angle, width, height, radius, or nothing. */
  id: number
  placed: number[]
  /** Sees the element move or change its size. */
  watch?: IntersectionObserver
}

/** Tells a developer what is wrong with the place or the size (px) of an obstacle. */
function warnOfPlace(
  { clientWidth, clientHeight }: HTMLElement,
  x: number,
  y: number,
  angle: number,
  width: number,
  height: number,
) {
  const high = height * Math.abs(Math.cos(angle)) + width * Math.abs(Math.sin(angle))
  if (width >= clientWidth && height >= clientHeight)
    warn(
      'an obstacle is as large as its stage and would leave no room, so chips fall through it. Make it smaller, or the stage larger.',
    )
  else if (!(width * height))
    warn(
      'an obstacle has no size, so chips fall through it. They land on it once it has one: give it a width and a height.',
    )
  else if (y - high / 2 < 0 && Math.abs(x - clientWidth / 2) < (clientWidth + width) / 2)
    warn(
      'an obstacle reaches out of the top of its stage and covers the way in, so chips may stay on it, unseen. Move it down, or make it smaller.',
    )
}

/** The obstacles of a stage: children that stay where they are, and what refs lead to. */
export function createObstacles({ root, view, still, settings }: Context, pile: StagePile) {
  const all = new Map<Element, ObstacleElement>()

  /**
   * Has `measure` called once the element is drawn elsewhere: the observer sees no more of the page than the
   * element's own box.
   */
  function watchPlace(element: Element, obstacle: ObstacleElement, { x, y, right, bottom }: DOMRect) {
    const { clientWidth, clientHeight } = root.ownerDocument.documentElement
    const insets = [y, clientWidth - right, clientHeight - bottom, x].map((inset) => -Math.floor(inset))
    // Of what is out of view all that can be seen is that it comes in.
    const hidden = y > clientHeight || x > clientWidth || bottom < 0 || right < 0
    let first = true
    obstacle.watch?.disconnect()
    obstacle.watch = new view.IntersectionObserver(
      ([entry]) => {
        const { boundingClientRect: now } = entry!
        if (!first || now.x !== x || now.y !== y) measure()
        first = false
      },
      {
        root: root.ownerDocument,
        rootMargin: hidden ? '0px' : `${insets.join('px ')}px`,
        threshold: EVERY_PERCENT,
      },
    )
    obstacle.watch.observe(element)
  }

  /** Brings the world in line with where the elements are. */
  function measure() {
    const { world } = pile
    if (!world || !all.size) return
    const box = root.getBoundingClientRect()
    if (!(box.width * box.height)) return
    const toStage = pointerMap(root, box)
    let any = false
    all.forEach((obstacle, element) => {
      const rect = element.getBoundingClientRect()
      watchPlace(element, obstacle, rect)
      const style = getComputedStyle(element)
      const own = new DOMMatrix(style.transform)
      // Rounded, as engines disagree on the last bits.
      const turned = Math.atan2(own.b, own.a) + ((Number.parseFloat(style.rotate) || 0) * Math.PI) / 180
      const angle = Math.round(turned * 1e4) / 1e4
      // The box around what is turned is larger than that, and has the same middle.
      const scale = Math.hypot(own.a, own.b) * (Number.parseFloat(style.scale) || 1)
      const { offsetWidth, offsetHeight } = element as HTMLElement
      const unit = Math.hypot(toStage.a, toStage.b)
      const width = angle ? scale * offsetWidth : unit * rect.width
      const height = angle ? scale * offsetHeight : unit * rect.height
      const { x, y } = toStage.transformPoint({
        x: rect.x + rect.width / 2 - box.x,
        y: rect.y + rect.height / 2 - box.y,
      })
      const radius = cornerRadius(style, width, height)
      const large = width >= root.clientWidth && height >= root.clientHeight
      const body = width * height > 0 && !large ? [x, y, angle, width, height, radius] : []
      if (process.env.NODE_ENV !== 'production') warnOfPlace(root, x, y, angle, width, height)
      const { placed } = obstacle
      if (body.length === placed.length && body.every((n, i) => Math.abs(n - placed[i]!) < UNNOTICED)) return
      any = true
      obstacle.placed = body
      world.remove(obstacle.id)
      obstacle.id = body.length ? world.add({ x, y, angle, width, height, radius, density: Infinity }) : -1
    })
    if (any) pile.makeRoom()
  }

  return {
    measure,

    /** The pile has a new world, which knows none of the obstacles yet. */
    enter() {
      all.forEach((obstacle) => {
        obstacle.id = -1
        obstacle.placed = []
      })
      measure()
    },

    /** Looks for obstacles anew. */
    find() {
      const refs = settings.obstacles ? [settings.obstacles].flat().map((ref) => ref?.current) : []
      const elements = refs.filter((element) => element instanceof view.Element)
      if (process.env.NODE_ENV !== 'production' && elements.length < refs.length)
        warn(
          'a ref among obstacles leads to no element yet, so chips fall through there. It is looked at again when the stage renders: give its element the ref, and render the stage once it is there.',
        )
      elements.push(...Array.from(root.querySelectorAll(':scope>[data-static]')))
      if (still.matches) elements.length = 0
      let fresh = false
      all.forEach((obstacle, element) => {
        if (elements.includes(element)) return
        obstacle.watch?.disconnect()
        pile.world?.remove(obstacle.id)
        all.delete(element)
        pile.makeRoom()
      })
      for (const element of elements) {
        if (element.contains(root)) {
          if (process.env.NODE_ENV !== 'production')
            warn(
              'an obstacle is the stage itself or around it, so chips fall through it. Pass elements beside the stage, or give children data-static.',
            )
        } else if (!all.get(element)?.watch) {
          fresh = true
          all.set(element, all.get(element) ?? { id: -1, placed: [] })
        }
      }
      if (fresh) measure()
    },

    /** Watches nothing any more, until it is told again what the obstacles are. */
    stop() {
      all.forEach((obstacle) => {
        obstacle.watch?.disconnect()
        delete obstacle.watch
      })
    },
  }
}

export type Obstacles = ReturnType<typeof createObstacles>

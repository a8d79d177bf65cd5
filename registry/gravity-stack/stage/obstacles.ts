import { cornerRadius } from './chip'
import type { Context } from './context'
import type { StagePile } from './pile'
import { pointerMap } from './pointer-map'
import { warn } from './props'
import { EVERY_PERCENT } from './visibility'

/**
 * px (and rad) by which an obstacle may change unnoticed. Scrolling rounds the places of elements, and must
 * wake no pile (D-050).
 */
const UNNOTICED = 0.04

/** An element that chips land on. */
interface ObstacleElement {
  /** The id of its body in the world, or -1. */
  id: number
  /** The body's x, y, angle, width, height and radius, and 1 if the stage has room for it. */
  placed?: number[]
  /** Tells when the element moves or changes its size. */
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
   * Has `measure` called once the element is drawn elsewhere. The observer looks at the element's present box
   * alone, and any move changes what share of the element is in that box.
   */
  function watchPlace(element: Element, obstacle: ObstacleElement, { x, y, right, bottom }: DOMRect) {
    const { clientWidth, clientHeight } = root.ownerDocument.documentElement
    const insets = [y, clientWidth - right, clientHeight - bottom, x].map((inset) => -Math.floor(inset))
    // Of an element out of view an observer only tells that the element comes into view.
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
    let moved = false
    all.forEach((obstacle, element) => {
      const rect = element.getBoundingClientRect()
      watchPlace(element, obstacle, rect)
      const style = getComputedStyle(element)
      const own = new DOMMatrix(style.transform)
        .rotate(Number.parseFloat(style.rotate) || 0)
        .scale(Number.parseFloat(style.scale) || 1)
      // The angle is rounded, as engines disagree on its last bits.
      const angle = Math.round(Math.atan2(own.b, own.a) * 1e4) / 1e4
      // The bounding box of a turned element is larger than the element, and has the same middle.
      const scale = Math.hypot(own.a, own.b)
      const { offsetWidth, offsetHeight } = element as HTMLElement
      const unit = Math.hypot(toStage.a, toStage.b)
      const width = angle ? scale * offsetWidth : unit * rect.width
      const height = angle ? scale * offsetHeight : unit * rect.height
      const { x, y } = toStage.transformPoint({
        x: rect.x + rect.width / 2 - box.x,
        y: rect.y + rect.height / 2 - box.y,
      })
      const radius = cornerRadius(style, width, height)
      const fits = width < root.clientWidth || height < root.clientHeight
      if (process.env.NODE_ENV !== 'production') warnOfPlace(root, x, y, angle, width, height)
      const place = [x, y, angle, width, height, radius, +fits]
      if (obstacle.placed?.every((n, i) => Math.abs(n - place[i]!) < UNNOTICED)) return
      moved = true
      obstacle.placed = place
      world.remove(obstacle.id)
      obstacle.id =
        fits && width * height ? world.add({ x, y, angle, width, height, radius, density: Infinity }) : -1
    })
    // Scrolling the page measures all of them again and moves none.
    if (moved) pile.makeRoom()
  }

  const obstacles = {
    measure,

    /** Puts all obstacles into a new world of the pile. */
    enter() {
      obstacles.stop()
      all.clear()
      obstacles.find()
    },

    /** Looks for obstacles anew. */
    find() {
      const refs = [settings.obstacles || []].flat().map((ref) => ref?.current)
      const elements = refs.filter((element) => element instanceof view.Element)
      if (process.env.NODE_ENV !== 'production' && elements.length < refs.length)
        warn(
          'a ref among obstacles leads to no element yet, so chips fall through there. Give an element this ref, then render the stage again.',
        )
      elements.push(...Array.from(root.querySelectorAll(':scope>[data-static]')))
      if (still.matches) elements.length = 0
      all.forEach((obstacle, element) => {
        if (elements.includes(element)) return
        obstacle.watch?.disconnect()
        pile.world?.remove(obstacle.id)
        all.delete(element)
        pile.makeRoom()
      })
      const known = all.size
      for (const element of elements) {
        if (element.contains(root)) {
          if (process.env.NODE_ENV !== 'production')
            warn(
              'an obstacle is the stage itself or around it, so chips fall through it. Pass elements beside the stage, or give children data-static.',
            )
        } else if (!all.has(element)) all.set(element, { id: -1 })
      }
      if (all.size > known) measure()
    },

    /** Ends all observers, until the obstacles are measured again. */
    stop() {
      all.forEach(({ watch }) => {
        watch?.disconnect()
      })
    },
  }
  return obstacles
}

export type Obstacles = ReturnType<typeof createObstacles>

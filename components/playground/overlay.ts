import type { Pose, Shape } from '@/scenes/exact-distance'
import { chipColours, drawChip, drawDot, drawLine, paletteOf } from '../lab/draw'
import { inspect, meanMass } from '../lab/inspect'
import type { Pile } from '../lab/pile'

/** px, how long the weight of a mean chip is drawn, and the longest force. */
export const weightLength = 12
const longestForce = 80
const expectedDash = [2, 3]
const asleepColour = '#bab3ab'

/** px, how far a mark stands out above the words of a chip. */
const markLength = 10

/** A mark above the words of a chip at `pose`. */
function drawMark(
  context: CanvasRenderingContext2D,
  { height }: Shape,
  { x, y, angle }: Pose,
  colour: string,
  dash?: number[],
) {
  const at = (distance: number): [number, number] => [
    x + distance * Math.sin(angle),
    y - distance * Math.cos(angle),
  ]
  drawLine(context, at(height / 2), at(height / 2 + markLength), colour, dash)
}

/**
 * Draws over the chips what the solver knows of them: who sleeps, who touches whom, and how hard; and beside
 * how a moving chip is turned now, how the look-ahead expects it to lie.
 */
export function drawOverlay(
  canvas: HTMLCanvasElement,
  { world, ids, shapes, turned }: Pile,
  words: string[],
) {
  const scale = devicePixelRatio
  canvas.width = canvas.clientWidth * scale
  canvas.height = canvas.clientHeight * scale
  const context = canvas.getContext('2d')!
  context.scale(scale, scale)
  const palette = paletteOf(canvas)
  const { touches, islands } = inspect(world)
  ids.forEach((id, chip) => {
    const body = world.read(id)
    const { turn, expected } = turned(id)
    const pose = { ...body, angle: body.angle + turn }
    const island = islands.get(id) ?? 0
    drawChip(context, shapes[chip], pose, {
      fill: body.asleep ? asleepColour : chipColours[island % chipColours.length],
      stroke: palette.foreground,
      dash: body.asleep ? [3, 3] : [],
      label: words[chip],
    })
    if (body.asleep || expected === undefined) return
    const lying = { ...pose, angle: expected }
    drawChip(context, shapes[chip], lying, { stroke: palette.foreground, dash: expectedDash })
    drawMark(context, shapes[chip], lying, palette.foreground, expectedDash)
    drawMark(context, shapes[chip], pose, palette.foreground)
  })
  const pixels = weightLength / (meanMass(world) * Math.max(world.scene.pull, 1))
  for (const { x, y, forceX, forceY } of touches) {
    const scale = Math.min(pixels, longestForce / Math.hypot(forceX, forceY))
    drawLine(context, [x, y], [x + scale * forceX, y + scale * forceY], palette.alarm)
    drawDot(context, x, y, palette.alarm)
  }
}

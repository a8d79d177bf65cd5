import { chipColours, drawChip, drawDot, drawLine, paletteOf } from '../lab/draw'
import { inspect, meanMass } from '../lab/inspect'
import type { Pile } from '../lab/pile'

/** px, how long the weight of a mean chip is drawn, and the longest force. */
export const weightLength = 12
const longestForce = 80
const asleepColour = '#bab3ab'

/** Draws over the chips what the solver knows of them: who sleeps, who touches whom, and how hard. */
export function drawOverlay(canvas: HTMLCanvasElement, { world, ids, shapes }: Pile, words: string[]) {
  const scale = devicePixelRatio
  canvas.width = canvas.clientWidth * scale
  canvas.height = canvas.clientHeight * scale
  const context = canvas.getContext('2d')!
  context.scale(scale, scale)
  const palette = paletteOf(canvas)
  const { touches, islands } = inspect(world)
  ids.forEach((id, chip) => {
    const pose = world.read(id)
    const island = islands.get(id) ?? 0
    drawChip(context, shapes[chip], pose, {
      fill: pose.asleep ? asleepColour : chipColours[island % chipColours.length],
      stroke: palette.foreground,
      dash: pose.asleep ? [3, 3] : [],
      label: words[chip],
    })
  })
  const pixels = weightLength / (meanMass(world) * Math.max(world.scene.gravity, 1))
  for (const { x, y, forceX, forceY } of touches) {
    const scale = Math.min(pixels, longestForce / Math.hypot(forceX, forceY))
    drawLine(context, [x, y], [x + scale * forceX, y + scale * forceY], palette.alarm)
    drawDot(context, x, y, palette.alarm)
  }
}

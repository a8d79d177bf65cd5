import { cornerRadius, type Pose, type Shape } from '@/scenes/exact-distance'

/** Colours of the page, read from its tokens, and the chips' own. */
export type Palette = Record<'foreground' | 'muted' | 'border' | 'stage' | 'alarm', string>

export const chipColours = ['#f8775a', '#f4c647', '#63d8a3', '#62b4f5', '#c79ff5']
const ink = '#231d17'

export function paletteOf(element: HTMLElement): Palette {
  const style = getComputedStyle(element)
  const token = (name: string) => style.getPropertyValue(name).trim()
  return {
    foreground: token('--foreground'),
    muted: token('--muted-foreground'),
    border: token('--border'),
    stage: token('--stage'),
    alarm: style.colorScheme === 'dark' ? '#ff6b5e' : '#d5281b',
  }
}

/** 12 px on the screen, however wide the canvas is shown. */
function font(context: CanvasRenderingContext2D) {
  const { a, b } = context.getTransform()
  const family = getComputedStyle(context.canvas).fontFamily
  return `500 ${(12 * devicePixelRatio) / Math.hypot(a, b)}px ${family}`
}

type Look = { fill?: string; stroke?: string; dash?: number[]; label?: string; mark?: boolean }

/** A chip; `mark` draws a radius, so that the eye can see a disc turn. */
export function drawChip(context: CanvasRenderingContext2D, shape: Shape, pose: Pose, look: Look) {
  context.save()
  context.translate(pose.x, pose.y)
  context.rotate(pose.angle)
  context.beginPath()
  context.roundRect(-shape.width / 2, -shape.height / 2, shape.width, shape.height, cornerRadius(shape))
  if (look.fill) {
    context.fillStyle = look.fill
    context.fill()
  }
  if (look.stroke) {
    context.strokeStyle = look.stroke
    context.lineWidth = 1.5
    context.setLineDash(look.dash ?? [])
    context.stroke()
    context.setLineDash([])
  }
  if (look.mark) {
    context.beginPath()
    context.moveTo(0, 0)
    context.lineTo(shape.width / 2 - 3, 0)
    context.strokeStyle = ink
    context.lineWidth = 2
    context.stroke()
  }
  if (look.label) {
    context.fillStyle = ink
    context.font = font(context)
    context.textAlign = 'center'
    context.textBaseline = 'middle'
    context.fillText(look.label, 0, 1)
  }
  context.restore()
}

export function drawText(
  context: CanvasRenderingContext2D,
  text: string,
  x: number,
  y: number,
  colour: string,
  align: CanvasTextAlign = 'left',
  baseline: CanvasTextBaseline = 'alphabetic',
) {
  context.fillStyle = colour
  context.font = font(context)
  context.textAlign = align
  context.textBaseline = baseline
  context.fillText(text, x, y)
}

export function drawLine(
  context: CanvasRenderingContext2D,
  [x1, y1]: [number, number],
  [x2, y2]: [number, number],
  colour: string,
  dash: number[] = [],
) {
  context.beginPath()
  context.moveTo(x1, y1)
  context.lineTo(x2, y2)
  context.strokeStyle = colour
  context.lineWidth = 1.5
  context.setLineDash(dash)
  context.stroke()
  context.setLineDash([])
}

export function drawDot(context: CanvasRenderingContext2D, x: number, y: number, colour: string) {
  context.beginPath()
  context.arc(x, y, 2.5, 0, 2 * Math.PI)
  context.fillStyle = colour
  context.fill()
}

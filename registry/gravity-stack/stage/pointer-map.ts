/**
 * The map from the bounding box `box` of the stage to its own px. Three points tell what transforms of the
 * stage and of the elements around it do together.
 */
export function pointerMap(root: HTMLElement, box: DOMRect) {
  const probes = ['0,0', '100px,0', '0,100px'].map((offset) => {
    const probe = root.appendChild(root.ownerDocument.createElement('stage-point'))
    // A probe has a size and is moved by a transform: others would land in the next column of a page.
    probe.style.cssText = `position:absolute;left:0;top:0;margin:0;padding:.1px;transform:translate(${offset})`
    return probe
  })
  // All probes are written before any is read, for one layout.
  const [o, u, v] = probes.map((probe) => probe.getBoundingClientRect()) as [DOMRect, DOMRect, DOMRect]
  for (const probe of probes) probe.remove()
  return new DOMMatrix([u.x - o.x, u.y - o.y, v.x - o.x, v.y - o.y, o.x - box.x, o.y - box.y])
    .scale(0.01)
    .inverse()
}

/** Where a pointer is over a stage (px of the stage), and when (s). */
export interface Place {
  x: number
  y: number
  seconds: number
  /** The bounding box of the stage at that time, and the map from it to the stage's own px. */
  box: DOMRect
  toStage: DOMMatrix
}

/** The place of an event's pointer. The map of the place `before` serves while the box keeps its size. */
export function placeOf(
  { clientX, clientY, timeStamp }: PointerEvent,
  root: HTMLElement,
  before?: Place,
): Place {
  const box = root.getBoundingClientRect()
  // Scrolling moves the box alone. Elements around the stage may also be scaled, as on hover: then the box
  // has another size.
  const same = box.width === before?.box.width && box.height === before.box.height
  const toStage = same ? before.toStage : pointerMap(root, box)
  const { x, y } = toStage.transformPoint({ x: clientX - box.x, y: clientY - box.y })
  return { x, y, seconds: timeStamp / 1000, box, toStage }
}

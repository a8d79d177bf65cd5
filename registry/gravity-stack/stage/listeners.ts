/** Listens before handlers on the way to the target, which may keep the event to themselves. */
export const CAPTURE = { capture: true }

export type Listen = (
  target: EventTarget,
  type: string,
  handler: (event: never) => void,
  options?: object,
) => void

/** Returns a function that adds listeners; all of them end with `controller`. */
export function listenUntil({ signal }: AbortController): Listen {
  return (target, type, handler, options) =>
    target.addEventListener(type, handler as EventListener, { signal, ...options })
}

/** Keeps the browser, and handlers further on the way, from doing anything with an event. */
export function stop(event: Event) {
  event.preventDefault()
  event.stopPropagation()
}

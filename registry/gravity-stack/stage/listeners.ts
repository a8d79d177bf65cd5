export type Listen = (
  target: EventTarget,
  type: string,
  handler: (event: never) => void,
  options?: object,
) => void

/**
 * Returns a function that adds listeners; all of them end with `controller`. Unless `options` say otherwise a
 * listener hears an event before those on the way to its target, which may keep it to themselves.
 */
export function listenUntil({ signal }: AbortController): Listen {
  return (target, type, handler, options) =>
    target.addEventListener(type, handler as EventListener, { signal, capture: true, ...options })
}

/** Keeps the browser, and handlers further on the way, from doing anything with an event. */
export function stop(event: Event) {
  event.preventDefault()
  event.stopPropagation()
}

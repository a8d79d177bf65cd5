import { type DependencyList, useMemo } from 'react'

/** A value that is made when it is first asked for, and anew after `deps` have changed. */
export function useLazy<Value>(make: () => Value, deps: DependencyList): () => Value {
  return useMemo(() => {
    let made: { value: Value } | undefined
    return () => {
      made ??= { value: make() }
      return made.value
    }
    // biome-ignore lint/correctness/useExhaustiveDependencies: the caller names what `make` depends on
  }, deps)
}

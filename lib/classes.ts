/** Joins class names. The site's own parts have no conflicts to settle, so they need not bring `cn` to every page. */
export function classes(...names: (string | false | undefined)[]): string {
  return names.filter(Boolean).join(' ')
}

/** Joins class names. Classes of the site never conflict, so that its pages need not load `cn`. */
export function classes(...names: (string | false | undefined)[]): string {
  return names.filter(Boolean).join(' ')
}

/** The address of a page or file of this site. `path` is written as from the root of the host. */
export const at = (path: string) => `${process.env.BASE_PATH ?? ''}${path}`

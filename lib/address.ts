/** The address of a page or file of this site, which is named as if the site stood at the root of its host. */
export const at = (path: string) => `${process.env.BASE_PATH ?? ''}${path}`

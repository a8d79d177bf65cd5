/**
 * Sets words as a typesetter would: curly apostrophes, and no line break before a unit or at an equals sign.
 */
export const typeset = (words: string) =>
  words
    .replace(/(?<=\w)'/g, '’')
    .replace(/(?<=\d) (?=(?:px|rad|Hz|kB|MB|KB|ms|µs|s|%)(?![\w-]))/g, '\u00a0')
    .replace(/ = /g, '\u00a0=\u00a0')

type Node = { type: string; tagName?: string; value?: string; children?: Node[] }

/** Sets all words of a page but those in code. */
export function rehypeTypeset() {
  const visit = (node: Node) => {
    if (node.tagName === 'code' || node.tagName === 'pre') return
    if (node.type === 'text') node.value = typeset(node.value ?? '')
    node.children?.forEach(visit)
  }
  return visit
}

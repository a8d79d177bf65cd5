type Node = { tagName?: string; value?: string; properties?: object; children?: Node[] }

/** Names each table of a page after the heading above it: they all take the focus, and several stand on a page. */
export function rehypeTableNames() {
  const words = (node: Node): string => node.value ?? node.children?.map(words).join('') ?? ''
  return (page: Node) => {
    let heading = ''
    for (const node of page.children ?? []) {
      if (/^h\d$/.test(node.tagName ?? '')) heading = words(node)
      if (node.tagName === 'table' && heading) node.properties = { ...node.properties, ariaLabel: heading }
    }
  }
}

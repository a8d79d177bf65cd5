type Node = { tagName?: string; value?: string; properties?: object; children?: Node[] }

/** Names each table of a page after the heading above it, as tables take the focus and there are several. */
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

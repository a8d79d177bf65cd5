import registry from '@/registry.json'

type Block = {
  name: string
  title: string
  description: string
  /** px that it takes in a wide window and on a phone. */
  heights: { wide: number; narrow: number }
}

/** The blocks of the registry, in its order. */
export const blocks = registry.items
  .filter(({ type }) => type === 'registry:block')
  .map(({ name, title, description, meta }) => ({ name, title, description, heights: meta.heights }) as Block)

export const blocksPitch = {
  title: 'Blocks',
  lead: 'Parts of a page that you can ship as they are. Each is one file beside the component: take it with one command, and put your own words in.',
}

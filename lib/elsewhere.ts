import { siteUrl } from '@/site.config.mjs'

/** Opens an item of the registry in v0, from the variant that app/v0 makes for it. */
export const openInV0 = (name: string) =>
  `https://v0.app/chat/api/open?url=${encodeURIComponent(`${siteUrl}/v0/${name}.json`)}`

const question = (twin: string) =>
  encodeURIComponent(`Read ${siteUrl}${twin}, I want to ask questions about it.`)

/** Where a page can be talked about, by the Markdown at the address `twin`. */
export const assistants = (twin: string) => [
  { title: 'Open in ChatGPT', href: `https://chatgpt.com/?hints=search&q=${question(twin)}` },
  { title: 'Open in Claude', href: `https://claude.ai/new?q=${question(twin)}` },
]

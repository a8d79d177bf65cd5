/** What the index has an entry for. */
export const kinds = [
  'Page',
  'Section',
  'Prop',
  'Action',
  'Recipe',
  'Example',
  'Block',
  'Error message',
] as const

/** One thing that can be found: `page` is the title of the page it stands on, `text` what it says. */
export type Entry = { kind: (typeof kinds)[number]; title: string; page: string; href: string; text: string }

/** Lower case, apostrophes and hard spaces as a keyboard has them. */
const plain = (words: string) => words.toLowerCase().replaceAll('’', "'").replaceAll('\u00a0', ' ')

const wordsOf = (query: string) =>
  plain(query)
    .split(/[^\p{L}\p{N}@']+/u)
    .filter(Boolean)

/** Where `word` begins a word of `text`, or else where it stands inside one; -1 when it does neither. */
function placeOf(word: string, text: string): { at: number; begins: boolean } {
  for (let at = text.indexOf(word); at >= 0; at = text.indexOf(word, at + 1))
    if (!/[\p{L}\p{N}]/u.test(text[at - 1] ?? '')) return { at, begins: true }
  return { at: text.indexOf(word), begins: false }
}

/**
 * How many of the words an entry has, and how well. A title counts more than the text below it, the beginning
 * of a word more than its inside, and all words side by side more than the same words apart.
 */
function score({ kind, title, page, text }: Entry, words: string[]) {
  const phrase = words.join(' ')
  const [inTitle, inText] = [plain(title), plain(text)]
  // The title of the page and the kind tell one entry from another of the same name.
  const inRest = plain(`${page} ${kind}`)
  let had = 0
  let points = kind === 'Page' ? 2 : 0
  for (const word of words) {
    const [head, body] = [placeOf(word, inTitle), placeOf(word, inText)]
    const best = Math.max(
      head.begins ? 10 : head.at >= 0 ? 4 : 0,
      placeOf(word, inRest).begins ? 3 : 0,
      body.begins ? 2 : body.at >= 0 ? 1 : 0,
    )
    if (best > 0) had++
    points += best
  }
  if (inTitle === phrase) points += 30
  else if (placeOf(phrase, inTitle).begins) points += 12
  if (placeOf(phrase, inText).begins) points += 8
  return { had, points }
}

/** The entries that have every word of the query, or else as many as any entry has; the best first. */
export function search(entries: readonly Entry[], query: string): Entry[] {
  const words = wordsOf(query)
  const scored = entries.map((entry) => ({ entry, ...score(entry, words) }))
  const most = Math.max(1, ...scored.map(({ had }) => had))
  return scored
    .filter(({ had }) => had === most)
    .sort((a, b) => b.points - a.points)
    .map(({ entry }) => entry)
}

const excerptLength = 110

/** The part of a text that has the query's words, cut at spaces; its beginning when it has none of them. */
export function excerpt(text: string, query: string): string {
  const words = wordsOf(query)
  const [lower, phrase] = [plain(text), words.join(' ')]
  const places = [phrase, ...words].map((word) => (word ? placeOf(word, lower).at : -1))
  const found = places.find((at) => at >= 0) ?? 0
  const from = found < excerptLength * 0.7 ? 0 : text.indexOf(' ', found - 40) + 1
  const rest = text.slice(from)
  const cut = rest.length > excerptLength ? `${rest.slice(0, rest.lastIndexOf(' ', excerptLength))}…` : rest
  return from > 0 ? `…${cut}` : cut
}

/** A text in pieces, those that the query has marked. */
export function marked(text: string, query: string): { piece: string; hit: boolean }[] {
  const words = wordsOf(query).sort((a, b) => b.length - a.length)
  if (words.length === 0) return [{ piece: text, hit: false }]
  const any = words.map((word) => word.replaceAll("'", "['’]")).join('|')
  return text
    .split(new RegExp(`(?<![\\p{L}\\p{N}])(${any})`, 'iu'))
    .map((piece, index) => ({ piece, hit: index % 2 === 1 }))
    .filter(({ piece }) => piece !== '')
}

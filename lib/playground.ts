/** What the playground can be set to. Stands in the address, so that a pile can be passed on. */
export const shapes = ['pills', 'cards', 'boxes', 'discs', 'mixed'] as const
export const looks = ['tinted', 'neutral', 'ink'] as const

export const defaults = {
  words: 'Sketch, Wireframe, Prototype, User test, Copy, Motion, Handoff, Launch, Retro',
  count: 18,
  shape: 'pills' as (typeof shapes)[number],
  look: 'tinted' as (typeof looks)[number],
  gravity: 2600,
  bounce: 0.18,
  friction: 0.4,
  stagger: 150,
  interactive: true,
  seed: 0,
}

export type Settings = typeof defaults

export const ranges = {
  count: [1, 60, 1],
  gravity: [0, 8000, 100],
  bounce: [0, 1, 0.01],
  friction: [0, 1.5, 0.05],
  stagger: [0, 500, 10],
  seed: [0, 99, 1],
} satisfies Partial<Record<keyof Settings, [min: number, max: number, step: number]>>

export function toQuery(settings: Settings): string {
  const query = new URLSearchParams()
  for (const [key, value] of Object.entries(settings)) {
    if (value !== defaults[key as keyof Settings]) query.set(key, String(value))
  }
  return query.toString()
}

/** Reads an address that anyone may have written: what makes no sense is left at its default. */
export function fromQuery(text: string): Settings {
  const query = new URLSearchParams(text)
  const settings = { ...defaults }
  for (const [key, [min, max]] of Object.entries(ranges) as [keyof typeof ranges, number[]][]) {
    const value = Number(query.get(key) ?? Number.NaN)
    if (Number.isFinite(value)) settings[key] = Math.min(max, Math.max(min, value))
  }
  const words = query.get('words')
  if (words?.trim()) settings.words = words.slice(0, 500)
  settings.shape = shapes.find((shape) => shape === query.get('shape')) ?? defaults.shape
  settings.look = looks.find((look) => look === query.get('look')) ?? defaults.look
  settings.interactive = query.get('interactive') !== 'false'
  return settings
}

const shapeClasses = {
  pills: 'rounded-full px-4 py-2',
  cards: 'rounded-xl px-4 py-3',
  boxes: 'px-4 py-2',
  discs: 'grid size-20 place-items-center rounded-full text-xs',
}

const tints = [
  'bg-rose-300 text-rose-950',
  'bg-amber-300 text-amber-950',
  'bg-emerald-300 text-emerald-950',
  'bg-sky-300 text-sky-950',
  'bg-violet-300 text-violet-950',
]

const looksOf = {
  tinted: tints,
  neutral: ['bg-elevation-3 text-neutral-800 shadow-raised-3 dark:text-neutral-100'],
  ink: ['bg-neutral-900 text-white dark:bg-neutral-100 dark:text-neutral-900'],
}

const kinds = ['pills', 'cards', 'discs', 'boxes'] as const

/** The chips that the settings ask for; the words are repeated until there are enough. */
export function chipsOf({ words, count, shape, look }: Settings): { word: string; className: string }[] {
  const list = words
    .split(',')
    .map((word) => word.trim())
    .filter(Boolean)
  if (list.length === 0) list.push('chip')
  return Array.from({ length: count }, (_, index) => {
    const kind = shape === 'mixed' ? kinds[index % kinds.length] : shape
    const colours = looksOf[look]
    return {
      word: list[index % list.length],
      className: `${shapeClasses[kind]} text-sm font-medium ${colours[index % colours.length]}`,
    }
  })
}

/** The module that makes this pile, ready to be pasted. */
export function codeOf(settings: Settings): string {
  const chips = chipsOf(settings)
  const props = (['gravity', 'bounce', 'friction', 'stagger', 'interactive'] as const)
    .filter((prop) => settings[prop] !== defaults[prop])
    .map((prop) => ` ${prop}={${settings[prop]}}`)
  const rows = chips.map(({ word, className }) => `  [${JSON.stringify(word)}, '${className}'],`)
  return `import { GravityStack } from '@/components/ui/gravity-stack'

const chips = [
${rows.join('\n')}
]

export function Pile() {
  return (
    <GravityStack${props.join('')} className="h-96">
      {chips.map(([word, className], index) => (
        <span key={index} className={className}>
          {word}
        </span>
      ))}
    </GravityStack>
  )
}
`
}

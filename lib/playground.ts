/** What the playground can be set to. Stands in the address, so that settings can be passed on. */
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
  upright: true,
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
  for (const [key, [min, max, step]] of Object.entries(ranges) as [keyof typeof ranges, number[]][]) {
    const value = Number(query.get(key)?.trim() || Number.NaN)
    if (!Number.isFinite(value)) continue
    // To the steps of the slider: it could show nothing between them.
    const stepped = Number((Math.round(value / step) * step).toFixed(2))
    settings[key] = Math.min(max, Math.max(min, stepped))
  }
  settings.words = query.get('words')?.slice(0, 500) ?? defaults.words
  settings.shape = shapes.find((shape) => shape === query.get('shape')) ?? defaults.shape
  settings.look = looks.find((look) => look === query.get('look')) ?? defaults.look
  settings.interactive = query.get('interactive') !== 'false'
  settings.upright = query.get('upright') !== 'false'
  return settings
}

const shapeClasses = {
  pills: 'rounded-full px-4 py-2',
  cards: 'rounded-xl px-4 py-3',
  boxes: 'px-4 py-2',
  discs:
    'grid aspect-square min-w-20 max-w-40 place-items-center overflow-hidden rounded-full px-2 text-center wrap-anywhere',
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
  neutral: [
    'bg-elevation-3 text-neutral-800 shadow-raised-3 transition-shadow duration-300 dark:text-neutral-100',
  ],
  ink: ['bg-neutral-900 text-white dark:bg-neutral-100 dark:text-neutral-900'],
}

/** Stands before code that a project without these tokens would show without surfaces. */
export const elevationNote = '// The surfaces are tokens of the registry item "elevation".\n'

const kinds = ['pills', 'cards', 'discs', 'boxes'] as const

function listOf(words: string): string[] {
  const list = words
    .split(',')
    .map((word) => word.trim().replace(/\s+/g, ' '))
    .filter(Boolean)
  return list.length > 0 ? list : ['chip']
}

/** The class names that chips take in turn: of the shape, and of the colour. */
function classesOf({ shape, look }: Pick<Settings, 'shape' | 'look'>) {
  const forms = shape === 'mixed' ? kinds.map((kind) => shapeClasses[kind]) : [shapeClasses[shape]]
  return { forms, colours: looksOf[look] }
}

/** The chips that the settings ask for; the words are repeated until there are enough. */
export function chipsOf(settings: Pick<Settings, 'words' | 'count' | 'shape' | 'look'>) {
  const list = listOf(settings.words)
  const { forms, colours } = classesOf(settings)
  return Array.from({ length: settings.count }, (_, index) => ({
    word: list[index % list.length],
    className: `text-sm font-medium ${forms[index % forms.length]} ${colours[index % colours.length]}`,
  }))
}

const quoted = (text: string) => `'${text.replace(/[\\']/g, '\\$&')}'`

/** The module for these settings, ready to be pasted. It has no seed: the component has none. */
export function codeOf(settings: Settings): string {
  const list = listOf(settings.words)
  const { forms, colours } = classesOf(settings)
  const props = (['gravity', 'bounce', 'friction', 'stagger', 'interactive', 'upright'] as const)
    .filter((prop) => settings[prop] !== defaults[prop])
    .map((prop) => ` ${prop}={${settings[prop]}}`)

  const lists = { words: list, ...(forms.length > 1 && { forms }), ...(colours.length > 1 && { colours }) }
  const declarations = Object.entries(lists).map(([name, items]) =>
    name === 'words'
      ? `const words = [${items.map(quoted).join(', ')}]`
      : `const ${name} = [\n${items.map((item) => `  ${quoted(item)},`).join('\n')}\n]`,
  )
  const one = (name: string, items: string[]) =>
    items.length > 1 ? `\${${name}[index % ${name}.length]}` : items[0]
  const className = `text-sm font-medium ${one('forms', forms)} ${one('colours', colours)}`
  const attribute = className.includes('${') ? `{\`${className}\`}` : `"${className}"`

  return `${settings.look === 'neutral' ? elevationNote : ''}import { GravityStack } from '@/components/ui/gravity-stack'

${declarations.join('\n\n')}

export function Pile() {
  return (
    <GravityStack${props.join('')} className="h-96">
      {Array.from({ length: ${settings.count} }, (_, index) => (
        <span
          key={index}
          className=${attribute}
        >
          {words[index % words.length]}
        </span>
      ))}
    </GravityStack>
  )
}
`
}

/** What the playground can be set to. Stands in the address, so that settings can be passed on. */
export const shapes = ['pills', 'cards', 'boxes', 'discs', 'mixed'] as const
export const looks = ['tinted', 'neutral', 'ink'] as const

export const defaults = {
  words: 'Sketch, Wireframe, Prototype, User test, Copy, Motion, Handoff, Launch, Retro',
  count: 18,
  shape: 'pills' as (typeof shapes)[number],
  look: 'tinted' as (typeof looks)[number],
  gravity: 2600,
  /** Degrees from straight down, positive to the right: where gravity points. */
  direction: 0,
  ceiling: false,
  push: 0,
  bounce: 0.18,
  friction: 0.4,
  stagger: 150,
  interactive: true,
  upright: true,
  seed: 0,
  /** Whether there is an obstacle, and where its centre is, in percent of the stage. */
  obstacle: false,
  obstacleX: 50,
  obstacleY: 60,
}

export type Settings = typeof defaults

export const ranges = {
  count: [1, 60, 1],
  gravity: [0, 8000, 100],
  direction: [-175, 180, 5],
  push: [0, 120, 2],
  bounce: [0, 1, 0.01],
  friction: [0, 1.5, 0.05],
  stagger: [0, 500, 10],
  seed: [0, 99, 1],
  obstacleX: [0, 100, 0.25],
  // At the top it would cover the way in.
  obstacleY: [10, 95, 0.25],
} satisfies Partial<Record<keyof Settings, [min: number, max: number, step: number]>>

export function toQuery(settings: Settings): string {
  const query = new URLSearchParams()
  for (const [key, value] of Object.entries(settings)) {
    if (value !== defaults[key as keyof Settings]) query.set(key, String(value))
  }
  return query.toString()
}

/** A number as a slider can show it: in its range, and on one of its steps. */
export function onSlider(key: keyof typeof ranges, value: number) {
  const [min, max, step] = ranges[key]
  const stepped = Number((Math.round(value / step) * step).toFixed(2))
  return Math.min(max, Math.max(min, stepped))
}

/** px/s², gravity to the right and downwards, as the component takes it. */
export function gravityOf({ gravity, direction }: Pick<Settings, 'gravity' | 'direction'>) {
  const angle = (direction * Math.PI) / 180
  // Whole numbers, and no -0.
  return { x: Math.round(gravity * Math.sin(angle)) + 0, y: Math.round(gravity * Math.cos(angle)) + 0 }
}

/** Gravity that points up closes the top of the stage by itself. */
export const isClosed = (settings: Pick<Settings, 'gravity' | 'direction' | 'ceiling'>) =>
  settings.ceiling || gravityOf(settings).y < 0

/** Reads an address that anyone may have written: what makes no sense is left at its default. */
export function fromQuery(text: string): Settings {
  const query = new URLSearchParams(text)
  const settings = { ...defaults }
  for (const key of Object.keys(ranges) as (keyof typeof ranges)[]) {
    const value = Number(query.get(key)?.trim() || Number.NaN)
    if (Number.isFinite(value)) settings[key] = onSlider(key, value)
  }
  settings.words = query.get('words')?.slice(0, 500) ?? defaults.words
  settings.shape = shapes.find((shape) => shape === query.get('shape')) ?? defaults.shape
  settings.look = looks.find((look) => look === query.get('look')) ?? defaults.look
  settings.interactive = query.get('interactive') !== 'false'
  settings.upright = query.get('upright') !== 'false'
  settings.ceiling = query.get('ceiling') === 'true'
  settings.obstacle = query.get('obstacle') === 'true'
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

/** How an obstacle looks, but for its place. */
export const obstacleClass = 'h-6 w-36 -translate-x-1/2 -translate-y-1/2 rounded-full bg-neutral-500'

const quoted = (text: string) => `'${text.replace(/[\\']/g, '\\$&')}'`

/** The module for these settings, ready to be pasted. It has no seed: the component has none. */
export function codeOf(settings: Settings): string {
  const list = listOf(settings.words)
  const { forms, colours } = classesOf(settings)
  const { x, y } = gravityOf(settings)
  const given = {
    gravity: x === 0 && y >= 0 ? y : `{ x: ${x}, y: ${y} }`,
    ceiling: isClosed(settings),
    push: settings.push,
    bounce: settings.bounce,
    friction: settings.friction,
    stagger: settings.stagger,
    interactive: settings.interactive,
    upright: settings.upright,
  }
  const props = Object.entries(given)
    .filter(([prop, value]) => value !== defaults[prop as keyof typeof given])
    .map(([prop, value]) => (value === true ? ` ${prop}` : ` ${prop}={${value}}`))
  const obstacle = settings.obstacle
    ? `      <div data-static className="absolute top-[${settings.obstacleY}%] left-[${settings.obstacleX}%] ${obstacleClass}" />\n`
    : ''

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
${obstacle}      {Array.from({ length: ${settings.count} }, (_, index) => (
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

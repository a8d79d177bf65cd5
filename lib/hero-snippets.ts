import { elevationNote } from './playground'
import { tints } from './tints'

/** What the buttons of the home page do, as the code that does it. */
export const heroEffects = ['drop', 'shake', 'tinted', 'neutral', 'heavier', 'bouncier'] as const

export type HeroEffect = (typeof heroEffects)[number]

const withActions = (call: string, label: string) => `const stack = useRef<GravityStackActions>(null)

<GravityStack actionsRef={stack} className="h-96">{chips}</GravityStack>
<button type="button" onClick={() => stack.current?.${call}()}>${label}</button>`

const tinted = `const tints = [${tints.map((tint) => `'${tint}'`).join(', ')}]

<GravityStack className="h-96">
  {words.map((word, index) => (
    <span key={word} className={\`rounded-full px-5 py-2 text-stone-900 \${tints[index % tints.length]}\`}>{word}</span>
  ))}
</GravityStack>`

const neutral = `${elevationNote}<GravityStack className="h-96">
  {words.map((word) => (
    <span key={word} className="rounded-full bg-elevation-3 px-5 py-2 shadow-raised-3">{word}</span>
  ))}
</GravityStack>`

const withProp = (prop: string) => `<GravityStack ${prop} className="h-96">
  {chips}
</GravityStack>`

export const heroSnippets: Record<HeroEffect, string> = {
  drop: withActions('drop', 'Drop again'),
  shake: withActions('shake', 'Shake'),
  tinted,
  neutral,
  heavier: withProp('gravity={6000}'),
  bouncier: withProp('bounce={0.7}'),
}

import { elevationNote } from './playground'
import { tints } from './tints'

/** What the buttons of the home page do: an action is done once, the rest stays set. */
export const heroActions = { drop: 'Drop again', shake: 'Shake' } as const
export type HeroAction = keyof typeof heroActions
type HeroSettings = { neutral: boolean; heavier: boolean; bouncier: boolean }

const quote = (text: string) => `'${text}'`

/** The code of the stage on the home page: all that is set, and the button of the action that was done last. */
export function heroCode({ neutral, heavier, bouncier }: HeroSettings, action?: HeroAction): string {
  const imports = action
    ? `import { useRef } from 'react'\nimport { GravityStack, type GravityStackActions } from '@/components/ui/gravity-stack'`
    : `import { GravityStack } from '@/components/ui/gravity-stack'`
  const declared = [
    ...(neutral ? [] : [`const tints = [${tints.map(quote).join(', ')}]`]),
    ...(action ? ['const actions = useRef<GravityStackActions>(null)'] : []),
  ]
  const props = [
    ...(action ? ['actionsRef={actions}'] : []),
    ...(heavier ? ['gravity={6000}'] : []),
    ...(bouncier ? ['bounce={0.7}'] : []),
    'className="h-96"',
  ]
  const look = neutral
    ? '"rounded-full bg-elevation-3 px-5 py-2 shadow-raised-3"'
    : // biome-ignore lint/suspicious/noTemplateCurlyInString: code in a string
      '{`rounded-full px-5 py-2 text-stone-900 ${tints[index % tints.length]}`}'
  const button = action
    ? `\n<button type="button" onClick={() => actions.current?.${action}()}>${heroActions[action]}</button>`
    : ''
  return `${neutral ? elevationNote : ''}${[imports, declared.join('\n')].filter(Boolean).join('\n\n')}

<GravityStack ${props.join(' ')}>
  {words.map((${neutral ? 'word' : 'word, index'}) => (
    <span key={word} className=${look}>{word}</span>
  ))}
</GravityStack>${button}`
}

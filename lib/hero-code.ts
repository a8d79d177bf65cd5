import { elevationNote } from './playground'
import { tints } from './tints'

/** What the buttons of the home page do: an action is done once, the rest stays set. */
export const heroActions = { drop: 'Drop again', shake: 'Shake', pause: 'Pause', resume: 'Resume' } as const
export type HeroAction = keyof typeof heroActions

/** What “Heavier” and “Bouncier” set. */
export const extremes = { gravity: 6000, bounce: 0.7 }

type HeroSettings = { neutral: boolean; heavier: boolean; bouncier: boolean }

const words = ['rigid bodies', 'one file', 'grab me', 'toss me']

const listOf = (name: string, items: string[]) =>
  `const ${name} = [${items.map((item) => `'${item}'`).join(', ')}]`

const indented = (code: string) => code.replace(/^(?=.)/gm, '  ')

/** A module for the stage on the home page: its settings, and the button of the action that was last used. */
export function heroCode({ neutral, heavier, bouncier }: HeroSettings, action?: HeroAction): string {
  const imports = action
    ? `'use client'

import { useRef } from 'react'
import { GravityStack, type GravityStackActions } from '@/components/ui/gravity-stack'`
    : `import { GravityStack } from '@/components/ui/gravity-stack'`
  const lists = [listOf('words', words), ...(neutral ? [] : [listOf('tints', tints)])]
  const props = [
    ...(action ? ['actionsRef={actions}'] : []),
    ...(heavier ? [`gravity={${extremes.gravity}}`] : []),
    ...(bouncier ? [`bounce={${extremes.bounce}}`] : []),
    'className="h-96"',
  ]
  const look = neutral
    ? '"rounded-full bg-elevation-3 px-5 py-2 shadow-raised-3"'
    : // biome-ignore lint/suspicious/noTemplateCurlyInString: code in a string
      '{`rounded-full px-5 py-2 text-stone-900 ${tints[index % tints.length]}`}'
  const stage = `<GravityStack ${props.join(' ')}>
  {words.map((${neutral ? 'word' : 'word, index'}) => (
    <span key={word} className=${look}>
      {word}
    </span>
  ))}
</GravityStack>`
  const all = action
    ? `<>
${indented(stage)}
  <button type="button" onClick={() => actions.current?.${action}()}>
    ${heroActions[action]}
  </button>
</>`
    : stage
  return `${neutral ? elevationNote : ''}${imports}

${lists.join('\n')}

export function Pile() {
${action ? '  const actions = useRef<GravityStackActions>(null)\n' : ''}  return (
${indented(indented(all))}
  )
}
`
}

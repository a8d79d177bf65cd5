import { GravityStack } from '@/components/ui/gravity-stack'

const tints = {
  rose: 'bg-rose-200 text-rose-950 dark:bg-rose-400',
  amber: 'bg-amber-200 text-amber-950 dark:bg-amber-400',
  lime: 'bg-lime-200 text-lime-950 dark:bg-lime-400',
  sky: 'bg-sky-200 text-sky-950 dark:bg-sky-400',
  violet: 'bg-violet-200 text-violet-950 dark:bg-violet-400',
}

const chips: [word: string, tint: keyof typeof tints][] = [
  ['Strawberry', 'rose'],
  ['Lemon', 'amber'],
  ['Lime', 'lime'],
  ['Blueberry', 'sky'],
  ['Fig', 'violet'],
  ['Grapefruit', 'rose'],
  ['Mango', 'amber'],
  ['Pear', 'lime'],
  ['Sea salt', 'sky'],
  ['Plum', 'violet'],
  ['Apricot', 'amber'],
  ['Kiwi', 'lime'],
]

export function GravityStackTintedDemo() {
  return (
    <GravityStack className="h-80">
      {chips.map(([word, tint]) => (
        <span key={word} className={`rounded-full px-4 py-2 font-medium text-sm ${tints[tint]}`}>
          {word}
        </span>
      ))}
    </GravityStack>
  )
}

'use client'

import { cn } from 'cn'
import { GravityStack } from './ui/gravity-stack'

const colours = {
  tomato: 'bg-[oklch(0.72_0.18_32)]',
  saffron: 'bg-[oklch(0.85_0.16_88)]',
  mint: 'bg-[oklch(0.83_0.15_158)]',
  azure: 'bg-[oklch(0.76_0.13_240)]',
  lilac: 'bg-[oklch(0.78_0.13_305)]',
  ink: 'bg-foreground text-background',
}

const pill = 'rounded-full px-5 py-2.5'
const card = 'rounded-xl px-4 py-2.5'

const chips: [words: string, colour: keyof typeof colours, shape: string][] = [
  ['rigid bodies', 'tomato', pill],
  ['one file', 'ink', card],
  ['no physics library', 'saffron', pill],
  ['grab me', 'azure', pill],
  ['real friction', 'mint', card],
  ['exact flight', 'lilac', pill],
  ['toss me', 'tomato', card],
  ['sleeps at rest', 'azure', pill],
  ['React', 'saffron', card],
  ['Tailwind', 'mint', pill],
  ['reduced motion', 'ink', pill],
  ['copy, paste, own', 'lilac', card],
  ['any shape', 'saffron', pill],
  ['MIT', 'tomato', pill],
  ['built with Motion', 'azure', card],
  ['shadcn registry', 'mint', pill],
]

export function HeroStage() {
  return (
    <GravityStack className="absolute inset-0 h-full">
      {chips.map(([words, colour, shape]) => (
        <span
          key={words}
          className={cn(
            'font-medium text-[oklch(0.2_0.03_60)] text-sm shadow-[inset_0_1px_0_rgb(255_255_255/0.45),inset_0_-1.5px_0_rgb(0_0_0/0.12),0_1px_2px_rgb(0_0_0/0.12)] sm:text-lg',
            shape,
            colours[colour],
          )}
        >
          {words}
        </span>
      ))}
    </GravityStack>
  )
}

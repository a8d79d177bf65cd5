'use client'

import { type ReactNode, useRef, useState } from 'react'
import { classes } from '@/lib/classes'
import type { HeroEffect } from '@/lib/hero-snippets'
import { CopyButton } from './copy-button'
import { GravityStack, type GravityStackActions } from './ui/gravity-stack'

const tints = {
  tomato: 'bg-[oklch(0.72_0.18_32)]',
  saffron: 'bg-[oklch(0.85_0.16_88)]',
  mint: 'bg-[oklch(0.83_0.15_158)]',
  azure: 'bg-[oklch(0.76_0.13_240)]',
  lilac: 'bg-[oklch(0.78_0.13_305)]',
}
const tinted =
  'text-[oklch(0.2_0.03_60)] shadow-[inset_0_1px_0_rgb(255_255_255/0.45),inset_0_-1.5px_0_rgb(0_0_0/0.12),0_1px_2px_rgb(0_0_0/0.15)]'

const pill = 'rounded-full px-4 py-2 sm:px-6 sm:py-3'
const card = 'rounded-xl px-3.5 py-2 sm:px-5 sm:py-3.5'

const chips: [words: string, tint: keyof typeof tints, shape: string][] = [
  ['rigid bodies', 'tomato', pill],
  ['one file', 'saffron', card],
  ['no physics library', 'azure', pill],
  ['grab me', 'mint', pill],
  ['real friction', 'lilac', card],
  ['exact flight', 'saffron', pill],
  ['toss me', 'tomato', card],
  ['asleep at rest', 'azure', pill],
  ['any shape', 'mint', card],
  ['reduced motion', 'lilac', pill],
  ['copy, paste, own', 'saffron', card],
  ['same drop every time', 'mint', pill],
  ['your classes', 'tomato', pill],
  ['reads in order', 'azure', card],
]

const effects: { effect: HeroEffect; label: string }[] = [
  { effect: 'drop', label: 'Drop again' },
  { effect: 'shake', label: 'Shake' },
  { effect: 'tinted', label: 'Tinted' },
  { effect: 'neutral', label: 'Neutral' },
  { effect: 'heavier', label: 'Heavier' },
  { effect: 'bouncier', label: 'Bouncier' },
]

/** The component as its own pitch: `children` stand before the pile, `snippets` say what each button does. */
export function Hero({
  snippets,
  children,
}: {
  snippets: Record<HeroEffect, ReactNode>
  children: ReactNode
}) {
  const actions = useRef<GravityStackActions>(null)
  const [effect, setEffect] = useState<HeroEffect>('drop')
  const [neutral, setNeutral] = useState(false)

  function perform(next: HeroEffect) {
    setEffect(next)
    if (next === 'tinted' || next === 'neutral') return setNeutral(next === 'neutral')
    if (next === 'shake') return actions.current?.shake()
    // The new gravity or bounce reaches the stage with the next render.
    requestAnimationFrame(() => actions.current?.drop())
  }

  return (
    <div className="overflow-hidden rounded-3xl border bg-panel">
      <section className="relative isolate bg-stage">
        {children}
        {/* In front of the words: a chip that falls past covers them for a moment, and never stands behind them. */}
        <GravityStack
          actionsRef={actions}
          gravity={effect === 'heavier' ? 6000 : undefined}
          bounce={effect === 'bouncier' ? 0.7 : undefined}
          stagger={90}
          className="pointer-events-none absolute inset-0 h-full *:pointer-events-auto"
        >
          {chips.map(([words, tint, shape]) => (
            <span
              key={words}
              className={classes(
                'font-medium text-sm transition-[background-color,box-shadow,color] duration-300 sm:text-xl',
                shape,
                neutral ? 'bg-elevation-3 text-foreground shadow-raised-3' : `${tinted} ${tints[tint]}`,
              )}
            >
              {words}
            </span>
          ))}
        </GravityStack>
      </section>

      <div className="code border-t">
        <div data-print="hide" className="flex flex-wrap items-center gap-1.5 border-b p-2 sm:px-3">
          {effects.map(({ effect: name, label }) => (
            <button
              key={name}
              type="button"
              aria-pressed={effect === name}
              onClick={() => perform(name)}
              className="rounded-full px-3.5 py-1.5 text-muted-foreground text-sm transition-colors hover:bg-muted hover:text-foreground aria-pressed:bg-foreground aria-pressed:text-background"
            >
              {label}
            </button>
          ))}
          <CopyButton className="ml-auto" />
        </div>
        <div className="grid grid-cols-[minmax(0,1fr)] *:col-start-1 *:row-start-1">
          {effects.map(({ effect: name }) => (
            <div key={name} inert={effect !== name} className={classes(effect !== name && 'invisible')}>
              {snippets[name]}
            </div>
          ))}
        </div>
      </div>
    </div>
  )
}

'use client'

import { type ReactNode, useRef, useState } from 'react'
import { classes } from '@/lib/classes'
import type { HeroEffect } from '@/lib/hero-snippets'
import { tints } from '@/lib/tints'
import { CopyButton } from './copy-button'
import { GravityStack, type GravityStackActions } from './ui/gravity-stack'

// Larger where a pile of large chips stays clear of the words above it.
const pill = 'rounded-full px-4 py-2 lg:px-5 lg:py-2.5'
const card = 'rounded-xl px-3.5 py-2 lg:px-4.5 lg:py-3'

const chips: [words: string, shape: string][] = [
  ['rigid bodies', pill],
  ['one file', card],
  ['no physics library', pill],
  ['grab me', pill],
  ['real friction', card],
  ['exact flight', pill],
  ['toss me', card],
  ['asleep at rest', pill],
  ['pills and boxes', card],
  ['reduced motion', pill],
  ['copy, paste, own', card],
  ['same drop every time', pill],
  ['your classes', pill],
  ['reads in order', card],
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
  const [shown, setShown] = useState<HeroEffect>('drop')
  const [neutral, setNeutral] = useState(false)
  const [heavier, setHeavier] = useState(false)
  const [bouncier, setBouncier] = useState(false)

  // The new gravity or bounce reaches the stage with the next render.
  const drop = () => requestAnimationFrame(() => actions.current?.drop())

  // What has a `pressed` is a setting that stays; the others act once.
  const effects: { effect: HeroEffect; label: string; pressed?: boolean; perform: () => void }[] = [
    { effect: 'drop', label: 'Drop again', perform: drop },
    { effect: 'shake', label: 'Shake', perform: () => actions.current?.shake() },
    { effect: 'tinted', label: 'Tinted', pressed: !neutral, perform: () => setNeutral(false) },
    { effect: 'neutral', label: 'Neutral', pressed: neutral, perform: () => setNeutral(true) },
    {
      effect: 'heavier',
      label: 'Heavier',
      pressed: heavier,
      perform() {
        setHeavier(!heavier)
        drop()
      },
    },
    {
      effect: 'bouncier',
      label: 'Bouncier',
      pressed: bouncier,
      perform() {
        setBouncier(!bouncier)
        drop()
      },
    },
  ]

  return (
    <div className="overflow-hidden rounded-3xl border bg-panel">
      <section className="relative isolate bg-stage">
        {children}
        {/* In front of the words: a chip that falls past covers them for a moment, and never stands behind them. */}
        <GravityStack
          actionsRef={actions}
          gravity={heavier ? 6000 : undefined}
          bounce={bouncier ? 0.7 : undefined}
          stagger={90}
          className="pointer-events-none absolute inset-0 h-full *:pointer-events-auto"
        >
          {chips.map(([words, shape], index) => (
            <span
              key={words}
              className={classes(
                'font-medium text-sm transition-[background-color,box-shadow,color] duration-300 lg:text-lg',
                shape,
                neutral ? 'bg-elevation-3 shadow-raised-3' : `text-stone-900 ${tints[index % tints.length]}`,
              )}
            >
              {words}
            </span>
          ))}
        </GravityStack>
      </section>

      <div className="code border-t">
        <div data-print="hide" className="flex flex-wrap items-center gap-1.5 border-b p-2 sm:px-3">
          {effects.map(({ effect, label, pressed, perform }) => (
            <button
              key={effect}
              type="button"
              aria-pressed={pressed}
              onClick={() => {
                // A setting that is taken back leaves a drop with the usual ones.
                setShown((effect === 'heavier' || effect === 'bouncier') && pressed ? 'drop' : effect)
                perform()
              }}
              className="rounded-full px-3.5 py-1.5 text-muted-foreground text-sm transition-colors hover:bg-muted hover:text-foreground aria-pressed:bg-foreground aria-pressed:text-background"
            >
              {label}
            </button>
          ))}
          <CopyButton className="ml-auto" />
        </div>
        <div className="grid grid-cols-[minmax(0,1fr)] *:col-start-1 *:row-start-1">
          {effects.map(({ effect }) => (
            <div key={effect} inert={effect !== shown} className={classes(effect !== shown && 'invisible')}>
              {snippets[effect]}
            </div>
          ))}
        </div>
      </div>
    </div>
  )
}

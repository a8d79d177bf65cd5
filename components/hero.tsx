'use client'

import { type ReactNode, useRef, useState } from 'react'
import { classes } from '@/lib/classes'
import { extremes, type HeroAction, heroActions, heroCode } from '@/lib/hero-code'
import { tints } from '@/lib/tints'
import { CopyButton } from './copy-button'
import { LiveCode } from './live-code'
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

const button =
  'rounded-full border px-3.5 py-1.5 text-muted-foreground text-sm transition-colors hover:bg-muted hover:text-foreground'

/**
 * The component as its own pitch. `children` stand in front of the pile; below it is the code of its
 * settings.
 */
export function Hero({ children }: { children: ReactNode }) {
  const actions = useRef<GravityStackActions>(null)
  const [action, setAction] = useState<HeroAction>()
  const [paused, setPaused] = useState(false)
  const [neutral, setNeutral] = useState(false)
  const [heavier, setHeavier] = useState(false)
  const [bouncier, setBouncier] = useState(false)

  function perform(action: HeroAction) {
    // In a paused stage it would be seen only later.
    if (action === 'shake') actions.current?.resume()
    actions.current?.[action]()
    setPaused(action === 'pause')
  }

  const settings: { label: string; pressed: boolean; set: () => void }[] = [
    { label: 'Tinted', pressed: !neutral, set: () => setNeutral(false) },
    { label: 'Neutral', pressed: neutral, set: () => setNeutral(true) },
    {
      label: 'Heavier',
      pressed: heavier,
      set() {
        setHeavier(!heavier)
        perform('drop')
      },
    },
    {
      label: 'Bouncier',
      pressed: bouncier,
      set() {
        setBouncier(!bouncier)
        perform('drop')
      },
    },
  ]

  return (
    <div className="overflow-hidden rounded-3xl border bg-panel">
      <section className="relative isolate bg-stage">
        {children}
        {/* Chips are in front of the words: one that falls past covers them for a moment. */}
        <GravityStack
          actionsRef={actions}
          gravity={heavier ? extremes.gravity : undefined}
          bounce={bouncier ? extremes.bounce : undefined}
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
        <div
          data-print="hide"
          className="relative flex flex-wrap items-center gap-1.5 border-b p-2 max-sm:*:px-3 sm:px-3 [@media(scripting:none)]:hidden"
        >
          {(['drop', 'shake', paused ? 'resume' : 'pause'] as const).map((name, place) => (
            <button
              // biome-ignore lint/suspicious/noArrayIndexKey: pause and resume are one button
              key={place}
              type="button"
              onClick={() => {
                setAction(name)
                perform(name)
              }}
              className={button}
            >
              {heroActions[name]}
            </button>
          ))}
          {/* On a phone the row breaks here. */}
          <span aria-hidden="true" className="max-sm:basis-full sm:mx-1.5 sm:h-5 sm:border-l" />
          {settings.map(({ label, pressed, set }) => (
            <button
              key={label}
              type="button"
              aria-pressed={pressed}
              onClick={set}
              className={classes(
                button,
                'border-transparent aria-pressed:bg-foreground aria-pressed:text-background',
              )}
            >
              {label}
            </button>
          ))}
          <span className="hidden px-2 text-muted-foreground text-sm motion-reduce:inline">
            Motion is off, as your system asks.
          </span>
          <CopyButton className="top-2 right-2 ml-auto min-[22rem]:max-sm:absolute" />
        </div>
        <LiveCode code={heroCode({ neutral, heavier, bouncier }, action)} />
      </div>
    </div>
  )
}

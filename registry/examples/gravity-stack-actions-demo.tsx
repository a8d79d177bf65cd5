'use client'

import { useRef, useState } from 'react'
import { GravityStack, type GravityStackActions } from '@/components/ui/gravity-stack'

const words = [
  'apples',
  'pears',
  'quinces',
  'medlars',
  'plums',
  'damsons',
  'cherries',
  'sloes',
  'figs',
  'grapes',
]

/** `actionsRef` hands you `drop`, `shake`, `pause` and `resume`; `onSettle` says when all lie still. */
export function GravityStackActionsDemo() {
  const actions = useRef<GravityStackActions>(null)
  const [settled, setSettled] = useState(0)
  const button =
    'rounded-md border border-neutral-400 px-3 py-1.5 text-sm hover:bg-neutral-500/10 dark:border-neutral-600'

  return (
    <div className="flex flex-col">
      <div className="flex flex-wrap items-center gap-2 p-4">
        <button type="button" className={button} onClick={() => actions.current?.drop()}>
          Drop
        </button>
        <button type="button" className={button} onClick={() => actions.current?.shake()}>
          Shake
        </button>
        <button type="button" className={button} onClick={() => actions.current?.pause()}>
          Pause
        </button>
        <button type="button" className={button} onClick={() => actions.current?.resume()}>
          Resume
        </button>
        <span className="hidden text-sm motion-reduce:inline">Motion is off, as your system asks.</span>
        <span className="ml-auto text-sm tabular-nums">settled {settled}×</span>
      </div>
      <GravityStack className="h-64" actionsRef={actions} onSettle={() => setSettled((count) => count + 1)}>
        {words.map((word) => (
          <span
            key={word}
            className="rounded-full bg-emerald-300 px-4 py-2 font-medium text-emerald-950 text-sm"
          >
            {word}
          </span>
        ))}
      </GravityStack>
    </div>
  )
}

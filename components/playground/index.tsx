'use client'

import { useEffect, useMemo, useState } from 'react'
import { classes } from '@/lib/classes'
import { toFragment } from '@/lib/pile-link'
import { chipsOf, codeOf, defaults, obstacleClass, toQuery } from '@/lib/playground'
import { stillMotion } from '@/lib/still-motion'
import { CopyButton } from '../copy-button'
import { LiveCode } from '../live-code'
import { Fields } from './fields'
import { Obstacle } from './obstacle'
import { weightLength } from './overlay'
import { useLinkedPile } from './use-linked-pile'
import { idle, type Outcome, usePile, type Work } from './use-pile'
import { useSettings } from './use-settings'

const speeds = [
  { value: 1, label: '1×' },
  { value: 0.25, label: '1/4×' },
  { value: 0.05, label: '1/20×' },
]

export function Playground({ version }: { version: string }) {
  const [settings, set] = useSettings()
  const { linked, leave } = useLinkedPile()
  const [drop, setDrop] = useState(0)
  const [playing, setPlaying] = useState(true)
  const [speed, setSpeed] = useState(1)
  const [overlay, setOverlay] = useState(false)
  useEffect(() => {
    if (stillMotion()) setPlaying(false)
  }, [])

  const ready = settings !== undefined && linked !== 'unread'
  const replay = typeof linked === 'object' ? linked : undefined
  const now = settings ?? defaults
  const { words, shape, look, interactive } = now
  const count = replay?.shapes.length ?? now.count
  const chips = useMemo(
    () => (ready ? chipsOf({ words, count, shape, look }) : []),
    [ready, words, count, shape, look],
  )
  const { stage, canvas, hands, hover, work, outcome, record, advance } = usePile({
    chips,
    settings: now,
    drop,
    replay,
    version,
    playing,
    speed,
    overlay,
  })

  /** Who changes a setting wants a pile of their own. */
  function change(next: Partial<typeof now>) {
    leave()
    set(next)
  }

  async function link() {
    const made = record()
    if (!made) throw new Error('too long for an address')
    const url = new URL(location.href)
    url.search = toQuery(now)
    url.hash = await toFragment(made)
    return url.href
  }

  const hint = 'absolute inset-0 grid place-items-center p-6 text-center text-muted-foreground text-sm'
  const button =
    'rounded-md border px-3 py-1.5 text-sm transition-colors hover:bg-muted aria-pressed:border-foreground aria-pressed:bg-foreground aria-pressed:text-background'

  return (
    <div className="mt-8 grid grid-cols-[minmax(0,1fr)] gap-6 lg:grid-cols-[minmax(0,1fr)_19rem] lg:grid-rows-[auto_1fr]">
      <div data-print="hide" className="min-w-0 self-start overflow-hidden rounded-2xl border bg-panel">
        <div className="flex flex-wrap items-center gap-2 border-b p-3 [@media(scripting:none)]:hidden">
          <button
            type="button"
            className={button}
            onClick={() => {
              leave()
              setPlaying(true)
              setDrop(drop + 1)
            }}
          >
            Drop
          </button>
          <button type="button" className={button} onClick={() => setPlaying(!playing)}>
            {playing ? 'Pause' : 'Play'}
          </button>
          <button
            type="button"
            className={button}
            onClick={() => {
              setPlaying(false)
              advance()
            }}
          >
            Step
          </button>
          <fieldset className="flex flex-wrap items-center gap-2 sm:ml-auto">
            <legend className="sr-only">Speed</legend>
            {speeds.map(({ value, label }) => (
              <button
                key={value}
                type="button"
                className={button}
                aria-label={`Speed ${label}`}
                aria-pressed={speed === value}
                onClick={() => setSpeed(value)}
              >
                {label}
              </button>
            ))}
          </fieldset>
          <button
            type="button"
            className={button}
            aria-pressed={overlay}
            onClick={() => setOverlay(!overlay)}
          >
            Overlay
          </button>
          <CopyButton text={link} className="border">
            Copy this pile
          </CopyButton>
        </div>
        <div
          ref={stage}
          data-slot="playground-stage"
          data-state={
            replay && outcome
              ? 'resting'
              : work.resting && !replay
                ? 'resting'
                : playing
                  ? 'running'
                  : 'paused'
          }
          data-outcome={outcome}
          onPointerMove={(event) => hover.current?.move(event, playing && interactive ? now.push : 0)}
          onPointerLeave={() => hover.current?.leave()}
          className="relative isolate h-96 overflow-clip bg-stage contain-strict"
        >
          {chips.map(({ word, className }, chip) => (
            <div
              // biome-ignore lint/suspicious/noArrayIndexKey: words may repeat, and chips have no other name
              key={`${className} ${chip}`}
              data-chip
              onPointerDown={(event) => interactive && hands.current?.down(event, chip)}
              onPointerMove={(event) => hands.current?.move(event)}
              onPointerUp={(event) => hands.current?.letGo(event)}
              onPointerCancel={(event) => hands.current?.letGo(event)}
              onLostPointerCapture={(event) => hands.current?.letGo(event)}
              className={classes(
                'absolute top-0 left-0 flex w-max max-w-full select-none forced-colors:*:outline forced-colors:*:-outline-offset-1',
                interactive && 'cursor-grab touch-pan-y touch-pinch-zoom active:cursor-grabbing',
              )}
            >
              <span className={className}>{word}</span>
            </div>
          ))}
          {replay
            ? replay.acts.some(([, what]) => what === 'obstacle') && (
                <div data-static className={classes('absolute', obstacleClass)} />
              )
            : ready && now.obstacle && <Obstacle settings={now} change={change} />}
          {ready && !playing && work.released === 0 && (
            <p className={hint}>
              {stillMotion() ? 'Motion is off, as your system asks.' : 'Paused.'} Play drops the chips.
            </p>
          )}
          <noscript>
            <p className={hint}>The playground runs in your browser and needs JavaScript, which is off.</p>
          </noscript>
          {overlay && <canvas ref={canvas} className="pointer-events-none absolute inset-0 size-full" />}
        </div>
        <Numbers work={work} />
        <Linked linked={linked} outcome={outcome} version={version} />
        {overlay && (
          <p className="border-t px-4 py-3 text-muted-foreground text-sm">
            Chips that touch are one island and share a colour; grey with a dashed outline is asleep. Red dots
            are contact points; each line is the force there, {weightLength} px for the weight of an average
            chip. The short mark stands above a moving chip’s word as it is turned now; the dotted outline and
            mark show how the look-ahead expects it to lie.
          </p>
        )}
      </div>

      <form
        data-print="hide"
        aria-label="Settings"
        className="flex flex-col gap-5 self-start rounded-2xl border bg-panel p-5 text-sm lg:row-span-2 [@media(scripting:none)]:hidden"
      >
        <Fields settings={now} change={change} />
        <button
          type="button"
          className={button}
          onClick={() => {
            change(defaults)
            setSpeed(1)
            setOverlay(false)
            setPlaying(!stillMotion())
            setDrop(drop + 1)
          }}
        >
          Reset
        </button>
      </form>

      <div className="code min-w-0 self-start overflow-hidden rounded-2xl border bg-panel lg:col-start-1">
        <div className="flex items-center justify-between border-b py-1 pr-1.5 pl-4">
          <span className="font-mono text-muted-foreground text-xs">pile.tsx</span>
          <CopyButton />
        </div>
        <LiveCode code={codeOf(now)} />
      </div>
    </div>
  )
}

/** What becomes of the pile that the address holds. */
function Linked({
  linked,
  outcome,
  version,
}: {
  linked: ReturnType<typeof useLinkedPile>['linked']
  outcome: Outcome
  version: string
}) {
  if (typeof linked !== 'object' && linked !== 'broken') return
  return (
    <p role="status" className="border-t px-4 py-3 text-muted-foreground text-sm">
      {linked === 'broken'
        ? 'The address holds no pile that can be played, so this is a new one.'
        : outcome === 'same'
          ? `Played as it was recorded, in ${linked.steps.toLocaleString('en')} steps: the same pile to the last bit. Drop makes a new one.`
          : outcome === 'other'
            ? linked.version === version
              ? 'Played to its end, and it came out otherwise than it was recorded. That is a bug: please tell us.'
              : `Played to its end. It came out otherwise, as it was recorded with version ${linked.version}, and this is ${version}.`
            : `Plays a recorded pile of ${linked.steps.toLocaleString('en')} steps. Drop makes a new one.`}
    </p>
  )
}

function Numbers({ work }: { work: Work }) {
  // Contacts outlast their work: on a stage at rest nothing is done about them.
  const { awake, pairs, contacts, substeps, micros } = work.resting ? idle : work
  return (
    <dl className="flex flex-wrap gap-x-4 gap-y-1 border-t px-4 py-3 text-muted-foreground text-sm tabular-nums [@media(scripting:none)]:hidden">
      {Object.entries({
        'awake chips': awake,
        pairs,
        contacts,
        'sub-steps': substeps,
        'µs a step': Math.round(micros).toLocaleString('en'),
      }).map(([name, value]) => (
        <div key={name} className="flex gap-2">
          <dt>{name}</dt>
          <dd className="min-w-10 font-medium text-foreground">{value}</dd>
        </div>
      ))}
    </dl>
  )
}

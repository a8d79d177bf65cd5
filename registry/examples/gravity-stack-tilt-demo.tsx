'use client'

import { useEffect, useState } from 'react'
import { GravityStack } from '@/components/ui/gravity-stack'

const words = 'marble button bead coin shell pebble dice key stamp nut'.split(' ')

const pull = 2000
const directions = { Left: [-1, 0], Up: [0, -1], Down: [0, 1], Right: [1, 0] } as const

/** On iOS a page has to ask before it is told how the phone is held, and may do so in a tap only. */
type Asking = { requestPermission?: () => Promise<'granted' | 'denied'> }

/**
 * The pile follows the phone. Buttons do the same, and a switch turns the following off: no function needs a
 * tilt.
 */
export function GravityStackTiltDemo() {
  const [gravity, setGravity] = useState({ x: 0, y: pull })
  const [sensor, setSensor] = useState(false)
  const [following, setFollowing] = useState(false)

  useEffect(() => {
    if (!window.DeviceOrientationEvent) return
    // Who has to be asked tells nothing before: a touch screen is what iPhones and iPads have.
    if ((window.DeviceOrientationEvent as Asking).requestPermission && navigator.maxTouchPoints > 0)
      setSensor(true)
    function turn({ beta, gamma }: DeviceOrientationEvent) {
      // Without a sensor there is an event too, with nothing in it.
      if (beta === null || gamma === null) return
      setSensor(true)
      if (!following) return
      const [b, c] = [(beta * Math.PI) / 180, (gamma * Math.PI) / 180]
      const turned = ((screen.orientation?.angle ?? 0) * Math.PI) / 180
      const right = Math.cos(b) * Math.sin(c)
      const down = Math.sin(b)
      // In steps of a few degrees: a hand trembles, and the pile is to come to rest.
      const step = (share: number) => (pull * Math.round(20 * share)) / 20
      const x = step(right * Math.cos(turned) + down * Math.sin(turned))
      const y = step(down * Math.cos(turned) - right * Math.sin(turned))
      setGravity((before) => (before.x === x && before.y === y ? before : { x, y }))
    }
    window.addEventListener('deviceorientation', turn)
    return () => window.removeEventListener('deviceorientation', turn)
  }, [following])

  async function follow(yes: boolean) {
    const { requestPermission } = window.DeviceOrientationEvent as Asking
    setFollowing(
      yes && (!requestPermission || (await requestPermission().catch(() => 'denied')) === 'granted'),
    )
  }

  const button =
    'rounded-md border border-neutral-400 px-3 py-1.5 text-sm hover:bg-neutral-500/10 dark:border-neutral-600'
  return (
    <div className="flex flex-col">
      <div className="flex flex-wrap items-center gap-2 p-4 motion-reduce:hidden">
        {Object.entries(directions).map(([name, [x, y]]) => (
          <button
            key={name}
            type="button"
            className={button}
            onClick={() => {
              setFollowing(false)
              setGravity({ x: pull * x, y: pull * y })
            }}
          >
            {name}
          </button>
        ))}
        {sensor && (
          <button
            type="button"
            role="switch"
            aria-checked={following}
            className={`${button} ml-auto aria-checked:bg-neutral-900 aria-checked:text-neutral-50 dark:aria-checked:bg-neutral-100 dark:aria-checked:text-neutral-950`}
            onClick={() => follow(!following)}
          >
            Follow the phone
          </button>
        )}
      </div>
      <GravityStack className="h-72" gravity={gravity} ceiling>
        {words.map((word) => (
          <span
            key={word}
            className="rounded-full bg-violet-300 px-4 py-2 font-medium text-sm text-violet-950"
          >
            {word}
          </span>
        ))}
      </GravityStack>
    </div>
  )
}

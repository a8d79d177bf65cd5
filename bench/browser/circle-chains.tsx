import { cancelFrame, frame } from 'motion'
import * as React from 'react'
import { ANGULAR_DAMPING, LINEAR_DAMPING } from '../../registry/gravity-stack/solver/constants'
import { releasePose } from '../../registry/gravity-stack/stage/release'
import { conditions, frame as frameSeconds, numbersPerChip } from '../../scenes/scene'
import { circleChains } from '../engines/circle-chains'
import { Field, type StageProps } from './chips'

const damped = { ...conditions, linearDamping: LINEAR_DAMPING, angularDamping: ANGULAR_DAMPING }

/**
 * The method of the component's first design. Its loop runs from mount on and draws every chip in each frame.
 */
export default function Stage({ chips, stagger, width, height }: StageProps) {
  const root = React.useRef<HTMLDivElement>(null)
  React.useEffect(() => {
    const elements = [...root.current!.children] as HTMLElement[]
    const sizes = elements.map((element) => ({ width: element.offsetWidth, height: element.offsetHeight }))
    const run = circleChains.start({ width, height, conditions: damped }, [], circleChains.settings[0])
    const poses = new Float64Array(chips * numbersPerChip)
    let released = 0
    let clock = 0
    let due = 0
    let seen = false
    const observer = new IntersectionObserver(
      ([entry]) => {
        seen ||= entry.isIntersecting
      },
      { threshold: 0.25 },
    )
    observer.observe(root.current!)
    const tick = ({ delta }: { delta: number }) => {
      if (!seen) return
      const seconds = Math.min(delta, 50) / 1000
      clock += seconds
      while (released < chips && (released * stagger) / 1000 <= clock) {
        const { width: w, height: h } = sizes[released]
        run.add({ ...sizes[released], ...releasePose(released, w, h, width, conditions.gravity, []) })
        released++
      }
      for (due += seconds; due >= frameSeconds; due -= frameSeconds) run.step()
      run.read(poses)
      for (let i = 0; i < released; i++) {
        const k = i * numbersPerChip
        const x = poses[k] - sizes[i].width / 2
        const y = poses[k + 1] - sizes[i].height / 2
        elements[i].style.transform = `translate3d(${x}px, ${y}px, 0) rotate(${poses[k + 2]}rad)`
      }
    }
    frame.update(tick, true)
    return () => {
      observer.disconnect()
      cancelFrame(tick)
    }
  }, [chips, stagger, width, height])
  return <Field ref={root} chips={chips} width={width} height={height} />
}

import { GravityStack } from '@/components/ui/gravity-stack'

const words = 'hopes kites larks steam smoke sparks balloons bubbles prices'.split(' ')

const up = { x: 0, y: -900 }

/** Gravity that points up: the pile rests under the top, which `ceiling` closes for what has come in. */
export function GravityStackRisingDemo() {
  return (
    <GravityStack className="h-72" gravity={up} ceiling bounce={0.3}>
      {words.map((word) => (
        <span key={word} className="rounded-full bg-sky-200 px-5 py-2.5 font-medium text-sky-950 text-sm">
          {word}
        </span>
      ))}
    </GravityStack>
  )
}

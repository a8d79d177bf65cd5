import { GravityStack } from '@/components/ui/gravity-stack'

const words = [
  'Sketch',
  'Wireframe',
  'Prototype',
  'User test',
  'Copy',
  'Motion',
  'Handoff',
  'Launch',
  'Retro',
]

export function GravityStackDemo() {
  return (
    <GravityStack className="h-80">
      {words.map((word) => (
        <span
          key={word}
          className="rounded-full bg-neutral-900 px-4 py-2 font-medium text-sm text-white dark:bg-neutral-100 dark:text-neutral-900"
        >
          {word}
        </span>
      ))}
    </GravityStack>
  )
}

import { GravityStack } from '@/components/ui/gravity-stack'

// The higher the step, the nearer the light: no tint, only a lighter surface and a longer shadow.
const steps = [
  'bg-elevation-1 shadow-raised-1',
  'bg-elevation-2 shadow-raised-2',
  'bg-elevation-3 shadow-raised-3',
  'bg-elevation-4 shadow-raised-4',
]

const words = [
  'Paper',
  'Plaster',
  'Linen',
  'Felt',
  'Cork',
  'Porcelain',
  'Chalk',
  'Birch',
  'Limestone',
  'Wool',
]

export function GravityStackElevationDemo() {
  return (
    <GravityStack className="h-80">
      {words.map((word, index) => (
        <span
          key={word}
          className={`rounded-full px-4 py-2 font-medium text-neutral-800 text-sm transition-shadow duration-300 dark:text-neutral-100 ${steps[index % steps.length]}`}
        >
          {word}
        </span>
      ))}
    </GravityStack>
  )
}

import { GravityStack } from '@/components/ui/gravity-stack'

const words = `Sketch Wireframe Prototype Interview Copy Motion Handoff Launch Retro
Persona Grid Type Icon Token Audit Draft Merge Ship`.split(/\s/)

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

import { GravityStack } from '@/components/ui/gravity-stack'

const words = 'flour sugar salt rice oats beans lentils honey coffee tea cocoa pepper'.split(' ')

/**
 * A child with `data-static` is an obstacle: it stays where its own classes put it, turned as they turn it.
 */
export function GravityStackShelvesDemo() {
  const plank = 'absolute h-3 w-2/5 rounded-full bg-stone-500 dark:bg-stone-400'
  return (
    <GravityStack className="h-96" stagger={200}>
      <div data-static className={`${plank} top-24 left-[8%] rotate-12`} />
      <div data-static className={`${plank} top-44 right-[8%] -rotate-12`} />
      <div data-static className={`${plank} top-64 left-[8%] rotate-12`} />
      {words.map((word) => (
        <span key={word} className="rounded-full bg-amber-200 px-4 py-2 font-medium text-amber-950 text-sm">
          {word}
        </span>
      ))}
    </GravityStack>
  )
}

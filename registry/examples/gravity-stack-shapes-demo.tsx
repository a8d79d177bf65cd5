import { GravityStack } from '@/components/ui/gravity-stack'

const colours = ['bg-orange-300', 'bg-teal-300', 'bg-yellow-200', 'bg-fuchsia-300', 'bg-sky-300']

const shapes: [name: string, shape: string][] = [
  ['a pill', 'rounded-full px-6 py-2'],
  ['a card', 'rounded-2xl px-5 py-6'],
  ['a box', 'px-5 py-3'],
  ['o', 'size-14 rounded-full'],
  ['a long, long pill', 'rounded-full px-8 py-2'],
  ['tall', 'rounded-lg px-3 py-10'],
  ['O', 'size-20 rounded-full text-2xl'],
  ['a square', 'size-24 rounded-md'],
  ['tiny', 'rounded px-2 py-0.5 text-xs'],
  ['a plate', 'rounded-sm px-16 py-1'],
]

/** Every child collides as the shape it is drawn in: its box, with its corner radius. */
export function GravityStackShapesDemo() {
  return (
    <GravityStack className="h-80">
      {shapes.map(([name, shape], index) => (
        <span
          key={name}
          className={`grid place-items-center font-medium text-neutral-950 text-sm ${colours[index % colours.length]} ${shape}`}
        >
          {name}
        </span>
      ))}
    </GravityStack>
  )
}

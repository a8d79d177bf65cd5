import { GravityStack } from '@/components/ui/gravity-stack'

const words = 'leaf twig acorn moss fern seed cone bark petal root bud thorn'.split(' ')

/** `push` is the radius, in px, of what a moving mouse shoves chips aside with. Fingers drag as ever. */
export function GravityStackPushDemo() {
  return (
    <GravityStack className="h-80" push={44}>
      {words.map((word) => (
        <span key={word} className="rounded-xl bg-lime-200 px-4 py-2 font-medium text-lime-950 text-sm">
          {word}
        </span>
      ))}
    </GravityStack>
  )
}

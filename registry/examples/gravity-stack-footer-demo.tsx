import { GravityStack } from '@/components/ui/gravity-stack'

const words = 'Thanks for reading all the way down here'.split(' ')

/** As wide as the page: the floor is the page's end. Long words and short ones pile up by themselves. */
export function GravityStackFooterDemo() {
  return (
    <footer className="w-full bg-neutral-950 text-neutral-100">
      <p className="border-neutral-800 border-b px-6 py-4 text-neutral-300 text-sm">
        © Your company, all rights tossed
      </p>
      <GravityStack className="h-72" gravity={1800} bounce={0.3}>
        {words.map((word, index) => (
          <span
            key={word}
            className={`rounded-2xl px-6 py-3 font-semibold text-2xl ${
              index % 3 === 1 ? 'bg-yellow-300 text-neutral-950' : 'bg-neutral-100 text-neutral-950'
            }`}
          >
            {word}
          </span>
        ))}
      </GravityStack>
    </footer>
  )
}

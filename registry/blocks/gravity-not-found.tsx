import { GravityStack } from '@/components/ui/gravity-stack'

const digits = ['4', '0', '4']
const words = ['This', 'page', 'fell', 'off', 'the', 'shelf']

/**
 * A page for addresses that lead nowhere. Put your own links in. The pile is decoration and reads as one
 * sentence.
 */
export function GravityNotFound() {
  return (
    <main className="relative isolate flex min-h-[36rem] flex-col bg-white text-neutral-950 dark:bg-neutral-950 dark:text-neutral-50">
      <div className="px-6 pt-16 text-center sm:pt-20">
        <h1 className="text-balance font-semibold text-3xl tracking-tight sm:text-5xl">
          We can’t find that page
        </h1>
        <p className="mx-auto mt-4 max-w-md text-pretty text-neutral-600 dark:text-neutral-400">
          The link may be old, or a letter of it got lost. Nothing is broken on your side.
        </p>
        <p className="mt-6 flex flex-wrap justify-center gap-3">
          <a
            href="/"
            className="rounded-full bg-neutral-950 px-5 py-2.5 font-medium text-sm text-white hover:bg-neutral-800 dark:bg-white dark:text-neutral-950 dark:hover:bg-neutral-200"
          >
            Back to the start
          </a>
          <a
            href="/contact"
            className="rounded-full border border-neutral-300 px-5 py-2.5 font-medium text-sm hover:bg-neutral-100 dark:border-neutral-700 dark:hover:bg-neutral-900"
          >
            Tell us about it
          </a>
        </p>
      </div>
      <GravityStack className="mt-auto h-72" bounce={0.35} stagger={110}>
        {digits.map((digit, index) => (
          <span
            // biome-ignore lint/suspicious/noArrayIndexKey: two of them are the same
            key={index}
            className="grid size-24 place-items-center rounded-3xl bg-amber-300 font-bold text-6xl text-amber-950 sm:size-28 sm:text-7xl"
          >
            {digit}
          </span>
        ))}
        {words.map((word) => (
          <span
            key={word}
            className="rounded-full bg-neutral-900 px-4 py-2 font-medium text-white dark:bg-neutral-100 dark:text-neutral-900"
          >
            {word}
          </span>
        ))}
      </GravityStack>
    </main>
  )
}

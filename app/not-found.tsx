import type { Metadata } from 'next'
import { LostWords } from '@/components/lost-words'

export const metadata: Metadata = { title: 'Page not found' }

const words = ['This', 'page', 'fell', 'down', 'and', 'nobody', 'picked', 'it', 'up.']

export default function NotFound() {
  return (
    <main id="content" className="mx-auto flex w-full max-w-[80rem] flex-1 flex-col px-4 py-6 sm:px-6">
      <div className="relative flex min-h-[32rem] flex-1 flex-col items-center overflow-hidden rounded-t-3xl border bg-stage pt-16 text-center">
        <div>
          <h1 className="font-semibold text-4xl tracking-[-0.03em] sm:text-5xl">Page not found</h1>
          <p className="mt-4 text-muted-foreground">
            Try{' '}
            <a href="/docs/gravity-stack" className="underline underline-offset-4">
              the docs
            </a>{' '}
            or go{' '}
            <a href="/" className="underline underline-offset-4">
              home
            </a>
            .
          </p>
        </div>
        <LostWords className="pointer-events-none absolute inset-0 h-full *:pointer-events-auto">
          {words.map((word) => (
            <span
              key={word}
              className="rounded-2xl bg-foreground px-5 py-3 font-semibold text-2xl text-background sm:px-7 sm:py-4 sm:text-4xl"
            >
              {word}
            </span>
          ))}
        </LostWords>
      </div>
    </main>
  )
}

import type { Metadata } from 'next'
import { LiveFigure } from '@/components/lab'
import { Site } from '@/components/site'
import { at } from '@/lib/address'

export const metadata: Metadata = { title: 'Page not found' }

export default function NotFound() {
  return (
    <Site>
      <main id="content" className="mx-auto flex w-full max-w-[88rem] flex-1 flex-col px-4 pt-6 sm:px-6">
        <div className="relative flex min-h-[32rem] flex-1 flex-col items-center overflow-hidden rounded-t-3xl border border-b-0 bg-stage pt-16 text-center max-[16rem]:min-h-[48rem]">
          <div>
            <h1 className="font-semibold text-4xl tracking-[-0.03em] sm:text-5xl">Page not found</h1>
            <p className="mt-4 text-muted-foreground">
              Try{' '}
              <a href={at('/docs/gravity-stack')} className="underline underline-offset-4">
                the docs
              </a>{' '}
              or go{' '}
              <a href={at('/')} className="underline underline-offset-4">
                home
              </a>
              .
            </p>
          </div>
          <LiveFigure from="lost" name="words" />
        </div>
      </main>
    </Site>
  )
}

import './globals.css'
import type { Metadata, Viewport } from 'next'
import type { ReactNode } from 'react'
import { at } from '@/lib/address'
import { mono, sans } from '@/lib/fonts'
import { grounds, preferencesScript } from '@/lib/preferences'
import { siteUrl } from '@/site.config.mjs'

export const metadata: Metadata = {
  metadataBase: new URL(siteUrl),
  title: { default: 'Gravity Stack: words with weight, for React', template: '%s · Gravity Stack' },
  description:
    'A React component whose children drop in, tumble and settle into a pile that people can grab and toss. Its own rigid-body solver, in the one file you copy.',
  // The address of each page, whichever it is.
  openGraph: {
    type: 'website',
    siteName: 'Gravity Stack',
    url: './',
    // As a file of the app folder it would get the folder of the site's address twice.
    images: [
      {
        url: '/opengraph-image.png',
        type: 'image/png',
        width: 1200,
        height: 630,
        alt: 'Chips with words on them have fallen into a pile under the title Words with weight',
      },
      {
        url: '/opengraph-loop.webp',
        type: 'image/webp',
        width: 600,
        height: 315,
        alt: 'Chips with words on them fall into a pile under the title Words with weight',
      },
    ],
  },
}

export const viewport: Viewport = {
  themeColor: [
    { media: '(prefers-color-scheme: light)', color: grounds.light },
    { media: '(prefers-color-scheme: dark)', color: grounds.dark },
  ],
}

const speculationRules = JSON.stringify({
  prefetch: [
    {
      where: { and: [{ href_matches: at('/*') }, { not: { href_matches: '/*.*' } }] },
      eagerness: 'moderate',
    },
  ],
})

export default function Layout({ children }: { children: ReactNode }) {
  return (
    // The script below sets the theme on <html> before React looks at it.
    <html lang="en" suppressHydrationWarning className={`${sans.variable} ${mono.variable}`}>
      <head>
        {/* biome-ignore lint/security/noDangerouslySetInnerHtml: our own, before the first paint */}
        <script dangerouslySetInnerHTML={{ __html: preferencesScript }} />
        {/* Pages are plain documents: a link that someone points at is fetched before the press. */}
        <script
          type="speculationrules"
          // biome-ignore lint/security/noDangerouslySetInnerHtml: a constant of ours
          dangerouslySetInnerHTML={{ __html: speculationRules }}
        />
      </head>
      <body className="flex min-h-dvh flex-col font-sans">{children}</body>
    </html>
  )
}

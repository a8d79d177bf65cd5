'use client'

/**
 * Stands in the place of a page that React gave up on. It needs no styles of the site, which may be missing.
 */
export default function GlobalError() {
  return (
    <html lang="en">
      <body style={{ colorScheme: 'light dark', font: '1rem/1.6 system-ui', padding: '20vh 10vw' }}>
        <h1>This page can’t be shown</h1>
        <p>
          <button type="button" onClick={() => location.reload()}>
            Reload it
          </button>
        </p>
      </body>
    </html>
  )
}

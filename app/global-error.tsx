'use client'

/** Stands in for a page that broke at its root. Next's own would add its script to every page. */
export default function GlobalError() {
  return (
    <html lang="en">
      <body>
        <h1>This page broke</h1>
        <button type="button" onClick={() => location.reload()}>
          Load it again
        </button>
      </body>
    </html>
  )
}

'use client'

import { Fragment } from 'react'

// Enough of TSX to colour what the playground writes; the docs' own code is highlighted at build time.
const token =
  /(?<string>'(?:[^'\\]|\\.)*'|"[^"]*"|`[^`]*`)|(?<comment>\/\/.*)|(?<keyword>\b(?:import|from|export|function|return|const|type)\b)|(?<constant>\b\d+(?:\.\d+)?\b|<\/?[A-Za-z]+|\/?>)|(?<function>\b[a-zA-Z]+(?=[=(]))/g

export function LiveCode({ code }: { code: string }) {
  const parts = []
  let at = 0
  for (const match of code.matchAll(token)) {
    const kind = Object.entries(match.groups!).find(([, text]) => text !== undefined)![0]
    parts.push(<Fragment key={`before ${match.index}`}>{code.slice(at, match.index)}</Fragment>)
    parts.push(
      <span key={match.index} className={`token-${kind}`}>
        {match[0]}
      </span>,
    )
    at = match.index + match[0].length
  }
  parts.push(code.slice(at))
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: a block that scrolls must be reachable
    <pre tabIndex={0}>
      <code>{parts}</code>
    </pre>
  )
}

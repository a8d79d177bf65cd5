import { at } from '@/lib/address'
import { neighbours } from '@/lib/docs'

/** The pages before and after this one, in the order of the navigation. */
export function PageEnd({ path }: { path: string }) {
  const { previous, next } = neighbours(path)
  return (
    <nav
      data-print="hide"
      aria-label="Previous and next"
      className="mt-20 flex flex-wrap justify-between gap-4 border-t pt-6"
    >
      {previous ? <Neighbour word="Previous" {...previous} /> : <span />}
      {next && <Neighbour word="Next" {...next} className="text-right" />}
    </nav>
  )
}

function Neighbour({
  word,
  title,
  href,
  className = '',
}: {
  word: string
  title: string
  href: string
  className?: string
}) {
  return (
    <a
      href={at(href)}
      className={`group -mx-3 rounded-lg px-3 py-2 transition-colors hover:bg-muted ${className}`}
    >
      <span className="block text-muted-foreground text-sm">{word}</span>
      <span className="font-medium">{title}</span>
    </a>
  )
}

import { openInV0 } from '@/lib/elsewhere'

/** A link to v0 with an item of the registry in it. */
export function OpenInV0({ name }: { name: string }) {
  return (
    <a
      data-plain
      data-print="hide"
      href={openInV0(name)}
      className="rounded-md border bg-panel px-3 py-1 text-muted-foreground text-sm transition-colors hover:text-foreground"
    >
      Open in v0
    </a>
  )
}

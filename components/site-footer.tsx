import { at } from '@/lib/address'

const links = [
  ['/docs/setup', 'Setup'],
  ['/docs', 'Docs'],
  ['/playground', 'Playground'],
  ['/benchmarks', 'Benchmarks'],
  ['/r/registry.json', 'Registry'],
]

export function SiteFooter() {
  return (
    <footer data-print="hide" className="border-t">
      <div className="mx-auto flex max-w-[88rem] flex-wrap items-center justify-between gap-x-8 gap-y-3 px-4 py-8 text-muted-foreground text-sm sm:px-6">
        <p>Gravity Stack, a component of liten. MIT licensed.</p>
        <ul className="flex flex-wrap gap-x-6 gap-y-2">
          {links.map(([href, title]) => (
            <li key={href}>
              <a href={at(href)} className="hover:text-foreground">
                {title}
              </a>
            </li>
          ))}
        </ul>
      </div>
    </footer>
  )
}

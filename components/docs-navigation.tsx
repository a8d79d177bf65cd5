import { at } from '@/lib/address'

type Navigation = { title: string; pages: { title: string; href: string }[] }[]

/** The pages of the docs by section; the one at `path` is marked. */
export function DocsNavigation({ sections, path }: { sections: Navigation; path?: string }) {
  return (
    <ul className="space-y-7 text-sm">
      {sections.map((section) => (
        <li key={section.title}>
          <p className="px-3 font-medium text-muted-foreground text-xs">{section.title}</p>
          <ul className="mt-2 space-y-0.5">
            {section.pages.map((page) => (
              <li key={page.href}>
                <a
                  href={at(page.href)}
                  aria-current={path === page.href ? 'page' : undefined}
                  className="block rounded-md px-3 py-1.5 -outline-offset-2 text-muted-foreground transition-colors hover:text-foreground aria-[current]:bg-muted aria-[current]:font-medium aria-[current]:text-foreground"
                >
                  {page.title}
                </a>
              </li>
            ))}
          </ul>
        </li>
      ))}
    </ul>
  )
}

import { at } from '@/lib/address'
import { navigation } from '@/lib/docs'
import { DocsNavigation } from './docs-navigation'
import { MenuIcon, MoonIcon, SunIcon } from './icons'
import { MobileNavigation } from './mobile-navigation'
import { Search } from './search'
import { ThemeToggle } from './theme-toggle'
import { Mark } from './wordmark'

const links = [
  { title: 'Docs', href: '/docs/gravity-stack' },
  { title: 'Blocks', href: '/blocks' },
  { title: 'Playground', href: '/playground' },
  { title: 'Benchmarks', href: '/benchmarks' },
  { title: 'How it works', href: '/docs/how-it-works' },
]

/**
 * The layout doesn't know which page it holds, and a component that does would bring its script to every
 * page. On a page of the docs without a link of its own Docs is marked.
 */
const markCurrent = `(() => {
  const links = [...document.currentScript.previousElementSibling.querySelectorAll('a')]
  const path = location.pathname
  const page = links.find((link) => link.pathname === path)
  if (page) page.setAttribute('aria-current', 'page')
  else if (path.startsWith('${at('/docs')}')) links[0].setAttribute('aria-current', 'true')
})()`

export function SiteHeader() {
  return (
    <header data-print="hide" className="sticky top-0 z-40 border-b bg-background/90 backdrop-blur">
      <a
        href="#content"
        className="-translate-y-16 absolute top-2 left-2 z-50 rounded-md bg-foreground px-3 py-2 text-background text-sm focus:translate-y-0"
      >
        Skip to content
      </a>
      <div className="mx-auto flex h-14 max-w-[88rem] items-center gap-1 px-4 sm:px-6">
        <a href={at('/')} className="flex min-w-0 sm:mr-4 items-center gap-2.5 font-semibold tracking-tight">
          <Mark className="size-6 shrink-0" />
          <span className="truncate">Gravity Stack</span>
        </a>
        <nav aria-label="Main" className="hidden md:flex lg:gap-1">
          {links.map((link) => (
            <a
              key={link.href}
              href={at(link.href)}
              // The script below marks one before React looks at it.
              suppressHydrationWarning
              className="whitespace-nowrap rounded-md px-2 py-1.5 lg:px-3 text-muted-foreground text-sm transition-colors hover:text-foreground aria-[current]:bg-muted aria-[current]:text-foreground"
            >
              {link.title}
            </a>
          ))}
        </nav>
        {/* biome-ignore lint/security/noDangerouslySetInnerHtml: a constant of ours */}
        <script dangerouslySetInnerHTML={{ __html: markCurrent }} />
        <div className="ml-auto flex items-center gap-1">
          <Search />
          <ThemeToggle>
            <SunIcon className="dark:hidden" />
            <MoonIcon className="hidden dark:block" />
          </ThemeToggle>
          <MobileNavigation icon={<MenuIcon />}>
            <DocsNavigation sections={navigation} />
          </MobileNavigation>
        </div>
      </div>
    </header>
  )
}

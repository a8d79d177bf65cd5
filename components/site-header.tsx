import { navigation } from '@/lib/docs'
import { DocsNavigation } from './docs-navigation'
import { MenuIcon, MoonIcon, SunIcon } from './icons'
import { MobileNavigation } from './mobile-navigation'
import { ThemeToggle } from './theme-toggle'
import { Mark } from './wordmark'

const links = [
  { title: 'Docs', href: '/docs/gravity-stack' },
  { title: 'Playground', href: '/playground' },
  { title: 'Benchmarks', href: '/benchmarks' },
  { title: 'How it works', href: '/docs/how-it-works' },
]

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
        <a href="/" className="mr-4 flex items-center gap-2.5 font-semibold tracking-tight">
          <Mark className="size-6" />
          Gravity Stack
        </a>
        <nav aria-label="Main" className="hidden gap-1 sm:flex">
          {links.map((link) => (
            <a
              key={link.href}
              href={link.href}
              className="rounded-md px-3 py-1.5 text-muted-foreground text-sm transition-colors hover:text-foreground"
            >
              {link.title}
            </a>
          ))}
        </nav>
        <div className="ml-auto flex items-center gap-1">
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

export function SiteFooter() {
  return (
    <footer data-print="hide" className="border-t">
      <div className="mx-auto flex max-w-[88rem] flex-wrap items-center justify-between gap-x-8 gap-y-3 px-4 py-8 text-muted-foreground text-sm sm:px-6">
        <p>Gravity Stack, a component of liten. MIT licensed.</p>
        <ul className="flex flex-wrap gap-x-6 gap-y-2">
          <li>
            <a href="/docs/setup" className="hover:text-foreground">
              Setup
            </a>
          </li>
          <li>
            <a href="/docs" className="hover:text-foreground">
              Docs
            </a>
          </li>
          <li>
            <a href="/playground" className="hover:text-foreground">
              Playground
            </a>
          </li>
          <li>
            <a href="/benchmarks" className="hover:text-foreground">
              Benchmarks
            </a>
          </li>
          <li>
            <a href="/r/registry.json" className="hover:text-foreground">
              Registry
            </a>
          </li>
        </ul>
      </div>
    </footer>
  )
}

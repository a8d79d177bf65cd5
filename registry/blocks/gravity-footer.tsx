import { GravityStack } from '@/components/ui/gravity-stack'

const columns = {
  Product: ['Features', 'Pricing', 'Changelog', 'Status'],
  Company: ['About', 'Careers', 'Press', 'Contact'],
  Legal: ['Privacy', 'Terms', 'Imprint'],
}

const words = ['Made', 'with', 'care', 'in', 'Lisbon,', 'Oslo', 'and', 'a', 'few', 'kitchens']
const tints = [
  'bg-lime-300 text-lime-950',
  'bg-neutral-100 text-neutral-950',
  'bg-violet-300 text-violet-950',
  'bg-neutral-700 text-neutral-50',
]

/** The end of a page: links first, then a line of words that piles up on the floor of the site. */
export function GravityFooter() {
  return (
    <footer className="flex flex-col bg-neutral-950 text-neutral-50">
      <div className="mx-auto flex w-full max-w-6xl flex-wrap justify-between gap-10 px-6 pt-14">
        <div className="max-w-xs">
          <p className="font-semibold text-lg tracking-tight">Northwind Studio</p>
          <p className="mt-2 text-pretty text-neutral-400 text-sm">
            Tools for people who plan things with other people.
          </p>
        </div>
        <nav aria-label="Footer" className="flex flex-wrap gap-x-14 gap-y-8">
          {Object.entries(columns).map(([title, links]) => (
            <div key={title}>
              <p className="font-medium text-sm">{title}</p>
              <ul className="mt-3 space-y-2 text-neutral-400 text-sm">
                {links.map((link) => (
                  <li key={link}>
                    <a href={`/${link.toLowerCase()}`} className="hover:text-white">
                      {link}
                    </a>
                  </li>
                ))}
              </ul>
            </div>
          ))}
        </nav>
      </div>
      <p className="mx-auto w-full max-w-6xl px-6 pt-10 text-neutral-400 text-sm">© Northwind Studio</p>
      <GravityStack className="mt-auto h-64 shrink-0" gravity={2000} bounce={0.3} stagger={90}>
        {words.map((word, index) => (
          <span
            key={word}
            className={`rounded-2xl px-5 py-2.5 font-semibold text-xl ${tints[index % tints.length]}`}
          >
            {word}
          </span>
        ))}
      </GravityStack>
    </footer>
  )
}

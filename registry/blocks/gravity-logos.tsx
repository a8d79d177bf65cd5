import type { ReactNode } from 'react'
import { GravityStack } from '@/components/ui/gravity-stack'

const disc = 'grid size-20 place-items-center rounded-full'
const plate = 'flex items-center gap-2.5 rounded-2xl px-6 py-4 font-semibold text-lg tracking-tight'

const paper =
  'bg-white text-neutral-900 ring-1 ring-neutral-200 dark:bg-neutral-800 dark:text-neutral-50 dark:ring-neutral-700'

const mark = (shape: ReactNode) => (
  <svg aria-hidden="true" viewBox="0 0 32 32" className="size-8 fill-current">
    {shape}
  </svg>
)

/** Names of customers: those with a wordmark on a plate, the others on a disc. Put your own marks in. */
const customers: { name: string; colours: string; logo: ReactNode; words?: boolean }[] = [
  { name: 'Halden', colours: paper, words: true, logo: mark(<path d="M4 28V4h7v9h10V4h7v24h-7v-9H11v9z" />) },
  {
    name: 'Orbit',
    colours: 'bg-indigo-600 text-white',
    logo: mark(<path d="M16 2a14 14 0 1 0 14 14h-8a6 6 0 1 1-6-6z" />),
  },
  {
    name: 'Fernweh',
    colours: 'bg-emerald-700 text-white',
    words: true,
    logo: mark(<path d="M16 2c9 6 9 18 0 28C7 20 7 8 16 2z" />),
  },
  { name: 'Kilnworks', colours: 'bg-orange-500 text-orange-950', logo: mark(<path d="M16 2 30 28H2z" />) },
  {
    name: 'Salt & Pine',
    colours: paper,
    words: true,
    logo: mark(<path d="m16 2 8 11h-4l8 11H18v6h-4v-6H4l8-11H8z" />),
  },
  {
    name: 'Tidewater',
    colours: 'bg-cyan-300 text-cyan-950',
    logo: mark(<path d="M2 12q7-8 14 0t14 0v7q-7 8-14 0T2 19z" />),
  },
  {
    name: 'Maison Vert',
    colours: 'bg-lime-300 text-lime-950',
    words: true,
    logo: mark(<path d="M16 3 30 14v15H20v-9h-8v9H2V14z" />),
  },
  {
    name: 'Quarter',
    colours: paper,
    logo: mark(
      <path d="M4 4h11v11H4zM17 4a11 11 0 0 1 11 11H17zM4 17h11v11A11 11 0 0 1 4 17zM17 17h11v11H17z" />,
    ),
  },
  {
    name: 'Bluebird',
    colours: 'bg-blue-600 text-white',
    words: true,
    logo: mark(<path d="M2 16c8 0 10-10 16-10 5 0 6 3 12 3-3 3-3 17-14 17-6 0-8-2-14-10z" />),
  },
  {
    name: 'Pico',
    colours: 'bg-neutral-900 text-white dark:bg-white dark:text-neutral-900',
    logo: mark(<circle cx="16" cy="16" r="9" />),
  },
]

/** A wall of logos that came down: discs roll, plates slide. */
export function GravityLogos() {
  return (
    <section
      aria-labelledby="customers"
      className="flex flex-col bg-neutral-50 pt-14 text-neutral-950 dark:bg-neutral-950 dark:text-neutral-50"
    >
      <div className="px-6 pb-4 text-center">
        <h2 id="customers" className="text-balance font-semibold text-3xl tracking-tight">
          Teams that plan with us
        </h2>
        <p className="mt-3 text-neutral-600 dark:text-neutral-400">Studios, ferries, bakeries and a bank.</p>
      </div>
      <GravityStack className="mt-auto h-96 shrink-0" bounce={0.25} stagger={120}>
        {customers.map(({ name, colours, logo, words }) =>
          words ? (
            <span key={name} className={`${plate} ${colours}`}>
              {logo}
              {name}
            </span>
          ) : (
            <span key={name} role="img" aria-label={name} className={`${disc} ${colours}`}>
              {logo}
            </span>
          ),
        )}
      </GravityStack>
    </section>
  )
}

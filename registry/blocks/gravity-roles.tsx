import { GravityStack } from '@/components/ui/gravity-stack'

const roles: [role: string, place: string, colours: string][] = [
  ['Product designer', 'Lisbon or remote', 'bg-rose-300 text-rose-950'],
  ['Frontend engineer', 'Remote, UTC ±3', 'bg-sky-300 text-sky-950'],
  ['Support lead', 'Oslo', 'bg-amber-300 text-amber-950'],
  ['Data analyst', 'Lisbon', 'bg-emerald-300 text-emerald-950'],
  ['Office cook', 'Oslo, four days', 'bg-violet-300 text-violet-950'],
  ['Technical writer', 'Remote', 'bg-orange-300 text-orange-950'],
]

const href = (role: string) => `/careers/${role.toLowerCase().replaceAll(' ', '-')}`

/**
 * Jobs as cards to rummage in: a press follows the link, a drag tosses the card. A list below has them all.
 */
export function GravityRoles() {
  return (
    <section
      aria-labelledby="roles"
      className="bg-neutral-50 text-neutral-950 dark:bg-neutral-950 dark:text-neutral-50"
    >
      <div className="mx-auto max-w-5xl px-6 pt-14">
        <h2 id="roles" className="text-balance font-semibold text-3xl tracking-tight sm:text-4xl">
          Six chairs are empty
        </h2>
        <p className="mt-3 max-w-xl text-pretty text-neutral-600 dark:text-neutral-400">
          We are twenty-four people who make planning tools. Dig through what we need.
        </p>
        <GravityStack
          className="mt-6 h-[30rem] rounded-3xl bg-neutral-200/60 sm:h-96 dark:bg-neutral-900"
          stagger={140}
        >
          {roles.map(([role, place, colours]) => (
            <a
              key={role}
              href={href(role)}
              className={`rounded-2xl px-5 py-4 focus-visible:-outline-offset-4 ${colours}`}
            >
              <span className="block font-semibold text-lg leading-tight">{role}</span>
              <span className="mt-1 block text-sm">{place}</span>
            </a>
          ))}
        </GravityStack>
        <p className="pt-6 pb-14 text-neutral-600 text-sm dark:text-neutral-400">
          Nothing for you in the pile?{' '}
          <a
            href="/careers"
            className="font-medium text-neutral-950 underline underline-offset-4 dark:text-white"
          >
            Write to us anyway
          </a>
        </p>
      </div>
    </section>
  )
}

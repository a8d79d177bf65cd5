import { GravityStack } from '@/components/ui/gravity-stack'

const skills = {
  Design: ['Interfaces', 'Type', 'Prototypes', 'Design tokens', 'Illustration'],
  Code: ['TypeScript', 'React', 'CSS', 'Web audio', 'SVG'],
  Craft: ['Workshops', 'Writing', 'Mentoring', 'Research'],
}

const tints = {
  Design: 'bg-rose-200 text-rose-950',
  Code: 'bg-sky-200 text-sky-950',
  Craft: 'bg-amber-200 text-amber-950',
}

const groups = Object.entries(skills) as [keyof typeof skills, string[]][]

/** Skills, for a portfolio. Words in a pile lie at an angle, so the list beside it shows them level. */
export function GravitySkills() {
  return (
    <section
      aria-labelledby="skills"
      className="bg-white text-neutral-950 dark:bg-neutral-950 dark:text-neutral-50"
    >
      <div className="mx-auto grid max-w-6xl gap-8 px-6 py-14 lg:grid-cols-[20rem_minmax(0,1fr)] lg:gap-14">
        <div>
          <h2 id="skills" className="font-semibold text-3xl tracking-tight">
            What I’m good at
          </h2>
          <dl className="mt-6 space-y-4 text-sm">
            {groups.map(([group, names]) => (
              <div key={group}>
                <dt className="flex items-center gap-2 font-medium">
                  <span aria-hidden="true" className={`size-3 rounded-full ${tints[group]}`} />
                  {group}
                </dt>
                <dd className="mt-1 text-pretty text-neutral-600 dark:text-neutral-400">
                  {names.join(', ')}
                </dd>
              </div>
            ))}
          </dl>
        </div>
        {/* The list has said it all. */}
        <div aria-hidden="true">
          <GravityStack className="h-96 rounded-3xl bg-neutral-100 lg:h-full lg:min-h-80 dark:bg-neutral-900">
            {groups.flatMap(([group, names]) =>
              names.map((name) => (
                <span key={name} className={`rounded-full px-5 py-2.5 font-medium ${tints[group]}`}>
                  {name}
                </span>
              )),
            )}
          </GravityStack>
        </div>
      </div>
    </section>
  )
}

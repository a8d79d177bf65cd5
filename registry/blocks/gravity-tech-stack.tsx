import { GravityStack } from '@/components/ui/gravity-stack'

const layers: [layer: string, colours: string, parts: string[]][] = [
  ['Interface', 'bg-sky-950 text-sky-100 ring-sky-800', ['React', 'TypeScript', 'Tailwind CSS', 'Motion']],
  ['Server', 'bg-emerald-950 text-emerald-100 ring-emerald-800', ['Node.js', 'Next.js', 'GraphQL']],
  ['Data', 'bg-amber-950 text-amber-100 ring-amber-800', ['PostgreSQL', 'Redis', 'S3']],
  ['Ground', 'bg-fuchsia-950 text-fuchsia-100 ring-fuchsia-800', ['Docker', 'Terraform', 'GitHub Actions']],
]

/** What a product is built with, layer by layer; in the pile, heavy plates at the bottom come first. */
export function GravityTechStack() {
  return (
    <section aria-labelledby="stack" className="bg-neutral-950 text-neutral-50">
      <div className="mx-auto max-w-5xl px-6 pt-14">
        <h2 id="stack" className="font-semibold text-3xl tracking-tight sm:text-4xl">
          What holds it up
        </h2>
        <dl className="mt-6 grid gap-x-8 gap-y-4 text-sm sm:grid-cols-2 lg:grid-cols-4">
          {layers.map(([layer, , parts]) => (
            <div key={layer}>
              <dt className="font-medium">{layer}</dt>
              <dd className="mt-1 text-pretty text-neutral-400">{parts.join(', ')}</dd>
            </div>
          ))}
        </dl>
      </div>
      {/* The list has said it all. */}
      <div aria-hidden="true">
        <GravityStack className="h-80" gravity={3200} bounce={0.1} stagger={110}>
          {layers.toReversed().flatMap(([, colours, parts]) =>
            parts.map((part) => (
              <span
                key={part}
                className={`rounded-xl px-5 py-3 font-medium font-mono text-sm ring-1 ring-inset sm:px-6 sm:py-4 sm:text-base ${colours}`}
              >
                {part}
              </span>
            )),
          )}
        </GravityStack>
      </div>
    </section>
  )
}

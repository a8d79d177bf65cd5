import { ours } from '@/bench/publish/report'
import { engineOrder, looks } from '@/lib/evidence/engines'
import { results } from '@/lib/evidence/results'
import { Mark } from './plot'

/** Choosing an engine dims the others in every plot; ours stays. Nothing but CSS. */
const highlightRules = engineOrder
  .map(
    (engine) =>
      `.benchmarks:has(#show-${engine}:checked) svg [data-engine]:not([data-engine="${engine}"]):not([data-engine="${ours}"]){opacity:.12}`,
  )
  .join('')

export function Legend() {
  const measured = engineOrder.filter((engine) => results.versions[engine])
  return (
    // What scrolls by passes behind the page's ground round the box, not through its corners.
    <div className="legend sticky top-14 z-30 bg-background pt-2 print:static">
      <style>{highlightRules}</style>
      <fieldset className="flex min-w-0 gap-1 overflow-x-auto rounded-xl border bg-panel p-2 text-sm lg:flex-wrap print:flex-wrap">
        <legend className="sr-only">Show one engine beside ours</legend>
        {['all', ...measured].map((engine) => (
          <label
            key={engine}
            className="relative flex shrink-0 cursor-pointer items-center gap-2 rounded-lg px-2.5 py-1.5 has-checked:bg-muted has-focus-visible:outline-2 has-focus-visible:outline-ring"
          >
            <input
              type="radio"
              name="engine"
              id={`show-${engine}`}
              defaultChecked={engine === 'all'}
              className="sr-only"
            />
            {engine !== 'all' && (
              <svg aria-hidden="true" viewBox="-7 -7 14 14" className="size-3.5">
                <Mark engine={engine} />
              </svg>
            )}
            {engine === 'all' ? 'All' : looks[engine].title}
            {engine !== 'all' && /\d/.test(results.versions[engine]) && (
              <span className="text-muted-foreground">{results.versions[engine]}</span>
            )}
          </label>
        ))}
      </fieldset>
    </div>
  )
}

import { classes } from '@/lib/classes'

const steps = [
  'bg-elevation-0 shadow-[inset_0_0_0_1px_var(--edge-outline)]',
  'bg-elevation-1 shadow-raised-1',
  'bg-elevation-2 shadow-raised-2',
  'bg-elevation-3 shadow-raised-3',
  'bg-elevation-4 shadow-raised-4',
]

/** The five steps side by side, in both themes at once. */
export function ElevationLadder() {
  return (
    <div className="grid grid-cols-[minmax(0,1fr)] gap-4 sm:grid-cols-2">
      {(['light', 'dark'] as const).map((theme) => (
        <div
          key={theme}
          className={classes(
            theme,
            'overflow-hidden rounded-2xl border border-(--edge-outline) bg-elevation-0 px-6 pt-5 pb-8 forced-color-adjust-none [print-color-adjust:exact]',
          )}
        >
          <p className={classes('text-xs', theme === 'dark' ? 'text-neutral-300' : 'text-neutral-600')}>
            {theme}
          </p>
          <ol className="mt-4 flex flex-col gap-5">
            {steps.map((step, height) => (
              <li
                key={step}
                className={classes(
                  'rounded-full px-5 py-2.5 font-medium text-sm',
                  theme === 'dark' ? 'text-neutral-100' : 'text-neutral-800',
                  step,
                )}
              >
                Step {height}
              </li>
            ))}
          </ol>
        </div>
      ))}
    </div>
  )
}

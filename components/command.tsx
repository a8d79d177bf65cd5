import { useId } from 'react'
import { choices } from '@/lib/preferences'
import { ChoiceTabs } from './choice-tabs'
import { CopyButton } from './copy-button'

const managers = choices['package-manager'].map((value) => ({ value, label: value }))

const runners = { npm: 'npx', pnpm: 'pnpm dlx', yarn: 'yarn dlx', bun: 'bunx --bun' }
const adders = { npm: 'npm install', pnpm: 'pnpm add', yarn: 'yarn add', bun: 'bun add' }

/** A command for each package manager: `run` a package's command once, or `add` packages. */
export function Command({ run, add, label }: { run?: string; add?: string; label: string }) {
  const id = useId()

  return (
    <div className="code overflow-hidden rounded-xl border bg-panel text-left">
      <div className="flex items-center justify-between border-b py-1 pr-1.5 pl-2">
        <ChoiceTabs
          kind="package-manager"
          id={id}
          label={`Package manager, ${label}`}
          tabs={managers}
          look="quiet"
        />
        <CopyButton label="Copy command" />
      </div>
      {choices['package-manager'].map((value) => (
        <div
          key={value}
          role="tabpanel"
          id={`${id}-${value}`}
          aria-labelledby={`${id}-tab-${value}`}
          data-choice-panel={value}
        >
          {/* biome-ignore lint/a11y/noNoninteractiveTabindex: a line that scrolls must be reachable */}
          <pre tabIndex={0}>
            <code>{run ? `${runners[value]} ${run}` : `${adders[value]} ${add}`}</code>
          </pre>
        </div>
      ))}
    </div>
  )
}

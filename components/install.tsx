import type { ReactNode } from 'react'
import { ChoiceTabs } from './choice-tabs'

const ways = [
  { value: 'cli', label: 'CLI' },
  { value: 'manual', label: 'Manual' },
]

/** Two ways to install, each an `InstallWay`; the choice is remembered. Once on a page. */
export function Install({ children }: { children: ReactNode }) {
  return (
    <div>
      <div className="flex">
        <ChoiceTabs kind="install" id="install" label="Way to install" tabs={ways} />
      </div>
      {children}
    </div>
  )
}

export function InstallWay({ of, children }: { of: 'cli' | 'manual'; children: ReactNode }) {
  return (
    <div
      role="tabpanel"
      id={`install-${of}`}
      aria-labelledby={`install-tab-${of}`}
      data-choice-panel={of}
      className="prose mt-5"
    >
      <p className="hidden font-medium [@media(scripting:none)]:block">
        {of === 'cli' ? 'With the CLI:' : 'By hand:'}
      </p>
      {children}
    </div>
  )
}

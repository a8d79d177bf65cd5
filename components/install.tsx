import type { ReactNode } from 'react'
import { ChoiceTabs } from './choice-tabs'
import { OpenInV0 } from './open-in-v0'

const ways = [
  { value: 'cli', label: 'CLI' },
  { value: 'manual', label: 'Manual' },
  { value: 'prompt', label: 'Prompt' },
]

const words = { cli: 'With the CLI:', manual: 'By hand:', prompt: 'By a coding assistant:' }

/**
 * Three ways to install, each an `InstallWay`; the choice is remembered. Once on a page. `v0` names an item
 * that v0 can open.
 */
export function Install({ v0, children }: { v0?: string; children: ReactNode }) {
  return (
    <div>
      <div className="flex flex-wrap items-center justify-between gap-x-4 gap-y-2">
        <ChoiceTabs kind="install" id="install" label="Way to install" tabs={ways} />
        {v0 && <OpenInV0 name={v0} />}
      </div>
      {children}
    </div>
  )
}

export function InstallWay({ of, children }: { of: keyof typeof words; children: ReactNode }) {
  return (
    <div
      role="tabpanel"
      id={`install-${of}`}
      aria-labelledby={`install-tab-${of}`}
      data-choice-panel={of}
      className="prose mt-5"
    >
      <p className="hidden font-medium [@media(scripting:none)]:block">{words[of]}</p>
      {children}
    </div>
  )
}

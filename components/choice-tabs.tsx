'use client'

import type { ComponentProps } from 'react'
import type { Choice } from '@/lib/preferences'
import { TabList } from './tab-list'
import { useChoice } from './use-choice'

/** The tabs of a remembered choice. Its panels carry `data-choice-panel`, and CSS shows the chosen one. */
export function ChoiceTabs({
  kind,
  ...tabs
}: { kind: Choice } & Omit<ComponentProps<typeof TabList>, 'value' | 'onSelect'>) {
  const [value, choose] = useChoice(kind)
  return <TabList {...tabs} value={value} onSelect={choose} />
}

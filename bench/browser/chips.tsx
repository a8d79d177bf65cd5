import type * as React from 'react'

const WORDS =
  'design tokens motion springs layout colour type grid focus contrast states icons voice scale rhythm depth'.split(
    ' ',
  )
const TINTS = ['bg-amber-200', 'bg-emerald-200', 'bg-sky-200', 'bg-rose-200', 'bg-violet-200']

export type Look = 'pills' | 'badges' | 'mixed'

/** The classes of chip `i`. */
const looks: Record<Look, (i: number) => string> = {
  pills: () => 'rounded-full px-3 py-1',
  badges: () => 'rounded-md px-2.5 py-1',
  mixed: (i) =>
    [
      'rounded-full px-3 py-1',
      'rounded-md px-2.5 py-1',
      'grid size-10 rounded-full',
      'grid size-9',
      'h-14 w-7',
    ][i % 5],
}

/** The same pills for every stage; badges and mixed shapes where asked for. */
export const pills = (count: number, look: Look = 'pills') =>
  Array.from({ length: count }, (_, i) => i).map((i) => ({
    key: i,
    pill: (
      <span key={i} className={`block text-neutral-900 text-xs ${looks[look](i)} ${TINTS[i % TINTS.length]}`}>
        {look === 'mixed' && i % 5 > 1 ? i : WORDS[i % WORDS.length]}
      </span>
    ),
  }))

export interface StageProps {
  chips: number
  /** ms between releases. */
  stagger: number
  /** px */
  width: number
  height: number
  /** Never lets the pile rest. */
  restless: boolean
  look?: Look
  /** Plans the drop so that words end the right way up, where a stage can. */
  upright: boolean
}

/** What a stage without a component of its own starts from: chips above a box, for a script to move. */
export function Field({
  ref,
  chips,
  ...size
}: { ref: React.Ref<HTMLDivElement> } & Pick<StageProps, 'chips' | 'width' | 'height'>) {
  return (
    <div ref={ref} className="relative overflow-hidden bg-neutral-100" style={size}>
      {pills(chips).map(({ key, pill }) => (
        <div
          key={key}
          data-slot="gravity-stack-chip"
          className="absolute top-0 left-0 w-max will-change-transform"
          style={{ transform: 'translateY(-200px)' }}
        >
          {pill}
        </div>
      ))}
    </div>
  )
}
